// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/lights.h"

#include "scene/queries.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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

/// A light whose rim is 3u^2 - 2u^3 of the ramp from x = `begin` to x = `end`.
struct RimPart {
    double share, begin, end;
};
/// Together they are nearest to KHR_lights_punctual's rim, which is x^2 and ends with a kink at x = 1: no more than 0.027 of the light is too much or too little.
/// (The best of one part is off by 0.061, that of three by 0.017.)
constexpr std::array<RimPart, 2> kRim{{{0.65445, 0.1088, 1.0480}, {0.34555, 0.6530, 1.0623}}};
/// No cosine is above 1: where the ramp ends at the axis, or nearly, the parts end with it, and it takes three. Off by 0.031.
/// (The best of two is off by 0.037, but dark where the rim begins: three times the FLIP.)
constexpr std::array<RimPart, 3> kRimToAxis{{{0.4509, 0.00575, 1}, {0.33878, 0.42365, 1}, {0.21032, 0.86088, 1}}};
constexpr std::array<RimPart, 1> kNarrowRim{{{1, 0.2045, 1.1407}}};

/// Of the cosines: a rim of less looks hard.
constexpr double kNarrowest = 1e-3;

struct Rim {
    std::span<const RimPart> parts;
    double outer, ramp;   ///< cosines: where it begins, and how far it goes
    double light;         ///< of the spot's, at its end
};

Rim rim_of(const SpotLight& spot) {
    const double outer = std::cos(spot.outer_angle), width = std::cos(spot.inner_angle) - outer, ramp = std::max(kNarrowest, width);
    const double axis = (1 - outer) / ramp;   // where the ramp is cut off
    if (width <= kNarrowest && axis >= kNarrowRim[0].end) return {kNarrowRim, outer, ramp, 1};
    if (axis >= kRim[1].end) return {kRim, outer, ramp, 1};
    const double reached = std::min(axis, 1.0);
    return {kRimToAxis, outer, ramp * reached, reached * reached};   // a part of a parabola is one
}

SpotLight angles_of(const Rim& rim, const RimPart& part) {
    const auto at = [&](double x) { return std::acos(std::clamp(rim.outer + x * rim.ramp, -1.0, 1.0)); };
    return {at(part.end), at(part.begin)};
}

/// The most by which the parts together differ from the rim, of the spot's light.
double most_off(const Rim& rim) {
    constexpr int kSteps = 500;
    double most = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const double x = double(i) / kSteps;
        double sum = 0;
        for (const RimPart& part : rim.parts) {
            const double u = std::clamp((x - part.begin) / (part.end - part.begin), 0.0, 1.0);
            sum += part.share * u * u * (3 - 2 * u);
        }
        most = std::max(most, std::abs(sum - x * x));
    }
    return most * rim.light;
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

Expression LightWriter::colour(const Light& light, size_t part) const {
    if (!is_radiometric(light)) return {light.intensity};
    if (std::holds_alternative<DirectionalLight>(light.kind)) return {light.intensity / kPi};
    double seen = 1;
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
        const Rim rim = rim_of(*spot);
        seen = rim.parts[part].share * rim.light;
    }
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
    if (const size_t several = parts(light); several > 1)
        losses_.add("rims of spot lights", 1, fmt::format("{} lights, whose rims differ by up to {:.1f} % of the light", several, 100 * most_off(rim_of(std::get<SpotLight>(light.kind)))));
    losses_.add("lights with an extent", std::holds_alternative<AreaLight>(light.kind), fmt::format("{0} x {0} points", kSide));
}

size_t LightWriter::parts(const Light& light) {
    const auto* spot = std::get_if<SpotLight>(&light.kind);
    return spot ? rim_of(*spot).parts.size() : 1;
}

void LightWriter::kind(const Light& light, const Transform& to_parent, size_t part) {
    const auto* spot = std::get_if<SpotLight>(&light.kind);
    const auto* cone = std::get_if<ConeLight>(&light.kind);
    const auto* round = std::get_if<CylinderLight>(&light.kind);
    const auto* area = std::get_if<AreaLight>(&light.kind);
    const bool directional = std::holds_alternative<DirectionalLight>(light.kind), flat = area && area->form != AreaLight::Form::sphere;
    if (directional || (light.parallel && !round)) sdl_.line("parallel");
    if (spot) {
        const Rim rim = rim_of(*spot);
        const SpotLight angles = angles_of(rim, rim.parts[part]);
        spotlight(sdl_, angles.inner_angle, angles.outer_angle, 0);
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
