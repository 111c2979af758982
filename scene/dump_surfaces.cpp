// SPDX-License-Identifier: Apache-2.0
#include "scene/dump_line.h"

namespace alidade {

namespace {

void dump_image(std::string& out, size_t i, const Image& image) {
    Line line(out, fmt::format("image {}", i));
    line.field("name", image.name).field("path", image.path);
    if (!image.bytes.empty()) line.word(fmt::format("bytes={} fnv1a={:016x}", image.bytes.size(), fingerprint(image.bytes)));
    line.field("from", image.from);
}

/// One signal: its line, and lines below it for what it has many of.
class SignalDump {
  public:
    SignalDump(std::string& out, std::string head, const Signal& signal) : out_(out), head_(std::move(head)), from_(signal.from) {}

    void operator()(const ConstantSignal& s) const { Line(out_, head_).word("constant").always("value", s.value).field("filter", s.filter).field("transmit", s.transmit).field("from", from_); }
    void operator()(const ImageSignal& s) const {
        const ImageSignal usual;
        Line(out_, head_).word("image").always("image", s.image).field("uv_set", s.uv_set).field("wrap_u", s.wrap_u).field("wrap_v", s.wrap_v)
            .field("filter", s.filter, usual.filter).field("srgb", s.srgb).field("uv_transform", s.uv_transform, usual.uv_transform).field("from", from_);
    }
    void operator()(const ProductSignal& s) const { Line(out_, head_).word("product").always("a", s.a).always("b", s.b).field("from", from_); }
    void operator()(const ChannelSignal& s) const { Line(out_, head_).word("channel").always("of", s.of).always("channel", s.channel).field("from", from_); }
    void operator()(const PatternSignal& s) const { pattern(head_, s); }
    void operator()(const ReliefSignal& s) const {
        const ReliefSignal usual;
        Line(out_, head_).word("relief").field("amount", s.amount, usual.amount).field("accuracy", s.accuracy, usual.accuracy).field("scaled", s.scaled, usual.scaled);
        pattern(" ", s.pattern);
        for (const SlopeEntry& entry : s.slopes) Line(out_, "  slope").always("value", entry.value).always("height", entry.height).always("slope", entry.slope);
    }

  private:
    void pattern(std::string_view head, const PatternSignal& s) const {
        const PatternSignal usual;
        Line(out_, head).word("pattern").always("pattern", s.pattern).field("parameters", s.parameters).field("source", s.source).field("function", s.function).field("uv_mapped", s.uv_mapped).field("bumps_turn", s.bumps_turn).field("bumps_turned", s.bumps_turned, usual.bumps_turned).field("turbulence", s.turbulence.amount, usual.turbulence.amount)
            .field("octaves", s.turbulence.octaves, usual.turbulence.octaves).field("omega", s.turbulence.omega, usual.turbulence.omega)
            .field("lambda", s.turbulence.lambda, usual.turbulence.lambda).field("noise", s.noise, usual.noise).field("wave", s.wave)
            .field("wave_exponent", s.wave_exponent, usual.wave_exponent).field("frequency", s.frequency).field("phase", s.phase).field("from", from_);
        if (s.picture) picture(*s.picture);
        for (const MapEntry& entry : s.map) Line(out_, "  map").always("value", entry.value).always("signal", entry.signal);
        for (const Warp& warp : s.warps)
            Line(out_, "  warp").always("kind", warp.kind).field("transform", warp.transform).field("parameters", warp.parameters);
    }

    void picture(const PatternPicture& p) const {
        const PatternPicture usual;
        Line(out_, "  picture").always("image", p.image).field("map", p.map, usual.map).field("filter", p.filter, usual.filter).field("code", p.code, usual.code).field("gamma", p.gamma, usual.gamma).field("scene_gamma", p.scene_gamma, usual.scene_gamma)
            .field("once", p.once).field("premultiplied", p.premultiplied).field("value", p.value, usual.value);
        for (const PatternPicture::Clearing& c : p.clearings) Line(out_, "  clearing").field("color", c.color).field("filter", c.filter).field("transmit", c.transmit);
    }

