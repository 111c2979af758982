// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/textures.h"

#include "exporters/pov/metal_rough.h"
#include "scene/graph.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov_export {

namespace {

std::string texture_name(MaterialId id) { return fmt::format("Texture_{}", id.index); }

const GltfPbr* metal_rough(const Material& m) { return m.layers.empty() ? nullptr : std::get_if<GltfPbr>(&m.layers.front()); }

void write_reflection(Sdl& sdl, const PovFinish& f) {
    if (is_black(f.reflection_min) && is_black(f.reflection_max)) return;
    sdl.begin("reflection");
    const bool one = f.reflection_min == f.reflection_max && !f.reflection_fresnel;
    if (one) sdl.line(Expression{f.reflection_max});
    else sdl.line(Expression{f.reflection_min}, ",", Expression{f.reflection_max});
    if (f.reflection_fresnel) sdl.line("fresnel on");
    if (f.reflection_falloff != 1) sdl.line("falloff", f.reflection_falloff);
    if (f.reflection_metallic != 0) sdl.line("metallic", f.reflection_metallic);
    sdl.end();
    if (f.reflection_exponent != 1) sdl.line("reflection_exponent", f.reflection_exponent);
}

bool has_old_words(const PovFinish& f) { return f.ior || f.caustics || f.refraction != 1; }
bool has_old_words(const PovTextureMap&) { return false; }
bool has_old_words(const GltfPbr&) { return false; }

bool has_old_words(const Material& m) {
    return std::any_of(m.layers.begin(), m.layers.end(), [](const auto& layer) { return std::visit([](const auto& what) { return has_old_words(what); }, layer); });
}

size_t uncolored_layers(const Material& m) {
    return size_t(std::count_if(m.layers.begin(), m.layers.end(), [](const auto& layer) {
        const auto* finish = std::get_if<PovFinish>(&layer);
        return finish && finish->uncolored;
    }));
}

/// The language in which a material's declaration says what it is, if it is not the scene's.
const char* older_version(const Scene& scene, const Material& m) {
    if (has_old_words(m) && scene.settings.filter_dims_by_colour) return "#version 3.0;";   // POV-Ray warns of such words in newer scenes, where they act otherwise
    return uncolored_layers(m) ? "#version 3.1;" : nullptr;
}

/// Words that a finish could have below version 3.1, where caustics were counted otherwise.
void write_old_words(Sdl& sdl, const PovFinish& f) {
    if (f.ior) sdl.line("ior", *f.ior);
    if (f.caustics) sdl.line("caustics", *f.caustics * 45);
    if (f.refraction != 1) sdl.line("refraction", f.refraction);
}

}  // namespace

const char* version_line(const Scene& scene) { return scene.settings.filter_dims_by_colour ? "#version 3.6;" : "#version 3.7;"; }

void write_finish(Sdl& sdl, const PovFinish& f) {
    const PovFinish usual{};
    const auto number = [&](const char* word, double value, double unless) {
        if (value != unless) sdl.line(word, value);
    };
    sdl.begin("finish");
    if (f.ambient != usual.ambient) sdl.line("ambient", Expression{f.ambient});
    if (f.emission != usual.emission) sdl.line("emission", Expression{f.emission});
    if (f.diffuse_back != 0) sdl.line("diffuse", f.diffuse, ",", f.diffuse_back);
    else number("diffuse", f.diffuse, usual.diffuse);
    number("brilliance", f.brilliance, usual.brilliance);
    number("phong", f.phong, usual.phong), number("phong_size", f.phong_size, usual.phong_size);
    number("specular", f.specular, usual.specular), number("roughness", f.roughness, usual.roughness);
    number("metallic", f.metallic, usual.metallic), number("crand", f.crand, usual.crand);
    write_reflection(sdl, f);
    if (f.conserve_energy) sdl.line("conserve_energy");
    if (f.irid != 0) sdl.line("irid {", f.irid, "thickness", f.irid_thickness, "turbulence", f.irid_turbulence, "}");
    write_old_words(sdl, f);
    sdl.end();
}

