// SPDX-License-Identifier: Apache-2.0
#include "exporters/surfaces.h"

#include "exporters/picture_patterns.h"

#include <algorithm>

namespace alidade {

namespace {

/// A product may have products as factors, and these the same factors again: no file that makes sense needs more looks than this.
constexpr int kMostLooks = 256;

/// Takes a signal apart.
class Flattening {
  public:
    explicit Flattening(const Scene& scene) : scene_(scene) {}

    std::optional<Texel> of(SignalId id) {
        if (++looks_ > kMostLooks) return std::nullopt;
        return std::visit([this](const auto& what) { return of(what); }, scene_.signals[id.index].what);
    }

  private:
    std::optional<Texel> of(const ConstantSignal& s) { return Texel{s.value, {}, -1}; }
    std::optional<Texel> of(const ImageSignal& s) { return Texel{Vec4(1), s, -1}; }
    std::optional<Texel> of(const PatternSignal& s) {
        auto picture = as_texture(s, scene_.settings);
        return picture ? std::optional(Texel{Vec4(1), std::move(picture), -1}) : std::nullopt;
    }
    std::optional<Texel> of(const ReliefSignal&) { return std::nullopt; }
    std::optional<Texel> of(const ProductSignal& s) {
        const auto a = of(s.a), b = of(s.b);
        if (!a || !b || (a->picture && b->picture)) return std::nullopt;
        Texel out = a->picture ? *a : *b;
        out.factor = a->factor * b->factor;
        return out;
    }
    std::optional<Texel> of(const ChannelSignal& s) {
        auto out = of(s.of);
        if (!out || out->channel >= 0) return out;
        out->factor = Vec4(out->factor[s.channel]);
        if (out->picture) out->channel = s.channel;
        return out;
    }

    const Scene& scene_;
    int looks_ = 0;
};

/// Of a map, from 0 to 1; a list of colours has whole numbers for values, and `average` weights.
std::vector<double> weights_of(const PatternSignal& pattern, const std::vector<MapEntry>& map) {
    std::vector<double> out(map.size(), 1.0);
    if (pattern.pattern == "average")
        for (size_t i = 0; i < map.size(); ++i) out[i] = std::max(map[i].value, 0.0);
    if (pattern.pattern == "average" || map.back().value > 1) return out;
    const auto value = [&](size_t i) { return std::clamp(map[i].value, 0.0, 1.0); };
    for (size_t i = 0; i < map.size(); ++i) {
        const double before = i > 0 ? value(i - 1) : -value(i), after = i + 1 < map.size() ? value(i + 1) : 2 - value(i);
        out[i] = (after - before) / 2;
    }
    return out;
}

/// The mean colour of a pigment, roughly: as if its pattern had all values equally often, and pictures and functions were white. A map may have maps as entries, and these the
/// same ones again.
ConstantSignal mean_of(const Scene& scene, SignalId id, int& looks) {
    const Signal& signal = scene.signals[id.index];
    if (const auto* constant = std::get_if<ConstantSignal>(&signal.what)) return *constant;
    ConstantSignal out;
    out.value = Vec4(1);
    const auto* pattern = std::get_if<PatternSignal>(&signal.what);
    if (!pattern || pattern->map.empty() || ++looks > kMostLooks) return out;
    std::vector<MapEntry> map = pattern->map;
    std::stable_sort(map.begin(), map.end(), [](const MapEntry& a, const MapEntry& b) { return a.value < b.value; });
    const std::vector<double> weights = weights_of(*pattern, map);
    double sum = 0;
    ConstantSignal mean{Vec4(0), 0, 0};
    for (size_t i = 0; i < map.size(); ++i) {
        const ConstantSignal part = mean_of(scene, map[i].signal, looks);
        mean.value += weights[i] * part.value, mean.filter += weights[i] * part.filter, mean.transmit += weights[i] * part.transmit;
        sum += weights[i];
    }
    return sum > 0 ? ConstantSignal{mean.value / sum, mean.filter / sum, mean.transmit / sum} : out;
}

ConstantSignal mean_of(const Scene& scene, SignalId id) {
    int looks = 0;
    return mean_of(scene, id, looks);
}

bool finite(const Vec4& v) { return is_finite(Vec3(v)) && std::isfinite(v.w); }

PlainSurface surface_of(const Scene& scene, const GltfPbr& from, Losses& losses) {
    const auto maybe = [&](const std::optional<SignalId>& id) { return id ? std::optional(texel(scene, *id, losses)) : std::nullopt; };
    PlainSurface out;
    out.base_color = texel(scene, from.base_color, losses);
    out.metallic = maybe(from.metallic).value_or(Texel());
    out.roughness = maybe(from.roughness).value_or(Texel());
    out.normal = maybe(from.normal), out.occlusion = maybe(from.occlusion), out.emissive = maybe(from.emissive);
    out.transmission = maybe(from.transmission), out.specular = maybe(from.specular), out.specular_color = maybe(from.specular_color);
    out.clearcoat = maybe(from.clearcoat), out.clearcoat_roughness = maybe(from.clearcoat_roughness), out.clearcoat_normal = maybe(from.clearcoat_normal);
    out.normal_scale = from.normal_scale, out.emissive_strength = from.emissive_strength, out.alpha_cutoff = from.alpha_cutoff, out.ior = from.ior;
    out.alpha_mode = from.alpha_mode, out.double_sided = from.double_sided, out.unlit = from.unlit;
    return out;
}

PlainSurface surface_of(const Scene& scene, const PovFinish& from, Losses& losses) {
    losses.add("POV-Ray finishes", 1, "their pigment, ambient and emission on a rough surface");
    PlainSurface out;
    out.base_color = texel(scene, from.pigment, losses);
    const ConstantSignal mean = mean_of(scene, from.pigment);
    const double through = out.base_color.picture ? 0 : std::clamp(mean.filter + mean.transmit, 0.0, 1.0);
    const Color pigment(out.base_color.factor);
    out.base_color.factor = Vec4(from.diffuse * pigment, 1 - through);
    if (through > 0 || (out.base_color.picture && has_alpha(scene.images[out.base_color.picture->image.index]))) out.alpha_mode = AlphaMode::blend;
    out.metallic.factor = Vec4(0);
    const Color own = from.emission + from.ambient * scene.settings.ambient_light;
    if (!is_black(own)) out.emissive = Texel{Vec4(own * pigment, 1), out.base_color.picture, out.base_color.channel};
    out.double_sided = true;
    return out;
}

PlainSurface surface_of(const Scene& scene, const PovTextureMap& from, Losses& losses) {
    losses.add("maps of textures", 1, "their first texture");
    return plain_surface(scene, scene.materials[from.textures.front().index], losses);
}

}  // namespace

Texel texel(const Scene& scene, SignalId signal, Losses& losses) {
    const auto found = Flattening(scene).of(signal);
    if (!found) losses.add("patterns, functions and products of pictures", 1, "their mean colour, roughly");
    const Texel out = found.value_or(Texel{mean_of(scene, signal).value, {}, -1});
    return finite(out.factor) ? out : Texel();
}

PlainSurface plain_surface(const Scene& scene, const Material& material, Losses& losses) {
    if (material.layers.empty()) return {};
    losses.add("layers over the lowest of a material", material.layers.size() - 1);
    return std::visit([&](const auto& layer) { return surface_of(scene, layer, losses); }, material.layers.front());
}

}  // namespace alidade