    std::string& out_;
    std::string head_;
    const SourcePos& from_;
};

void dump_layer(std::string& out, const GltfPbr& g) {
    const GltfPbr usual;
    Line(out, "  gltf").always("base_color", g.base_color).field("metallic", g.metallic).field("roughness", g.roughness).field("normal", g.normal)
        .field("normal_scale", g.normal_scale, usual.normal_scale).field("occlusion", g.occlusion).field("emissive", g.emissive)
        .field("emissive_strength", g.emissive_strength, usual.emissive_strength).field("alpha_mode", g.alpha_mode)
        .field("alpha_cutoff", g.alpha_cutoff, usual.alpha_cutoff).field("double_sided", g.double_sided).field("unlit", g.unlit)
        .field("ior", g.ior, usual.ior).field("transmission", g.transmission).field("specular", g.specular).field("specular_color", g.specular_color)
        .field("clearcoat", g.clearcoat).field("clearcoat_roughness", g.clearcoat_roughness).field("clearcoat_normal", g.clearcoat_normal);
}

void dump_layer(std::string& out, const PovFinish& p) {
    const PovFinish usual;
    Line(out, "  pov").always("pigment", p.pigment).field("normal", p.normal).field("ambient", p.ambient, usual.ambient).field("emission", p.emission)
        .field("diffuse", p.diffuse, usual.diffuse).field("brilliance", p.brilliance, usual.brilliance).field("diffuse_back", p.diffuse_back)
        .field("phong", p.phong).field("phong_size", p.phong_size, usual.phong_size).field("specular", p.specular)
        .field("roughness", p.roughness, usual.roughness).field("metallic", p.metallic).field("crand", p.crand)
        .field("reflection_min", p.reflection_min).field("reflection_max", p.reflection_max)
        .field("reflection_falloff", p.reflection_falloff, usual.reflection_falloff)
        .field("reflection_exponent", p.reflection_exponent, usual.reflection_exponent).field("reflection_metallic", p.reflection_metallic)
        .field("reflection_fresnel", p.reflection_fresnel).field("conserve_energy", p.conserve_energy)
        .field("irid", p.irid).field("irid_thickness", p.irid_thickness).field("irid_turbulence", p.irid_turbulence)
        .field("ior", p.ior).field("caustics", p.caustics).field("refraction", p.refraction, usual.refraction).field("uncolored", p.uncolored);
}

void dump_layer(std::string& out, const PovTextureMap& m) { Line(out, "  map").always("pattern", m.pattern).always("textures", m.textures); }

void dump_interior(std::string& out, size_t i, const Interior& in) {
    const Interior usual;
    Line(out, fmt::format("interior {}", i)).field("ior", in.ior, usual.ior).field("dispersion", in.dispersion, usual.dispersion)
        .field("dispersion_samples", in.dispersion_samples, usual.dispersion_samples).field("caustics", in.caustics).field("refraction", in.refraction, usual.refraction)
        .field("fade_distance", in.fade_distance).field("fade_power", in.fade_power).field("fade_color", in.fade_color)
        .field("attenuation_color", in.attenuation_color, usual.attenuation_color)
        .field("attenuation_distance", in.attenuation_distance, usual.attenuation_distance).field("from", in.from);
    dump_media(out, in.media);
}

}  // namespace

void dump_media(std::string& out, const std::vector<Interior::Medium>& media) {
    const Interior::Medium usual;
    for (const Interior::Medium& m : media)
        Line(out, "  medium").field("absorption", m.absorption).field("emission", m.emission).field("scattering", m.scattering)
            .field("scattering_type", m.scattering_type, usual.scattering_type).field("eccentricity", m.eccentricity)
            .field("extinction", m.extinction, usual.extinction).field("density", m.density);
}

void dump_surfaces(std::string& out, const Scene& scene) {
    for (size_t i = 0; i < scene.images.size(); ++i) dump_image(out, i, scene.images[i]);
    for (size_t i = 0; i < scene.signals.size(); ++i)
        std::visit(SignalDump(out, fmt::format("signal {}", i), scene.signals[i]), scene.signals[i].what);
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        Line(out, fmt::format("material {}", i)).field("name", m.name).field("from", m.from);
        for (const auto& layer : m.layers) std::visit([&](const auto& surface) { dump_layer(out, surface); }, layer);
    }
    for (size_t i = 0; i < scene.interiors.size(); ++i) dump_interior(out, i, scene.interiors[i]);
}

}  // namespace alidade
