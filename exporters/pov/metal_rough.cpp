// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/metal_rough.h"

#include "exporters/pov/textures.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade::pov_export {

namespace {

/// Below it a surface is a perfect mirror, in which lights have no image.
constexpr double kSmallestAlpha = 1e-4;
/// What a layer that gives light takes from those under it: so little that it changes no picture, and its light is that much larger. A power of two.
constexpr double kVeil = 1.0 / (1 << 20);

class Surface {
  public:
    Surface(const MaterialRef& material, const PlainSurface& s, const Color& sky, MirrorImages mirrors, const TextureOutput& out, const std::string& name)
        : s_(s), material_(material), name_(name), sdl_(out.sdl), images_(out.images), losses_(out.losses), highlights_(out.highlights), sky_(sky), mirrors_(mirrors) {
        metallic_ = scalar(s.metallic, "metalness"), roughness_ = scalar(s.roughness, "roughness");
        through_ = s.transmission ? std::clamp(scalar(*s.transmission, "transmission"), 0.0, 1.0) * (1 - metallic_) : 0;
        base_ = Color(s.base_color.factor), tint_ = base_;
        if (s.alpha_mode == AlphaMode::blend) alpha_ = std::clamp(s.base_color.factor.w, 0.0, 1.0);
        cut_out_ = s.base_color.picture && s.alpha_mode != AlphaMode::opaque && images_.has_alpha(*s.base_color.picture);
        if (cut_out_) alpha_ = 1;   // write_cut_out mixes whole textures
        if (s.alpha_mode == AlphaMode::mask && !cut_out_) alpha_ = s.base_color.factor.w < s.alpha_cutoff ? 0 : 1;
        partly_metal_ = metallic_ > 0 && metallic_ < 1 && !s.base_color.picture && !s.unlit && !cut_out_ && mirrors == MirrorImages::all && through_ <= 0;
        if (s.emissive) glow_ = Color(s.emissive->factor) * s.emissive_strength;
    }

    void write() {
        tell_losses();
        const bool layered = cut_out_ && !s_.unlit && (!is_black(glow_) || s_.clearcoat) && !name_.empty();
        if (layered) {   // in a texture_map layers must have a name
            sdl_.line("#declare", name_ + kThere, "=");
            write_layers();
        }
        if (!name_.empty()) sdl_.line("#declare", name_, "=");
        cut_out_ ? write_cut_out(layered) : s_.unlit ? write_unlit() : write_layers();
    }

  private:
    static constexpr const char* kThere = "_there";

    void write_layers() {
        const bool inside_base = put_emission_into_base();
        sdl_.begin("texture");
        pigment();
        finish(inside_base);
        sdl_.end();
        write_gleams();
        if (partly_metal_) write_other_diffuse();
        if (!inside_base && !is_black(glow_)) write_glow();
        if (s_.clearcoat) write_coat();
    }

    void lose(const std::string& what, bool lost = true, const std::string& instead = {}) { losses_.add_of_material(material_, what, lost, instead); }

    double scalar(const Texel& t, const char* what) {
        if (!t.picture) return t.factor.x;
        lose(fmt::format("the picture of {}", what), true, "its mean");
        return t.factor.x * images_.mean(*t.picture, std::max(t.channel, 0));
    }

    void tell_losses() {
        const double alpha = roughness_ * roughness_;
        const bool glossy = !s_.unlit && alpha >= kSmallestAlpha;
        lose("the GGX highlight", glossy && highlight() > 0, "lobes of Blinn's and Phong's");
        lose("the highlight at grazing angles", glossy && highlight() <= 0 && specular() > 0);   // its colour straight on is black
        lose("the normal map", s_.normal.has_value());
        lose("the clear coat", s_.clearcoat.has_value(), "a layer that takes nothing from what is under it");
        lose("the normal map of the clear coat", s_.clearcoat_normal.has_value());
        const auto loses_edges = [&](const Texel& t) { return t.picture && images_.loses_edges(*t.picture); };
        lose("the clamping or mirroring of pictures at their edges", loses_edges(s_.base_color) || (s_.emissive && loses_edges(*s_.emissive)), "repeated ones");
        const std::optional<ImageSignal> base = s_.base_color.picture, glow = s_.emissive ? s_.emissive->picture : std::nullopt;
        lose("the texture coordinates of the picture of emission", base && glow && base->uv_set != glow->uv_set, "those of the base colour");
        const Color f0 = dielectric_f0();
        lose("the colour of highlights", !s_.unlit && metallic_ < 1 && (f0.x != f0.y || f0.y != f0.z), "that of its reflection alone");
        lose("a picture's mirror image at grazing angles", !s_.unlit && mirror() > 0 && metallic_ > 0 && s_.base_color.picture, "POV-Ray's metallic one");
        lose("the alpha of glass", through_ > 0 && alpha_ < 1, "that of what is seen through it alone");
        losses_.add(fmt::format("the picture of the occlusion of material '{}'", plain_name(material_.name, "unnamed")), s_.occlusion.has_value());   // no renderer of ours shows it either
    }

