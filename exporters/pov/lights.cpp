// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/lights.h"

#include "scene/queries.h"

#include <fmt/format.h>

namespace alidade::pov_export {

namespace {

constexpr double kNear = 1e-5;
constexpr double kDegrees = 180 / kPi;
/// How many points an area light gets along each side.
constexpr int kSide = 9;

/// Is light spread over a surface as glTF has it, by radiometry? (POV-Ray's own lights are colours.)
bool is_radiometric(const Light& light) {
    return light.inverse_square && !light.fade && !std::holds_alternative<ConeLight>(light.kind) && !std::holds_alternative<CylinderLight>(light.kind);
}

/// Angles whose 3u^2 - 2u^3 from cosine to cosine is nearest to KHR_lights_punctual's rim, which is x^2 of the same ramp: it begins at x = 0.2 and ends at 1.14,
/// and no more than 0.065 of the light is too much or too little.
SpotLight nearest_rim(const SpotLight& spot) {
    const double outer = std::cos(spot.outer_angle), ramp = std::max(1e-3, std::cos(spot.inner_angle) - outer);
    const auto at = [&](double x) { return std::acos(std::clamp(outer + x * ramp, -1.0, 1.0)); };
    return {at(1.14), at(0.2)};
}

void spotlight(Sdl& sdl, double radius, double falloff, double tightness) {
    sdl.line("spotlight radius", radius * kDegrees, "falloff", falloff * kDegrees, "tightness", tightness);
}

}  // namespace

LightWriter::LightWriter(const Scene& scene, Sdl& sdl, Losses& losses) : scene_(scene), sdl_(sdl), losses_(losses) {
    const Bounds bounds = world_bounds(scene);
    if (!bounds.empty() && bounds.finite() && length(bounds.extent()) > 0) size_ = length(bounds.extent()), centre_ = bounds.center();
    near_ = std::max(size_ * kNear, 1e-9);   // POV-Ray takes less than 1e-10 for no fading
}

Expression LightWriter::colour(const Light& light) const {
    if (!is_radiometric(light)) return {light.intensity};
    if (std::holds_alternative<DirectionalLight>(light.kind)) return {light.intensity / kPi};
    double area = 1;
    if (const auto* a = std::get_if<AreaLight>(&light.kind))   // seen from afar: radiance times the area that is seen
        area = a->form == AreaLight::Form::rectangle ? a->width * a->height : kPi * a->radius * a->radius;
    return {light.intensity * (area / (2 * kPi * near_ * near_))};
}

void LightWriter::fade(const Light& light) {
    if (light.fade) sdl_.line("fade_distance", light.fade->distance, "fade_power", light.fade->power);
    else if (is_radiometric(light) && !std::holds_alternative<DirectionalLight>(light.kind)) sdl_.line("fade_distance", near_, "fade_power 2");
}

void LightWriter::tell_losses(const Light& light) {
    losses_.add("ranges of lights", std::isfinite(light.range), "light that goes on");
    losses_.add("rims of spot lights", std::holds_alternative<SpotLight>(light.kind), "rims that differ by up to 6.5 % of the light");
    losses_.add("lights with an extent", std::holds_alternative<AreaLight>(light.kind), fmt::format("{0} x {0} points", kSide));
}

void LightWriter::kind(const Light& light, const Transform& to_parent) {
    const auto* spot = std::get_if<SpotLight>(&light.kind);
    const auto* cone = std::get_if<ConeLight>(&light.kind);
    const auto* round = std::get_if<CylinderLight>(&light.kind);
    const auto* area = std::get_if<AreaLight>(&light.kind);
    const bool directional = std::holds_alternative<DirectionalLight>(light.kind), flat = area && area->form != AreaLight::Form::sphere;
    if (directional || (light.parallel && !round)) sdl_.line("parallel");
    if (spot) spotlight(sdl_, nearest_rim(*spot).inner_angle, nearest_rim(*spot).outer_angle, 0);
    else if (cone) spotlight(sdl_, cone->radius, cone->falloff, cone->tightness);
    else if (round) sdl_.line("cylinder radius", round->radius, "falloff", round->falloff, "tightness", round->tightness);
    else if (flat) spotlight(sdl_, kPi / 2, kPi / 2, 1);   // brightness falls with the cosine
    if (directional || light.parallel || spot || cone || round || flat) sdl_.line("point_at", to_parent.translation - to_parent.linear[2]);
}

void LightWriter::grid(const Light& light, const Transform& to_parent) {
    if (const auto* area = std::get_if<AreaLight>(&light.kind)) {
        const bool flat = area->form == AreaLight::Form::rectangle;
        const double width = flat ? area->width : 2 * area->radius, height = flat ? area->height : 2 * area->radius;
        sdl_.line("area_light", to_parent.vector({width, 0, 0}), ",", to_parent.vector({0, height, 0}), ",", kSide, ",", kSide);
        sdl_.line("adaptive 1 area_illumination on");
        if (!flat) sdl_.line(area->form == AreaLight::Form::sphere ? "circular orient" : "circular");
        return;
    }
    if (!light.shadow_grid) return;
    const ShadowGrid& g = *light.shadow_grid;
    sdl_.line("area_light", to_parent.vector(g.axis1), ",", to_parent.vector(g.axis2), ",", g.size1, ",", g.size2);
    if (g.adaptive >= 0) sdl_.line("adaptive", g.adaptive);
    if (g.jitter) sdl_.line("jitter");
    if (g.circular) sdl_.line("circular");
    if (g.orient) sdl_.line("orient");
    if (g.illuminates) sdl_.line("area_illumination on");
}

void LightWriter::begin(const Light& light, const Transform& to_parent) {
    tell_losses(light);
    sdl_.comment(light.name);
    sdl_.begin("light_source");
    sdl_.line(to_parent.translation, ",", colour(light));
    kind(light, to_parent);
    grid(light, to_parent);
    fade(light);
    if (light.shadowless) sdl_.line("shadowless");
    if (!light.media_interaction) sdl_.line("media_interaction off");
}

void LightWriter::write_directional(const Light& light, const Transform& to_world) {
    constexpr double kAway = 10;   // times the size of the scene: parallel light begins at the plane through its place
    const Vec3 back = normalized(to_world.linear[2]);
    Transform placed;
    placed.translation = centre_ + back * (kAway * size_), placed.linear[2] = back * (kAway * size_);
    begin(light, placed);
    sdl_.end();
}

/// Over the camera's left shoulder.
void LightWriter::write_default_sun(const Camera& camera) {
    const Vec3 towards = normalized(normalized(camera.direction) * 2.0 + normalized(camera.right) - normalized(camera.up) * 1.5);
    Light sun;
    sun.name = "default sun", sun.kind = DirectionalLight(), sun.intensity = Color(2);
    Transform turned;
    turned.linear[2] = -towards;
    write_directional(sun, turned);
}

}  // namespace alidade::pov_export
