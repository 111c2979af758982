// SPDX-License-Identifier: Apache-2.0
#include "exporters/mesh/mtl.h"

#include "exporters/numbers.h"

#include <algorithm>

namespace alidade {

namespace {

template <class... T> void statement(std::string& out, const char* word, T... values) {
    out += word;
    append_numbers(out, values...);
    out += '\n';
}

void color(std::string& out, const char* word, const Vec3& c) { statement(out, word, c.x, c.y, c.z); }

/// Head-on, of an interface with this index of refraction.
double normal_reflectance(double ior) { return (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1)); }

/// The exponent of Blinn and Phong whose highlight is as wide as that of a microfacet width of roughness^2; limited as most readers limit it.
double exponent(double roughness) { return std::min(2 / std::pow(std::max(roughness, 1e-3), 4) - 2, 1000.0); }

/// -s and -o of a map; false if it turns or shears, which MTL cannot say.
bool uv_options(const Mat3& m, std::string& out) {
    if (m[0][1] != 0 || m[1][0] != 0) return false;
    const double offset = 1 - m[1][1] - m[2][1];   // v grows upwards here
    if (m[0][0] != 1 || m[1][1] != 1) out += " -s", append_numbers(out, m[0][0], m[1][1], 1);
    if (m[2][0] != 0 || offset != 0) out += " -o", append_numbers(out, m[2][0], offset, 0);
    return true;
}

bool glows(const PlainSurface& s) { return s.emissive && s.emissive_strength > 0 && !is_black(Vec3(s.emissive->factor)); }
bool transmits(const PlainSurface& s) { return s.transmission && s.transmission->factor.x > 0; }
bool is_tinted(const PlainSurface& s) { return s.specular_color && Vec3(s.specular_color->factor) != Vec3(1); }

}  // namespace

std::string MtlLibrary::picture(ImageId id) {
    const auto [known, added] = pictures_.try_emplace(id);
    if (!added) return known->second;
    const Image& image = scene_.images[id.index];
    auto bytes = OutputFiles::read(image);
    if (bytes) known->second = files_.add_picture(image, std::move(*bytes));
    else losses_.add("pictures that cannot be read");
    return known->second;
}

void MtlLibrary::add_map(const char* statement, const std::optional<Texel>& texel, const std::string& options) {
    if (!texel || !texel->picture) return;
    const ImageSignal& signal = *texel->picture;
    const std::string file = picture(signal.image);
    if (file.empty()) return;
    std::string line = statement;
    if (!uv_options(signal.uv_transform, line)) losses_.add("rotations of texture coordinates");
    if (signal.wrap_u == Wrap::clamp && signal.wrap_v == Wrap::clamp) line += " -clamp on";
    else losses_.add("ways to continue a texture beyond its edge", signal.wrap_u != Wrap::repeat || signal.wrap_v != Wrap::repeat, "repeated");
    losses_.add("textures without interpolation", signal.filter != Filter::linear, "interpolated");
    losses_.add("textures on other than the first coordinates", signal.uv_set != 0, "the first coordinates");
    if (texel->channel >= 0) line += std::string(" -imfchan ") + "rgbm"[texel->channel];
    text_ += line + options + " " + file + "\n";
}

void MtlLibrary::add_base_color(const PlainSurface& s) {
    const Vec3 base(s.base_color.factor);
    const double alpha = std::clamp(s.base_color.factor.w, 0.0, 1.0);
    color(text_, "Kd", base);
    if (transmits(s)) {
        // The importer of MTL takes 1 - d for what goes through, and everything if d is 1.
        color(text_, "Tf", base);
        const double through = std::clamp(s.transmission->factor.x, 0.0, 1.0);
        if (through < 1) statement(text_, "d", 1 - through);
    } else if (s.alpha_mode == AlphaMode::blend) {
        statement(text_, "d", alpha);
    }
    add_map("map_Kd", s.base_color);
    if (s.alpha_mode != AlphaMode::opaque && s.base_color.picture && !transmits(s)) add_map("map_d", s.base_color);
}

void MtlLibrary::add_reflection(const PlainSurface& s) {
    const double roughness = std::clamp(s.roughness.factor.x, 0.0, 1.0);
    statement(text_, "Ns", exponent(roughness));
    statement(text_, "Pr", roughness);
    statement(text_, "Pm", std::clamp(s.metallic.factor.x, 0.0, 1.0));
    if (s.ior > 1) statement(text_, "Ni", s.ior);
    add_map("map_Pr", s.roughness);
    add_map("map_Pm", s.metallic);
    const bool dull = s.specular && s.specular->is_constant(0);
    if (dull) color(text_, "Ks", Vec3(0));
    else if (is_tinted(s)) color(text_, "Ks", Vec3(s.specular_color->factor) * normal_reflectance(s.ior > 1 ? s.ior : 1.5));
    statement(text_, "illum", transmits(s) ? 6 : dull ? 1 : is_tinted(s) ? 3 : 2);
    if (s.clearcoat) statement(text_, "Pc", s.clearcoat->factor.x);
    if (s.clearcoat_roughness) statement(text_, "Pcr", s.clearcoat_roughness->factor.x);
}

void MtlLibrary::add_losses(const PlainSurface& s) {
    losses_.add("occlusion textures", s.occlusion.has_value());
    losses_.add("alpha masks", s.alpha_mode == AlphaMode::mask, "blending");
    losses_.add("opacity beside transmission", transmits(s) && s.alpha_mode != AlphaMode::opaque);
    losses_.add("unlit materials", s.unlit, "lit ones");
    losses_.add("single-sided materials", !s.double_sided, "double-sided ones");
    losses_.add("strengths of reflections", s.specular && !s.specular->is_constant(0) && !s.specular->is_constant(1), "the usual one");
    losses_.add("indices of refraction of 1 or less", s.ior <= 1, "1.5");
    for (const auto* texel : {&s.transmission, &s.specular, &s.specular_color, &s.clearcoat, &s.clearcoat_roughness})
        losses_.add("textures of transmission, reflections and clear coats", *texel && (*texel)->picture, "their factors");
    losses_.add("normal textures of clear coats", s.clearcoat_normal.has_value());
}

void MtlLibrary::add(const PlainSurface& s) {
    add_base_color(s);
    add_reflection(s);
    if (glows(s)) {
        color(text_, "Ke", s.emissive_strength * Vec3(s.emissive->factor));
        add_map("map_Ke", s.emissive);
    }
    std::string bump;
    if (s.normal_scale != 1) bump += " -bm", append_numbers(bump, s.normal_scale);
    add_map("norm", s.normal, bump);
    add_losses(s);
    text_ += '\n';
}

const std::string& MtlLibrary::name(const std::optional<MaterialId>& id) {
    const auto known = known_.find(id);
    if (known != known_.end()) return known->second;
    const std::string own = id ? scene_.materials[id->index].name : "default";
    const std::string& name = known_[id] = names_.make(own, "material");
    losses_.add("characters in names that could break a line or a path", !own.empty() && plain_name(own, "") != own, "_");
    text_ += "newmtl " + name + "\n";
    add(id ? plain_surface(scene_, scene_.materials[id->index], losses_) : PlainSurface());
    return name;
}

}  // namespace alidade