    /// Strength of the mirror image: (1 - roughness)^2, and all of it for glass.
    double mirror() const { return through_ > 0 ? 1 : (1 - roughness_) * (1 - roughness_); }
    /// What is reflected straight on where it is no metal.
    Color dielectric_f0() const {
        const double r = (s_.ior - 1) / (s_.ior + 1);
        const Color tint = s_.specular_color ? Color(s_.specular_color->factor) : Color(1);
        return glm::min(tint * (r * r), Color(1)) * specular();
    }
    double dielectric() const {
        const Color f0 = dielectric_f0();
        return f0.x == f0.y && f0.y == f0.z ? f0.x : (f0.x + f0.y + f0.z) / 3;
    }
    double specular() const { return s_.specular ? s_.specular->factor.x : 1; }
    Color f0() const {
        const Color metal = s_.base_color.picture ? Color(max_component(base_)) : base_;
        return dielectric_f0() * (1 - metallic_) + metal * metallic_;
    }
    /// What is left for diffuse light, of the colours together: a picture's pigment is as it is.
    double unreflected() {
        const double d = std::min(dielectric(), 1.0);
        if (metallic_ <= 0 || metallic_ >= 1) return 1 - d;
        double base = 0;
        for (int i = 0; i < 3; ++i) base += base_[i] * (s_.base_color.picture ? images_.mean(*s_.base_color.picture, i, Encoding::srgb) : 1) / 3;
        return 1 - (d * (1 - metallic_) + base * metallic_);
    }
    double highlight() const { return dielectric() * (1 - metallic_) + metallic_; }

    /// POV-Ray multiplies emission by the pigment: one layer does where the pigment has all the colours that are emitted, or nothing else needs it.
    bool put_emission_into_base() {
        if (is_black(glow_) || s_.emissive->picture || s_.base_color.picture || through_ > 0) return false;
        Color needed;
        for (int i = 0; i < 3; ++i) {
            if (glow_[i] > 0 && base_[i] < 1e-3) return false;
            needed[i] = glow_[i] > 0 ? glow_[i] / base_[i] : 0;
        }
        glow_ = needed;
        return true;
    }

    bool picture_pigment() {
        if (!s_.base_color.picture) return false;
        const Vec4 tint(tint_.x, tint_.y, tint_.z, alpha_);
        const ImageSignal& image = *s_.base_color.picture;
        lose("the transmission", through_ > 0, "an opaque picture");
        return show(image, tint, alpha_ < 1 ? PictureAlpha::kept : PictureAlpha::removed);
    }

    /// Where alpha cuts out, textures are in the space of the base colour's picture.
    bool show(const ImageSignal& image, const Vec4& tint, PictureAlpha alpha, double transmit = 0) {
        return cut_out_ ? images_.map_within(*s_.base_color.picture, image, tint, transmit) : images_.map(image, tint, alpha, transmit);
    }

    void pigment() {
        sdl_.begin("pigment");
        if (!picture_pigment()) sdl_.line(Rgbft{base_, through_ * alpha_, 1 - alpha_});
        sdl_.end();
    }

    /// Where nothing is there is no light on it either: textures are mixed by the picture's alpha, not colours.
    void write_cut_out(bool layered) {
        const double factor = s_.base_color.factor.w, cutoff = 1 - std::clamp(factor > 0 ? s_.alpha_cutoff / factor : 2, -1.0, 2.0);
        const bool mask = s_.alpha_mode == AlphaMode::mask;
        const double whole = 1 - 1 / std::clamp(factor, 1e-6, 1.0);   // where the texture would stand alone: it is there by factor x alpha
        const ImageSignal& image = *s_.base_color.picture;
        sdl_.begin("texture");
        images_.alpha_pattern(image);
        sdl_.begin("texture_map");
        sdl_.line("[", mask ? cutoff : whole);
        if (layered) {
            sdl_.line(name_ + kThere);
        } else {
            pigment();
            s_.unlit ? unlit_finish() : finish(false);
        }
        sdl_.line("]");
        sdl_.line("[", mask ? cutoff : 1, "pigment { color rgbt <0,0,0,1> } finish { ambient 0 diffuse 0 } ]");
        sdl_.end();
        images_.place(image);
        sdl_.end();
    }

