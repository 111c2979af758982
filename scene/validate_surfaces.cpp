// SPDX-License-Identifier: Apache-2.0
#include "scene/graph.h"
#include "scene/validation.h"

namespace alidade {

namespace {

bool finite(const Vec4& v) { return is_finite(Vec3(v)) && std::isfinite(v.w); }

bool finite(const PatternPicture& picture) {
    return std::isfinite(picture.gamma) &&
           std::all_of(picture.clearings.begin(), picture.clearings.end(), [](const PatternPicture::Clearing& c) { return std::isfinite(c.filter.value_or(0)) && std::isfinite(c.transmit.value_or(0)); });
}

bool finite(const PatternSignal& pattern) {
    const auto is_finite_number = [](double x) { return std::isfinite(x); };
    const Turbulence& t = pattern.turbulence;
    return is_finite(t.amount) && is_finite(Vec3(t.omega, t.lambda, pattern.phase)) && is_finite_number(pattern.wave_exponent) && is_finite_number(pattern.frequency.value_or(0)) &&
           (!pattern.picture || finite(*pattern.picture)) && Transform{pattern.bumps_turned, Vec3(0)}.is_finite() && std::all_of(pattern.parameters.begin(), pattern.parameters.end(), is_finite_number) &&
           std::all_of(pattern.map.begin(), pattern.map.end(), [](const MapEntry& e) { return std::isfinite(e.value); }) &&
           std::all_of(pattern.warps.begin(), pattern.warps.end(), [&](const Warp& w) {
               return w.transform.is_finite() && std::all_of(w.parameters.begin(), w.parameters.end(), is_finite_number);
           });
}

bool finite(const ReliefSignal& relief) {
    return finite(relief.pattern) && std::isfinite(relief.amount) && std::isfinite(relief.accuracy) &&
           std::all_of(relief.slopes.begin(), relief.slopes.end(), [](const SlopeEntry& e) { return is_finite(Vec3(e.value, e.height, e.slope)); });
}

bool finite(const Signal& signal) {
    if (const auto* constant = std::get_if<ConstantSignal>(&signal.what)) return finite(constant->value) && std::isfinite(constant->filter) && std::isfinite(constant->transmit);
    if (const auto* image = std::get_if<ImageSignal>(&signal.what)) return Transform{image->uv_transform, Vec3(0)}.is_finite();
    if (const auto* pattern = std::get_if<PatternSignal>(&signal.what)) return finite(*pattern);
    if (const auto* relief = std::get_if<ReliefSignal>(&signal.what)) return finite(*relief);
    return true;
}

bool finite(const GltfPbr& g) { return is_finite(Vec3(g.normal_scale, g.emissive_strength, g.alpha_cutoff)) && std::isfinite(g.ior); }

bool finite(const PovFinish& p) {
    return is_finite(p.ambient) && is_finite(p.emission) && is_finite(p.reflection_min) && is_finite(p.reflection_max) &&
           is_finite(Vec3(p.diffuse, p.brilliance, p.diffuse_back)) &&
           is_finite(Vec3(p.phong, p.phong_size, p.specular)) && is_finite(Vec3(p.roughness, p.metallic, p.crand)) &&
           is_finite(Vec3(p.reflection_falloff, p.reflection_exponent, p.reflection_metallic)) && is_finite(Vec3(p.irid, p.irid_thickness, p.irid_turbulence)) &&
           is_finite(Vec3(p.ior.value_or(1), p.caustics.value_or(0), p.refraction));
}

bool finite(const PovTextureMap&) { return true; }

bool is_relief(const Scene& scene, SignalId id) { return std::holds_alternative<ReliefSignal>(scene.signals[id.index].what); }

/// Reliefs bend normals: they stand where a normal is asked for, which is the map of another one, and nothing else does.
void check_reliefs(Validation& v, size_t i) {
    const Signal& signal = v.scene.signals[i];
    const auto check = [&](SignalId id, bool relief) {
        if (is_relief(v.scene, id) != relief) v.error(signal.from, fmt::format("{} reads signal {}, which {} a relief", label("signal", i).text(), id.index, relief ? "is not" : "is"));
    };
    const PatternSignal* pattern = pattern_of(signal);
    if (!pattern) return for_each_operand(v.scene, signal, [&](SignalId id) { check(id, false); });
    if (pattern->source) check(*pattern->source, false);
    for (const MapEntry& entry : pattern->map) check(entry.signal, is_relief(v.scene, {uint32_t(i)}));
}

const char* kind_of(const Signal& signal) {
    static constexpr const char* kKinds[] = {"a colour or number", "a picture", "a product", "a channel", "a pattern", "a relief"};
    static_assert(std::size(kKinds) == std::variant_size_v<decltype(Signal::what)>);
    return kKinds[signal.what.index()];
}

void check_signals(Validation& v) {
    const std::vector<Signal>& signals = v.scene.signals;
    for (size_t i = 0; i < signals.size(); ++i) {
        if (!finite(signals[i])) v.error(signals[i].from, fmt::format("{} has a number that is not finite (it is {})", label("signal", i).text(), kind_of(signals[i])));
        check_reliefs(v, i);
        const auto* channel = std::get_if<ChannelSignal>(&signals[i].what);
        if (channel && (channel->channel < 0 || channel->channel > 3))
            v.error(signals[i].from, fmt::format("{} reads channel {}: there are channels 0 to 3", label("signal", i).text(), channel->channel));
    }
    const auto operands = [&](uint32_t i, const auto& f) { for_each_operand(v.scene, signals[i], [&](SignalId id) { f(id.index); }); };
    if (const auto cycle = topological_order(signals.size(), operands).on_cycle)
        v.error(signals[*cycle].from, label("signal", *cycle).text() + " reads itself, directly or through others");
}

void check_texture_map(Validation& v, const PovTextureMap& map, const Material& material, const Label& who) {
    const auto* pattern = std::get_if<PatternSignal>(&v.scene.signals[map.pattern.index].what);
    if (!pattern) return v.error(material.from, fmt::format("{} maps textures by signal {}, which is no pattern", who.text(), map.pattern.index));
    if (pattern->map.empty() || pattern->map.size() != map.textures.size())
        v.error(material.from, fmt::format("{} has {} textures for {} entries of a map", who.text(), map.textures.size(), pattern->map.size()));
}

void check_parts(Validation& v) {
    const std::vector<Material>& materials = v.scene.materials;
    const auto parts = [&](uint32_t i, const auto& f) { for_each_part(materials[i], [&](MaterialId id) { f(id.index); }); };
    if (const auto cycle = topological_order(materials.size(), parts).on_cycle)
        v.error(materials[*cycle].from, label("material", *cycle, materials[*cycle].name).text() + " is a part of itself, directly or through others");
}

void check_material(Validation& v, const Material& material, const Label& who) {
    if (material.layers.empty()) v.error(material.from, who.text() + " has no layers");
    for (const auto& layer : material.layers) {
        if (!std::visit([](const auto& surface) { return finite(surface); }, layer)) v.error(material.from, who.text() + " has a number that is not finite");
        if (const auto* map = std::get_if<PovTextureMap>(&layer)) check_texture_map(v, *map, material, who);
        if (const auto* p = std::get_if<PovFinish>(&layer); p && p->normal && !is_relief(v.scene, *p->normal))
            v.error(material.from, fmt::format("{} has signal {} as its normal, which is no relief", who.text(), p->normal->index));
        if (const auto* g = std::get_if<GltfPbr>(&layer); g && g->ior < 1 && g->ior != 0)   // 0 is KHR_materials_ior's "reflects everything"
            v.warning(material.from, fmt::format("{} has the refractive index {}, which is less than 1", who.text(), g->ior));
    }
}

}  // namespace

void check_media(Validation& v, const std::vector<Interior::Medium>& media, const SourcePos& from, const Label& who) {
    for (const Interior::Medium& m : media) {
        if (!is_finite(m.absorption) || !is_finite(m.emission) || !is_finite(m.scattering) || !is_finite(Vec3(m.eccentricity, m.extinction, 0)))
            v.error(from, who.text() + " has a medium with a number that is not finite");
    }
}

void check_surfaces(Validation& v) {
    const Scene& s = v.scene;
    for (size_t i = 0; i < s.images.size(); ++i) {
        if (s.images[i].path.empty() && s.images[i].bytes.empty())
            v.error(s.images[i].from, label("image", i, s.images[i].name).text() + " has neither a file nor bytes");
    }
    check_signals(v);
    for (size_t i = 0; i < s.materials.size(); ++i) check_material(v, s.materials[i], label("material", i, s.materials[i].name));
    check_parts(v);
    for (size_t i = 0; i < s.interiors.size(); ++i) {
        const Interior& in = s.interiors[i];
        const Label who = label("interior", i);
        if (!is_finite(Vec3(in.ior, in.dispersion, in.caustics)) || !is_finite(Vec3(in.fade_distance, in.fade_power, in.refraction)) || !is_finite(in.fade_color) ||
            !is_finite(in.attenuation_color) || std::isnan(in.attenuation_distance))
            v.error(in.from, who.text() + " has a number that is not finite");
        else if (in.ior <= 0)
            v.error(in.from, fmt::format("{} has the refractive index {}: it must be greater than 0", who.text(), in.ior));
        check_media(v, in.media, in.from, who);
    }
}

}  // namespace alidade
