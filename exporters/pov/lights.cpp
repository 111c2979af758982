// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/lights.h"

#include "exporters/pov/spot_rim.h"
#include "scene/queries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alidade::pov_export {

namespace {

constexpr double kNear = 1e-5;
constexpr double kDegrees = 180 / kPi;
/// Of a spot's light: what its rim differs by is told from here on.
constexpr double kTold = 5e-4;
/// How many points an area light gets along each side.
constexpr int kSide = 9;

/// Is light spread over a surface as glTF has it, by radiometry? (POV-Ray's own lights are colours.)
bool is_radiometric(const Light& light) {
    return light.inverse_square && !light.fade && !std::holds_alternative<ConeLight>(light.kind) && !std::holds_alternative<CylinderLight>(light.kind);
}

void spotlight(Sdl& sdl, double radius, double falloff, double tightness) {
    sdl.line("spotlight radius", radius * kDegrees, "falloff", falloff * kDegrees, "tightness", tightness);
}

}  // namespace

LightWriter::LightWriter(const Scene& scene, Sdl& sdl, Losses& losses) : sdl_(sdl), losses_(losses) {
    const Bounds bounds = world_bounds(scene);
    if (!bounds.empty() && bounds.finite() && length(bounds.extent()) > 0) size_ = length(bounds.extent()), centre_ = bounds.center();
    near_ = std::max(size_ * kNear, 1e-9);   // POV-Ray takes less than 1e-10 for no fading
}

Expression LightWriter::colour(const Light& light, size_t part) const {
    if (!is_radiometric(light)) return {light.intensity};
    if (std::holds_alternative<DirectionalLight>(light.kind)) return {light.intensity / kPi};
    double seen = 1;
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) seen = spot_rim(*spot).parts[part].share;
    if (const auto* a = std::get_if<AreaLight>(&light.kind))   // seen from afar: radiance times the area that is seen
        seen = a->form == AreaLight::Form::rectangle ? a->width * a->height : kPi * a->radius * a->radius;
    return {light.intensity * (seen / (2 * kPi * near_ * near_))};
}

void LightWriter::fade(const Light& light) {
    if (light.fade) sdl_.line("fade_distance", light.fade->distance, "fade_power", light.fade->power);
    else if (is_radiometric(light) && !std::holds_alternative<DirectionalLight>(light.kind)) sdl_.line("fade_distance", near_, "fade_power 2");
}

void LightWriter::tell_losses(const Light& light) {
    losses_.add("ranges of lights", std::isfinite(light.range), "light that goes on");
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
        const SpotRim rim = spot_rim(*spot);
        losses_.add("rims of spot lights", rim.off >= kTold, fmt::format("{} of POV-Ray's, off by up to {:.1f} % of the light", rim.parts.size(), 100 * rim.off));
    }
    losses_.add("lights with an extent", std::holds_alternative<AreaLight>(light.kind), fmt::format("{0} x {0} points", kSide));
}

size_t LightWriter::parts(const Light& light) {
    const auto* spot = std::get_if<SpotLight>(&light.kind);
    return spot ? spot_rim(*spot).parts.size() : 1;
}

void LightWriter::kind(const Light& light, const Transform& to_parent, size_t part) {
    const auto* spot = std::get_if<SpotLight>(&light.kind);
    const auto* cone = std::get_if<ConeLight>(&light.kind);
    const auto* round = std::get_if<CylinderLight>(&light.kind);
    const auto* area = std::get_if<AreaLight>(&light.kind);
    const bool directional = std::holds_alternative<DirectionalLight>(light.kind), flat = area && area->form != AreaLight::Form::sphere;
    if (directional || (light.parallel && !round)) sdl_.line("parallel");
    if (spot) {
        const RimPart written = spot_rim(*spot).parts[part];
        spotlight(sdl_, written.radius, written.falloff, written.tightness);
    }
    if (cone) spotlight(sdl_, cone->radius, cone->falloff, cone->tightness);
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

void LightWriter::begin(const Light& light, const Transform& to_parent, size_t part) {
    if (part == 0) tell_losses(light);
    sdl_.comment(light.name);
    sdl_.begin("light_source");
    sdl_.line(to_parent.translation, ",", colour(light, part));
    kind(light, to_parent, part);
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