    void finish(bool emits) {
        PovFinish f;
        f.diffuse = (1 - metallic_) * (partly_metal_ ? 1 - max_component(f0()) : unreflected());
        f.ambient = sky_ * f.diffuse;
        if (emits) f.emission = glow_;
        if (const std::vector<Gleam> parts = gleams(); !parts.empty()) {
            set_highlight(f, parts[0], 0);
            if (parts[0].metal) f.diffuse += parts[0].lobes->lambert.factor * parts[0].share;   // the pigment's alpha has its share of it
        }
        set_reflection(f);
        f.conserve_energy = through_ > 0;
        write_finish(sdl_, f);
    }

    /// Highlights in the colour of the pigment (`metal`) or of the light.
    struct Gleam {
        const Lobes* lobes;
        double share, metallic;
        bool metal;
    };

    /// Of the metal and of what is none, which have layers of their own; mixed textures have no layers.
    std::vector<Gleam> gleams() const {
        const double alpha = roughness_ * roughness_;
        if (s_.unlit || alpha < kSmallestAlpha || highlight() <= 0) return {};
        if (cut_out_ || mirrors_ == MirrorImages::strong) {
            const bool metal = metallic_ > 0.5;
            return {{&highlights_({alpha, highlight(), specular() * (1 - metallic_) + metallic_, metal, false}), 1, metallic_, metal}};
        }
        std::vector<Gleam> out;
        if (metallic_ > 0) out.push_back({&highlights_({alpha, 1, 1, true, true}), metallic_, 1, true});
        if (metallic_ < 1 && dielectric() > 0) out.push_back({&highlights_({alpha, dielectric(), specular(), false, true}), 1 - metallic_, 0, false});
        return out;
    }

    /// The lobes of the finish number `i`, on the surface that is there.
    void set_highlight(PovFinish& f, const Gleam& gleam, size_t i) const {
        const Lobe &blinn = gleam.lobes->blinn[i], &phong = gleam.lobes->phong[i];
        f.specular = blinn.factor * gleam.share * alpha_, f.phong = phong.factor * gleam.share * alpha_;
        if (f.specular > 0) f.roughness = 1 / blinn.exponent;
        if (f.phong > 0) f.phong_size = phong.exponent;
        if (f.specular + f.phong > 0) f.metallic = gleam.metallic;
    }

    /// The layers of the lobes that the base has no room for.
    void write_gleams() {
        const std::vector<Gleam> parts = gleams();
        for (size_t k = 0; k < parts.size(); ++k)
            for (size_t i = k == 0 ? 1 : 0; i < parts[k].lobes->blinn.size(); ++i) {
                PovFinish f;
                f.ambient = Color(0), f.diffuse = 0;
                set_highlight(f, parts[k], i);
                const Lobe& lambert = parts[k].lobes->lambert;
                if (lambert.factor > 0 && !parts[k].metal && i == 1) f.diffuse = lambert.factor * parts[k].share / kVeil * alpha_, f.brilliance = lambert.exponent;
                if (f.specular + f.phong + f.diffuse > 0) write_gleam(f, parts[k].metal);
            }
    }

    void write_gleam(const PovFinish& f, bool metal) {
        sdl_.begin("texture");
        sdl_.begin("pigment");
        if (!metal) sdl_.line(Rgbft{Color(1), 0, 1 - kVeil});
        else if (!s_.base_color.picture || !show(*s_.base_color.picture, Vec4(base_, 1), PictureAlpha::removed, 1)) sdl_.line(Rgbft{base_, 0, 1});
        sdl_.end();
        write_finish(sdl_, f);
        sdl_.end();
    }