namespace {

/// What bends the normals of a layer in texture coordinates, or has textures in it that do.
const PatternSignal* uv_mapped_bumps(const Scene& scene, std::optional<SignalId> signal) {
    const PatternSignal* pattern = signal ? pattern_of(scene.signals[signal->index]) : nullptr;
    return pattern && pattern->uv_mapped ? pattern : nullptr;
}

/// Of the lowest layer.
const PatternSignal* uv_mapped_bumps(const Scene& scene, const Material& m) {
    if (m.layers.empty()) return nullptr;
    const auto* map = std::get_if<PovTextureMap>(&m.layers.front());
    const auto* finish = std::get_if<PovFinish>(&m.layers.front());
    return uv_mapped_bumps(scene, map ? map->pattern : finish ? finish->normal : std::nullopt);
}

}  // namespace

void TextureWriter::layer(const PovFinish& f) {
    sdl_.begin("texture");
    const PatternSignal* bumps = uv_mapped_bumps(scene_, f.normal);
    if (bumps && (bumps->bumps_turn || bumps->bumps_turned != Mat3(1.0))) sdl_.line("uv_mapping");
    patterns_.pigment_block(f.pigment);
    if (f.normal) patterns_.normal_block(*f.normal);
    write_finish(sdl_, f);
    sdl_.end();
}

/// A texture for each number that a pixel can have.
void TextureWriter::material_map(const PovTextureMap& m, const PatternSignal& pattern) {
    if (pattern.uv_mapped) sdl_.line("uv_mapping");
    const auto textures = [&] {
        for (const MaterialId id : m.textures) use(id);
    };
    if (images_.pattern("material_map", *pattern.picture, textures)) patterns_.pattern_modifiers(pattern);
    else use(m.textures.front());
}

void TextureWriter::layer(const PovTextureMap& m) {
    const auto* pattern = pattern_of(scene_.signals[m.pattern.index]);
    sdl_.begin("texture");
    if (!pattern) {
        use(m.textures.front());
    } else if (pattern->picture && pattern->picture->value == PictureValue::number) {
        material_map(m, *pattern);
    } else {
        patterns_.pattern_head(*pattern);
        const bool list = PatternWriter::list_length(*pattern) != 0;
        if (!list) sdl_.begin("texture_map");
        for (size_t i = 0; i < m.textures.size(); ++i) {
            if (list) use(m.textures[i]);
            else sdl_.line("[", i < pattern->map.size() ? pattern->map[i].value : 1.0, texture_name(m.textures[i]), "]");
        }
        if (!list) sdl_.end();
        patterns_.pattern_modifiers(*pattern);
    }
    sdl_.end();
}

/// A declared texture that says uv_mapping turns its bumps with what is done to it later, and nothing else.
void TextureWriter::turn(MaterialId id) {
    const PatternSignal* bumps = uv_mapped_bumps(scene_, scene_.materials[id.index]);
    if (bumps && bumps->bumps_turned != Mat3(1.0)) sdl_.line("#declare", texture_name(id), "= texture {", texture_name(id), Transform{bumps->bumps_turned, Vec3(0)}, "}");
}

void TextureWriter::declare_one(MaterialId id) {
    const Material& m = scene_.materials[id.index];
    const MaterialRef ref{id.index, m.name};
    sdl_.comment(m.name);
    if (metal_rough(m)) return write_metal_rough(ref, plain_surface(scene_, m, losses_), sky_, output_, texture_name(id));
    if (m.layers.empty()) return write_metal_rough(ref, {}, sky_, output_, texture_name(id));
    sdl_.line("#declare", texture_name(id), "=");
    losses_.wrote(ref);
    const char* version = older_version(scene_, m);
    if (const size_t above = m.layers.size() - 1; version && uncolored_layers(m) < above)
        losses_.add("layers that colour what passes them, under or over others that do not", above - uncolored_layers(m), "layers that do not");
    if (version) sdl_.line(version);
    for (const auto& part : m.layers) std::visit([&](const auto& what) { layer(what); }, part);
    turn(id);
    if (version) sdl_.line(version_line(scene_));
}

