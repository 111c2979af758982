// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's area_light: soft shadows of a grid of points.
#pragma once

#include "tracer/integrators/integrator.h"

namespace alidade {

/// The points of a light's grid as they lie for one point of the scene.
class GridPoints {
  public:
    /// `to_light` is the unit direction to the light's centre: an `orient`ed grid turns with it.
    GridPoints(const PlacedLight& light, const Vec3& to_light);
    /// From the light's centre to the place (u, v) of the grid, which is numbered from 0 along both axes; between the numbers lies what jitter reaches.
    Vec3 offset(double u, double v) const;
    Vec3 towards(const Vec3& p, const Illumination& arriving, const Vec3& offset) const;
    /// Around all of the light that the point p is lit from; nothing where that depends on the place of the grid, as it does of parallel light.
    std::optional<Bounds> box(const Vec3& p, const Illumination& arriving) const;

  private:
    const PlacedLight& light_;
    const ShadowGrid& grid_;
    Vec3 axis1_, axis2_;
};

/// The mean of a value over the grid. A rectangle of it is the mean of its four corners, unless they differ or `adaptive` wants more: then of its four quarters.
/// `seen` is scratch. `value(u, v)` is asked at most once for each point.
/// Source   POV-Ray 3.7 reference, 3.4.4.6 "Area Lights"; its weights and the threshold were found by probing.
template <class Value> class GridMean {
  public:
    GridMean(const ShadowGrid& grid, GridScratch& seen, Value value) : grid_(grid), seen_(seen), value_(value) { seen_.begin(size_t(grid.size1) * size_t(grid.size2)); }
    Color operator()() { return mean({0, grid_.size1 - 1}, {0, grid_.size2 - 1}, 0); }

  private:
    struct Range {
        int first, last;
        int middle() const { return (first + last) / 2; }
        int above_middle() const { return (first + last + 1) / 2; }
        Range low() const { return {first, middle()}; }
        Range high() const { return {above_middle(), last}; }
    };

    Color at(int u, int v) {
        GridScratch::Point& point = seen_.points[size_t(u) * size_t(grid_.size2) + size_t(v)];
        if (point.round != seen_.round) point = {value_(u, v), seen_.round};
        return point.value;
    }
    static bool differ(const Color& a, const Color& b) {
        constexpr double kMost = 0.1;
        return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) > kMost;
    }
    bool divides(int level, const Color (&c)[4]) const {
        if (grid_.adaptive < 0 || level < grid_.adaptive) return true;
        return differ(c[0], c[1]) || differ(c[1], c[2]) || differ(c[2], c[3]) || differ(c[3], c[0]);
    }
    Color mean(Range u, Range v, int level) {
        const bool small = u.last - u.first <= 1 && v.last - v.first <= 1;
        if (small || grid_.adaptive >= 0) {
            const Color corners[] = {at(u.first, v.first), at(u.last, v.first), at(u.last, v.last), at(u.first, v.last)};   // around the rectangle
            if (small || !divides(level, corners)) return (corners[0] + corners[1] + corners[2] + corners[3]) * 0.25;
        }
        return (mean(u.low(), v.low(), level + 1) + mean(u.high(), v.low(), level + 1) + mean(u.low(), v.high(), level + 1) + mean(u.high(), v.high(), level + 1)) * 0.25;
    }

    const ShadowGrid& grid_;
    GridScratch& seen_;
    Value value_;
};

/// The light of `tracing.scene.lights[index]`, which has a grid, that the surface sends on to the eye; `arriving` comes from the grid's centre.
Color light_from_grid(Tracing& tracing, const ShadePoint& point, const Surface& surface, const RayState& state, size_t index, const Illumination& arriving, bool shadows);

}  // namespace alidade