    /// Of what is partly metal: colours of which less is reflected than of the base's brightest have more diffuse light.
    void write_other_diffuse() {
        const Color more = base_ * (Color(max_component(f0())) - f0());
        const double most = max_component(more);
        if (most <= 0) return;
        PovFinish f;
        f.diffuse = (1 - metallic_) * most / kVeil * alpha_, f.ambient = sky_ * f.diffuse;
        sdl_.begin("texture");
        sdl_.line("pigment {", Rgbft{more / most, 0, 1 - kVeil}, "}");
        write_finish(sdl_, f);
        sdl_.end();
    }

    void set_reflection(PovFinish& f) const {
        constexpr double kWeak = 0.25;
        const double k = mirror() * alpha_;
        if (k <= 0 || (mirrors_ == MirrorImages::strong && k < kWeak)) return;
        if (through_ > 0) {
            f.reflection_max = Color(k), f.reflection_fresnel = true;
            return;
        }
        const Color least = f0();
        f.reflection_min = least * k, f.reflection_max = Color((specular() * (1 - metallic_) + metallic_) * k);
        f.reflection_falloff = 5;   // with it, POV-Ray's mix of the two is Schlick's
        if (s_.base_color.picture) f.reflection_metallic = metallic_;
        if (is_black(f.reflection_min) && is_black(f.reflection_max)) f.reflection_falloff = 1;
    }

    void write_unlit() {
        sdl_.begin("texture");
        pigment();
        unlit_finish();
        sdl_.end();
    }

    void unlit_finish() {
        PovFinish f;
        f.ambient = Color(0), f.diffuse = 0, f.emission = Color(1);
        write_finish(sdl_, f);
    }

    void write_glow() {
        const Texel& e = *s_.emissive;
        const double most = max_component(glow_);
        const Color colour = glow_ / most;
        sdl_.begin("texture");
        sdl_.begin("pigment");
        if (!e.picture || !show(*e.picture, Vec4(colour, 1), PictureAlpha::removed, 1 - kVeil)) sdl_.line(Rgbft{colour, 0, 1 - kVeil});
        sdl_.end();
        PovFinish f;
        f.ambient = Color(0), f.diffuse = 0, f.emission = Color(most / kVeil * alpha_);
        write_finish(sdl_, f);
        sdl_.end();
    }

    void write_coat() {
        constexpr double kCoat = 0.04;   // ((1.5 - 1) / (1.5 + 1))^2
        const double coat = scalar(*s_.clearcoat, "clear coat"), rough = s_.clearcoat_roughness ? scalar(*s_.clearcoat_roughness, "roughness of the coat") : 0;
        if (coat * alpha_ <= 0) return;
        sdl_.begin("texture");
        sdl_.line("pigment { color rgbt <0,0,0,1> }");
        PovFinish f;
        f.ambient = Color(0), f.diffuse = 0;
        if (rough * rough >= kSmallestAlpha) set_highlight(f, {&highlights_({rough * rough, coat * kCoat, coat, false, false}), 1, 0, false}, 0);
        const double k = coat * (1 - rough) * (1 - rough) * alpha_;
        f.reflection_min = Color(k * kCoat), f.reflection_max = Color(k), f.reflection_falloff = 5;
        write_finish(sdl_, f);
        sdl_.end();
    }

    const PlainSurface& s_;
    const MaterialRef& material_;
    const std::string& name_;
    Sdl& sdl_;
    ImageWriter& images_;
    Losses& losses_;
    HighlightFits& highlights_;
    Color sky_;
    MirrorImages mirrors_;
    double metallic_ = 0, roughness_ = 1, through_ = 0, alpha_ = 1;
    Color base_{1}, tint_{1}, glow_{0};
    bool cut_out_ = false;        ///< by the alpha of its picture
    bool partly_metal_ = false;   ///< and has layers of diffuse light
};

}  // namespace

void write_metal_rough(const MaterialRef& material, const PlainSurface& surface, const Color& sky, const TextureOutput& out, const std::string& name, MirrorImages mirrors) {
    out.losses.wrote(material);
    Surface(material, surface, sky, mirrors, out, name).write();
}

void set_beer(Interior& in) {
    Color rate;
    for (int i = 0; i < 3; ++i) rate[i] = -std::log(std::clamp(in.attenuation_color[i], 1e-30, 1.0)) / in.attenuation_distance;
    const double most = max_component(rate);
    if (!(most > 0)) return;
    in.fade_power = 1001, in.fade_distance = 1 / most, in.fade_color = Color(1) - rate / most;
}

}  // namespace alidade::pov_export
