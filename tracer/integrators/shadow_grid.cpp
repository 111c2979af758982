// SPDX-License-Identifier: Apache-2.0
#include "tracer/integrators/shadow_grid.h"

#include "tracer/integrators/direct_light.h"

namespace alidade {
namespace {

/// Two vectors across `to_light`, unit: the grid of an `orient`ed light faces the point that it lights.
void facing_axes(const Vec3& to_light, Vec3& first, Vec3& second) {
    constexpr double kNearlyAlong = 0.01;
    const bool along_z = std::abs(std::abs(to_light.z) - 1) < kNearlyAlong;
    first = normalized(cross(to_light, along_z ? Vec3(0, 1, 0) : Vec3(0, 0, 1)));
    second = normalized(cross(to_light, first));
}

/// A place of the grid from 0 to `size` - 1, as a number around 0.
double centred(double place, int size, double centre) { return size > 1 ? place / (size - 1) - centre : 0; }

/// How many points of the light's grid are asked where all have the same value: then the mean is that value, bit for bit (a sum of four equal numbers is exact).
uint32_t asked_of_equal(GridScratch& scratch, const ShadowGrid& grid, size_t index) {
    auto& known = scratch.asked_of_equal;
    if (known.size() <= index) known.resize(index + 1);
    if (known[index] == 0) GridMean(grid, scratch, [&](int, int) { return ++known[index], Color(0); })();
    return known[index];
}

/// Is it plain without a ray that all of the light comes through?
bool is_open(const Tracing& tracing, const Occluders& among, const RayState& state, size_t index) {
    const CompiledScene& scene = tracing.scene;
    return among.none() && (!scene.filters_light || state.inside.empty()) && (index >= scene.projectors.size() || !scene.projectors[index]);
}

}  // namespace

GridPoints::GridPoints(const PlacedLight& light, const Vec3& to_light)
    : light_(light), grid_(*light.light.shadow_grid), axis1_(light.to_world.vector(grid_.axis1)), axis2_(light.to_world.vector(grid_.axis2)) {
    if (!grid_.orient) return;
    const double size = length(axis1_);
    facing_axes(to_light, axis1_, axis2_);
    axis1_ *= size, axis2_ *= size;
}

Vec3 GridPoints::offset(double u, double v) const {
    const bool round = grid_.circular || grid_.orient;
    const double centre = round ? 0.499 : 0.5;   // not on the middle itself, which has no direction
    double a = centred(u, grid_.size1, centre), b = centred(v, grid_.size2, centre);
    if (const double square = round ? a * a + b * b : 0; square > 0) {
        const double k = std::max(std::abs(a), std::abs(b)) / std::sqrt(square);
        a *= k, b *= k;
    }
    return axis1_ * a + axis2_ * b;
}

/// From the point p to the place `offset` of the light. Parallel light comes along the line from there to where the light points at.
Vec3 GridPoints::towards(const Vec3& p, const Illumination& arriving, const Vec3& offset) const {
    if (!light_.light.parallel) return arriving.direction * arriving.distance + offset;
    const Vec3 along = normalized(offset - light_.to_world.vector(Vec3(0, 0, -1)));
    return along * dot(light_.position + offset - p, along);
}

std::optional<Bounds> GridPoints::box(const Vec3& p, const Illumination& arriving) const {
    if (light_.light.parallel) return std::nullopt;
    // Half of the grid, what it is off its middle, and what jitter adds.
    const auto reach = [&](int size) { return size > 1 ? 0.502 + (grid_.jitter ? 0.5 / (size - 1) : 0) : 0; };
    const Vec3 centre = p + arriving.direction * arriving.distance, half = glm::abs(axis1_) * reach(grid_.size1) + glm::abs(axis2_) * reach(grid_.size2);
    return Bounds{centre - half, centre + half};
}

namespace {

/// Rays from one point: they begin in two places, one a side of its surface.
class RaysFrom {
  public:
    explicit RaysFrom(const ShadePoint& point) : point_(point) {}