void TextureWriter::declare(std::vector<bool> used, const std::vector<SignalId>& pigments) {
    const auto parts = [&](uint32_t i, const auto& f) { for_each_part(scene_.materials[i], [&](MaterialId id) { f(id.index); }); };
    const std::vector<uint32_t> order = topological_order(scene_.materials.size(), parts).sequence;
    for (const uint32_t i : order)
        if (used[i]) parts(i, [&](uint32_t part) { used[part] = true; });
    std::vector<SignalId> roots = pigments;
    for (const uint32_t i : order)
        if (used[i] && !metal_rough(scene_.materials[i])) for_each_signal(scene_.materials[i], [&](SignalId id) { roots.push_back(id); });
    patterns_.declare(roots);
    for (auto i = order.rbegin(); i != order.rend(); ++i)
        if (used[*i]) declare_one({*i});
}

void TextureWriter::declare_default() {
    write_metal_rough({uint32_t(scene_.materials.size()), "default"}, {}, sky_, output_, "Texture_default");
}

void TextureWriter::tinted(MaterialId material, const Vec4& tint) {
    Losses told;   // when the material itself was declared
    PlainSurface surface = plain_surface(scene_, scene_.materials[material.index], told);
    surface.base_color.factor *= tint;
    write_metal_rough({}, surface, sky_, {sdl_, images_, told, highlights_}, "", MirrorImages::strong);
}

void TextureWriter::use(std::optional<MaterialId> material) { sdl_.line("texture {", material ? texture_name(*material) : "Texture_default", "}"); }

void TextureWriter::medium(const Interior::Medium& m) {
    sdl_.begin("media");
    if (!is_black(m.absorption)) sdl_.line("absorption", Rgbft{m.absorption});
    if (!is_black(m.emission)) sdl_.line("emission", Rgbft{m.emission});
    if (!is_black(m.scattering)) {
        sdl_.begin("scattering");
        sdl_.line(m.scattering_type, ", color", Rgbft{m.scattering}, "extinction", m.extinction);
        if (m.scattering_type == 5) sdl_.line("eccentricity", m.eccentricity);
        sdl_.end();
    }
    for (const SignalId density : m.density) {
        sdl_.begin("density");
        patterns_.pigment(density);
        sdl_.end();
    }
    sdl_.end();
}

void TextureWriter::interior(std::optional<MaterialId> material, std::optional<InteriorId> inside) {
    const Material* m = material ? &scene_.materials[material->index] : nullptr;
    Interior in = inside ? scene_.interiors[inside->index] : Interior();
    if (const GltfPbr* pbr = m ? metal_rough(*m) : nullptr; pbr && pbr->transmission) in.ior = pbr->ior;
    if (!inside && in.ior == 1 && in.caustics == 0) return;
    if (std::isfinite(in.attenuation_distance) && in.attenuation_color != Color(1)) set_beer(in);
    sdl_.begin("interior");
    sdl_.line("ior", in.ior);
    if (in.caustics != 0) sdl_.line("caustics", in.caustics);
    if (in.dispersion != 1) sdl_.line("dispersion", in.dispersion, "dispersion_samples", in.dispersion_samples);
    if (in.fade_distance != 0) sdl_.line("fade_distance", in.fade_distance);
    if (in.fade_power != 0) sdl_.line("fade_power", in.fade_power);
    if (!is_black(in.fade_color)) sdl_.line("fade_color", Expression{in.fade_color});
    for (const Interior::Medium& each : in.media) medium(each);
    sdl_.end();
}

}  // namespace alidade::pov_export
