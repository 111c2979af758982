// SPDX-License-Identifier: Apache-2.0
#include "scene/dump_line.h"

namespace alidade {

namespace {

void dump_kind(Line& line, const PointLight&) { line.word("point"); }
void dump_kind(Line& line, const SpotLight& s) { line.word("spot").always("inner_angle", s.inner_angle).always("outer_angle", s.outer_angle); }
void dump_kind(Line& line, const ConeLight& c) { line.word("cone").always("radius", c.radius).always("falloff", c.falloff).field("tightness", c.tightness); }
void dump_kind(Line& line, const DirectionalLight&) { line.word("directional"); }
void dump_kind(Line& line, const AreaLight& a) {
    const AreaLight usual;
    line.word("area").always("form", a.form).field("width", a.width, usual.width).field("height", a.height, usual.height)
        .field("radius", a.radius, usual.radius);
}
void dump_kind(Line& line, const CylinderLight& c) { line.word("cylinder").always("radius", c.radius).always("falloff", c.falloff).field("tightness", c.tightness); }
void dump_grid(Line& line, const ShadowGrid& g) {
    const ShadowGrid usual;
    line.word("shadow_grid").always("axis1", g.axis1).always("axis2", g.axis2).always("size1", g.size1).always("size2", g.size2)
        .field("adaptive", g.adaptive, usual.adaptive).field("jitter", g.jitter).field("circular", g.circular).field("orient", g.orient).field("illuminates", g.illuminates);
}

void dump_light(std::string& out, size_t i, const Light& light) {
    const Light usual;
    Line line(out, fmt::format("light {}", i));
    std::visit([&](const auto& kind) { dump_kind(line, kind); }, light.kind);
    line.field("name", light.name).field("intensity", light.intensity, usual.intensity).field("range", light.range, usual.range);
    if (light.fade) line.word("fade").always("distance", light.fade->distance).always("power", light.fade->power);
    if (light.shadow_grid) dump_grid(line, *light.shadow_grid);
    line.field("inverse_square", light.inverse_square, true).field("parallel", light.parallel).field("shadowless", light.shadowless).field("clearance", light.clearance);
    line.field("media_interaction", light.media_interaction, true).field("looks_like", light.looks_like);
    line.field("projected_through", light.projected_through).field("from", light.from);
}

void dump_camera(std::string& out, size_t i, const Camera& c) {
    const Camera usual;
    Line(out, fmt::format("camera {}", i)).always("projection", c.projection).field("name", c.name).field("location", c.location)
        .field("direction", c.direction, usual.direction).field("right", c.right, usual.right).field("up", c.up, usual.up).field("fit", c.fit)
        .field("angle", c.angle).field("vertical_angle", c.vertical_angle).field("cylinder", c.cylinder, usual.cylinder).field("aperture", c.aperture).field("focal_point", c.focal_point, usual.focal_point)
        .field("blur_samples", c.blur_samples).field("clearance", c.clearance).field("normal", c.normal).field("from", c.from);
}

void dump_animation(std::string& out, size_t i, const Animation& animation) {
    Line(out, fmt::format("animation {}", i)).field("name", animation.name);
    for (const Channel& c : animation.channels)
        Line(out, "  channel").always("node", c.target).always("path", c.path).always("interpolation", c.interpolation)
            .field("width", c.width, Channel().width).always("times", c.times).always("values", c.values);
}

void dump_fog(std::string& out, const Fog& f) {
    const Fog usual;
    const Turbulence plain;
    Line line(out, "  fog");
    line.field("ground", f.ground).field("distance", f.distance).field("offset", f.offset).field("altitude", f.altitude);
    if (const auto& t = f.turbulence) line.always("turbulence", t->amount).field("octaves", t->octaves, plain.octaves).field("omega", t->omega, plain.omega).field("lambda", t->lambda, plain.lambda);
    line.field("turbulence_depth", f.turbulence_depth, usual.turbulence_depth).field("color", f.color).field("filter", f.filter).field("transmit", f.transmit).field("up", f.up, usual.up);
}

void dump_atmosphere(std::string& out, const Atmosphere& a) {
    Line(out, "atmosphere").field("background", a.background).field("background_mirrored", a.background_mirrored).field("background_over", a.background_over).field("background_shows", a.background_shows, 1.0).field("environment", a.environment).field("environment_image", a.environment_image)
        .field("environment_strength", a.environment_strength, Atmosphere().environment_strength);
    for (const Fog& f : a.fogs) dump_fog(out, f);
    const Rainbow none;
    for (const Rainbow& r : a.rainbows)
        Line(out, "  rainbow").field("direction", r.direction, none.direction).field("up", r.up, none.up).field("angle", r.angle).field("width", r.width).field("distance", r.distance)
            .field("arc_angle", r.arc_angle, none.arc_angle).field("falloff_angle", r.falloff_angle, none.falloff_angle).field("colors", r.colors);
    if (a.sky) Line(out, "  sky").always("pigments", a.sky->pigments).field("emission", a.sky->emission, Color(1)).field("transform", a.sky->transform);
    dump_media(out, a.media);
}

void dump_settings(std::string& out, const RenderSettings& r) {
    const RenderSettings usual;
    Line(out, "settings").field("max_depth", r.max_depth).field("adc_bailout", r.adc_bailout, usual.adc_bailout)
        .field("ambient_light", r.ambient_light, usual.ambient_light).field("noise", r.noise, usual.noise).field("irid_wavelength", r.irid_wavelength, usual.irid_wavelength).field("assumed_gamma", r.assumed_gamma, usual.assumed_gamma)
        .field("srgb_coded", r.srgb_coded).field("filter_dims_by_colour", r.filter_dims_by_colour).field("see_through", r.see_through).field("follows_mirrors", r.follows_mirrors, true).field("first_box_shows", r.first_box_shows).field("shadow_clearance", r.shadow_clearance).field("default_light", r.default_light, true)
        .field("light_units", r.light_units).field("why_light_units", r.why_light_units).field("default_spp", r.default_spp, usual.default_spp)
        .field("generator", r.generator);
    if (r.lens_noise) Line(out, "lens_noise").always("variance", r.lens_noise->variance).always("confidence", r.lens_noise->confidence).always("fewest", r.lens_noise->fewest);
}

}  // namespace

std::string dump(const Scene& scene, MeshLists lists) {
    std::string out;
    for (size_t i = 0; i < scene.files.size(); ++i) Line(out, fmt::format("file {}", i)).always("path", scene.files[i].path);
    dump_settings(out, scene.settings);
    dump_atmosphere(out, scene.atmosphere);
    dump_nodes(out, scene);
    dump_shapes(out, scene, lists);
    dump_surfaces(out, scene);
    for (size_t i = 0; i < scene.lights.size(); ++i) dump_light(out, i, scene.lights[i]);
    for (size_t i = 0; i < scene.cameras.size(); ++i) dump_camera(out, i, scene.cameras[i]);
    for (size_t i = 0; i < scene.skins.size(); ++i)
        Line(out, fmt::format("skin {}", i)).field("name", scene.skins[i].name).always("joints", scene.skins[i].joints)
            .field("inverse_bind", scene.skins[i].inverse_bind);
    for (size_t i = 0; i < scene.animations.size(); ++i) dump_animation(out, i, scene.animations[i]);
    for (size_t i = 0; i < scene.functions.size(); ++i) dump_function(out, i, scene.functions[i]);
    return out;
}

}  // namespace alidade