    Ray towards(const Vec3& direction, double distance) {
        Origin& origin = origins_[dot(direction, point_.geometric_normal) < 0];
        if (!origin.known) origin.at = spawn_ray(point_, direction).origin, origin.known = true;
        Ray ray;
        ray.origin = origin.at, ray.dir = direction;
        ray.tmax = distance;
        return ray;
    }

  private:
    struct Origin {
        Vec3 at{0};
        bool known = false;
    };
    const ShadePoint& point_;
    Origin origins_[2];
};

/// The mean over the grid of what comes through to `point`, of the light `full`, from `tracing.scene.lights[index]`.
Color through_grid(Tracing& tracing, const ShadePoint& point, const RayState& state, size_t index, const Illumination& arriving, const Color& full) {
    constexpr uint64_t kGridBranch = uint64_t(1) << 41;   // behind the branches of rays
    const PlacedLight& light = tracing.scene.lights[index];
    const ShadowGrid& grid = *light.light.shadow_grid;
    const GridPoints points(light, arriving.direction);
    const SampleKey key = state.key.child(kGridBranch + index);
    const auto place = points.box(point.position, arriving);
    Occluders* among = place && tracing.occluders.find(tracing.scene, point, *place) ? &tracing.occluders : nullptr;
    if (among && is_open(tracing, *among, state, index)) return tracing.stats.shadow_rays += asked_of_equal(tracing.grid, grid, index), full;
    RaysFrom rays(point);
    return GridMean(grid, tracing.grid, [&](int u, int v) {
        const Vec2 jitter = grid.jitter ? key.pair(uint64_t(u) * uint64_t(grid.size2) + uint64_t(v)) - Vec2(0.5) : Vec2(0);
        const Vec3 to_light = points.towards(point.position, arriving, points.offset(u + jitter.x, v + jitter.y));
        const double distance = length(to_light);
        const Vec3 direction = to_light / distance;
        const auto way = way_to_light(tracing, point, index, direction, distance - light.light.clearance);
        if (!way) return Color(0);
        ++tracing.stats.shadow_rays;
        if (!(*way > 0)) return full;
        Ray ray = rays.towards(direction, *way);
        return full * visible_along<true>(tracing, ray, state, index, among);
    })();
}

/// What the surface sends on to the eye, shadows aside, of the light of a grid that illuminates: the plain mean of what comes from its points.
Color scattered_from_grid(const PlacedLight& light, const ShadePoint& point, const Surface& surface, const Illumination& arriving) {
    const ShadowGrid& grid = *light.light.shadow_grid;
    const GridPoints points(light, arriving.direction);
    Color sum(0);
    for (int u = 0; u < grid.size1; ++u)
        for (int v = 0; v < grid.size2; ++v) {
            const Vec3 offset = points.offset(u, v);
            const Illumination from_point = illuminate(light, point.position - offset, Vec2(0));   // the light moved by the offset
            sum += from_point.irradiance * surface.scatter(from_point.direction, !light.light.shadowless);
        }
    return sum / (double(grid.size1) * grid.size2);
}

}  // namespace

Color light_from_grid(Tracing& tracing, const ShadePoint& point, const Surface& surface, const RayState& state, size_t index, const Illumination& arriving, bool shadows) {
    const PlacedLight& light = tracing.scene.lights[index];
    shadows = shadows && !light.light.shadowless;
    if (light.light.shadow_grid->illuminates) {
        const Color scattered = scattered_from_grid(light, point, surface, arriving);
        return shadows && !is_nothing(scattered) ? scattered * through_grid(tracing, point, state, index, arriving, Color(1)) : scattered;
    }
    if (is_black(arriving.irradiance)) return Color(0);
    const Color scattered = surface.scatter(arriving.direction, !light.light.shadowless);
    if (!shadows || is_black(scattered)) return scattered * arriving.irradiance;
    return scattered * through_grid(tracing, point, state, index, arriving, arriving.irradiance);
}

}  // namespace alidade
