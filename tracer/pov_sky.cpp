// SPDX-License-Identifier: Apache-2.0
#include "tracer/pov_sky.h"

#include "eval/noise/noise.h"
#include "tracer/textures.h"

namespace alidade {
namespace {

/// How far a ray that hits nothing goes, for a fog.
constexpr double kFarAway = 2e10;

/// As of version 3.7: each pigment is a filter for what is behind it.
Color filtered_sky(const CompiledScene& scene, const SkySphere& sky, const Vec3& at) {
    Color sum(0), through(1);
    for (size_t i = sky.pigments.size(); i-- > 0;) {
        const PigmentColor c = scene.textures->pigment(sky.pigments[i], at);
        sum += c.color * through * sky.emission * (1 - c.filter - c.transmit);
        through *= c.color * c.filter + Color(c.transmit);
    }
    return sum + scene.scene.atmosphere.background * through;
}

/// Before: the colours behind are dimmed by numbers, and only the background is filtered.
Color mixed_sky(const CompiledScene& scene, const SkySphere& sky, const Vec3& at) {
    Color sum(0), color(1);
    double left = 1, filter = 1, transmit = 1;
    for (size_t i = sky.pigments.size(); i-- > 0;) {
        const PigmentColor c = scene.textures->pigment(sky.pigments[i], at);
        sum += c.color * (left * (1 - c.filter - c.transmit));
        left *= c.filter + c.transmit;
        color *= c.color, filter *= c.filter, transmit *= c.transmit;
    }
    return sum + scene.scene.atmosphere.background * (color * filter + Color(transmit));
}

/// The mean density of a ground fog along a line whose ends lie `start` and `end` altitudes above its offset: 1 below it, 1 / (1 + h^2) above.
double ground_density(double start, double end) {
    if (start <= 0 && end <= 0) return 1;
    if (start == end) return 1 / (start * start + 1);
    if (start <= 0) return (std::atan(end) - start) / (end - start);
    if (end <= 0) return (std::atan(start) - end) / (start - end);
    return (std::atan(start) - std::atan(end)) / (start - end);
}

/// The distance as it counts for a fog: turbulence makes it shorter, its density changes with the height.
double optical_distance(const Fog& fog, const Vec3& origin, const Vec3& direction, double distance) {
    double length = distance;
    if (fog.turbulence.amount != Vec3(0)) {
        const Vec3 middle = (origin + direction * (distance / 2)) * fog.turbulence.amount;
        length *= 1 - std::exp(-distance / fog.distance) * std::min(1.0, turbulence(middle, fog.turbulence, fog.noise) * fog.turbulence_depth);
    }
    if (!fog.ground) return length;
    const Vec3 up = normalized(fog.up);
    const auto height = [&](const Vec3& p) { return (dot(p, up) - fog.offset) / fog.altitude; };
    return length * ground_density(height(origin), height(origin + direction * distance));
}

}  // namespace

Color pov_sky(const CompiledScene& scene, const Vec3& direction) {
    const SkySphere& sky = *scene.scene.atmosphere.sky;
    const Vec3 at = scene.sky_from_world.vector(direction);
    return scene.scene.settings.filter_dims_by_colour ? mixed_sky(scene, sky, at) : filtered_sky(scene, sky, at);
}

Haze haze(const CompiledScene& scene, const Vec3& origin, const Vec3& direction, double distance) {
    Haze out;
    distance = std::min(distance, kFarAway);
    const std::vector<Fog>& fogs = scene.scene.atmosphere.fogs;
    for (size_t i = fogs.size(); i-- > 0;) {
        const Fog& fog = fogs[i];
        if (!(fog.distance != 0)) continue;
        const double left = std::max(std::exp(-optical_distance(fog, origin, direction, distance) / fog.distance), fog.transmit);
        out.added += fog.color * (1 - left);
        out.kept *= (Color(1 - fog.filter) + fog.color * fog.filter) * left;
    }
    return out;
}

}  // namespace alidade
