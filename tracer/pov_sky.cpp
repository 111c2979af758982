// SPDX-License-Identifier: Apache-2.0
#include "tracer/pov_sky.h"

#include "eval/noise/noise.h"
#include "tracer/textures.h"

namespace alidade {
namespace {

/// How far a ray that hits nothing goes, for a fog.
constexpr double kFarAway = 2e10;

/// As of version 3.7: each pigment is a filter for what is behind it.
SkyOver filtered_sky(const CompiledScene& scene, const SkySphere& sky, const Vec3& at, const SkyOver& behind) {
    Color sum(0), through(1);
    double shows = behind.shows;
    for (size_t i = sky.pigments.size(); i-- > 0;) {
        const PigmentColor c = scene.textures->pigment(sky.pigments[i], at);
        sum += c.color * through * sky.emission * (1 - c.filter - c.transmit);
        const Color passed = c.color * c.filter + Color(c.transmit);
        through *= passed, shows *= pov_grey(passed);
    }
    return {sum + behind.color * through, shows};
}

/// Before: the colours behind are dimmed by numbers, and only the background is filtered.
Color mixed_sky(const CompiledScene& scene, const SkySphere& sky, const Vec3& at, const Color& background) {
    Color sum(0), color(1);
    double left = 1, filter = 1, transmit = 1;
    for (size_t i = sky.pigments.size(); i-- > 0;) {
        const PigmentColor c = scene.textures->pigment(sky.pigments[i], at);
        sum += c.color * (left * (1 - c.filter - c.transmit));
        left *= c.filter + c.transmit;
        color *= c.color, filter *= c.filter, transmit *= c.transmit;
    }
    return sum + background * (color * filter + Color(transmit));
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
double optical_distance(const Fog& fog, NoiseGenerator noise, const Vec3& origin, const Vec3& direction, double distance) {
    double length = distance;
    if (const auto& t = fog.turbulence) {
        constexpr double kUnseen = 1e-17;   // what is less is lost beside 1
        const double near = std::exp(-distance / fog.distance), most = t->octaves * std::abs(fog.turbulence_depth);   // noise does not pass 1
        if (!(near * most < kUnseen && std::abs(t->omega) <= 1)) {
            const Vec3 middle = (origin + direction * (distance / 2)) * t->amount;
            length *= 1 - near * std::min(1.0, turbulence(middle, *t, noise) * fog.turbulence_depth);
        }
    }
    if (!fog.ground) return length;
    const Vec3 up = normalized(fog.up);
    const auto height = [&](const Vec3& p) { return (dot(p, up) - fog.offset) / fog.altitude; };
    return length * ground_density(height(origin), height(origin + direction * distance));
}

}  // namespace

Color pov_sky(const CompiledScene& scene, const Vec3& direction) {
    const SkySphere& sky = *scene.scene.atmosphere.sky;
    const Vec3 at = scene.sky_from_world.point(direction);   // as if it were a point: the sky can be shifted
    const SkyOver background{scene.scene.atmosphere.background, 1};
    return scene.scene.settings.filter_dims_by_colour ? mixed_sky(scene, sky, at, background.color) : filtered_sky(scene, sky, at, background).color;
}

SkyOver pov_sky_over(const CompiledScene& scene, const Vec3& direction, bool mirrored) {
    const Atmosphere& air = scene.scene.atmosphere;
    const SkyOver background{mirrored ? air.background_mirrored : air.background_over, air.background_shows};
    if (!air.sky || air.sky->pigments.empty()) return background;
    const Vec3 at = scene.sky_from_world.point(direction);   // as if it were a point: the sky can be shifted
    if (!scene.scene.settings.filter_dims_by_colour) return filtered_sky(scene, *air.sky, at, background);
    return mirrored ? SkyOver{mixed_sky(scene, *air.sky, at, background.color), 0} : SkyOver();   // before 3.7, a sky is all missing
}

namespace {

/// How much of a rainbow is seen at its place around the axis: less and less between the falloff and the end of the arc.
double share_of_arc(const Rainbow& bow, const Vec3& axis, const Vec3& direction) {
    const Vec3 right = normalized(cross(axis, normalized(bow.up)));
    const double x = dot(direction, right), y = dot(direction, cross(right, axis)), l = std::hypot(x, y);
    if (!(l > 0)) return 1;
    const double away = std::acos(std::clamp(y / l, -1.0, 1.0)), end = bow.arc_angle * kPi / 360, full = std::min(bow.falloff_angle * kPi / 360, end);
    if (away > end) return 0;
    if (away <= full) return 1;
    const double u = (away - full) / (end - full);
    return 1 - u * u * (3 - 2 * u);
}

/// One rainbow; nothing where it is not.
std::optional<Haze> rainbow(const CompiledScene& scene, const Rainbow& bow, const Vec3& direction, double distance) {
    if (!bow.colors || !(bow.width != 0)) return std::nullopt;
    const Vec3 axis = normalized(bow.direction);
    const double width = bow.width * kPi / 180, at = (std::acos(std::clamp(dot(axis, direction), -1.0, 1.0)) - bow.angle * kPi / 180) / width + 0.5;
    if (!(at >= 0 && at < 1)) return std::nullopt;
    const double share = share_of_arc(bow, axis, direction);
    if (share <= 0) return std::nullopt;
    const PigmentColor c = scene.textures->pigment(*bow.colors, Vec3(at, 0, 0));
    const double passes = bow.distance != 0 ? std::exp(-distance / bow.distance) : 0, left = std::max(passes, 1 - share * (1 - c.transmit)), filter = c.filter * (1 - left);
    return Haze{c.color * (1 - left), (Color(1 - filter) + c.color * filter) * left, left * c.transmit};
}

Haze rainbows(const CompiledScene& scene, const Vec3& direction, double distance) {
    Haze sum{Color(0), Color(0), 1};
    int seen = 0;
    for (const Rainbow& bow : scene.scene.atmosphere.rainbows)
        if (const auto one = rainbow(scene, bow, direction, distance)) sum.added += one->added, sum.kept += one->kept, sum.shows *= one->shows, ++seen;
    return seen ? Haze{sum.added / double(seen), sum.kept / double(seen), sum.shows} : Haze();
}

}  // namespace

Haze haze(const CompiledScene& scene, const Vec3& origin, const Vec3& direction, double distance) {
    Haze out;
    if (!std::isfinite(distance)) distance = kFarAway;
    const std::vector<Fog>& fogs = scene.scene.atmosphere.fogs;
    for (size_t i = fogs.size(); i-- > 0;) {
        const Fog& fog = fogs[i];
        if (!(fog.distance != 0)) continue;
        const double left = std::max(std::exp(-optical_distance(fog, scene.scene.settings.noise, origin, direction, distance) / fog.distance), fog.transmit);
        out.added += fog.color * (1 - left);
        const Color passed = (Color(1 - fog.filter) + fog.color * fog.filter) * left;
        out.kept *= passed, out.shows *= pov_grey(passed);
    }
    if (scene.scene.atmosphere.rainbows.empty()) return out;
    const Haze bows = rainbows(scene, direction, distance);
    return {out.added + out.kept * bows.added, out.kept * bows.kept, out.shows * bows.shows};
}

}  // namespace alidade
