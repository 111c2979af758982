// SPDX-License-Identifier: Apache-2.0
#include "core/draws.h"
#include "eval/shapes/shape_ops.h"
#include "numerics/exact.h"
#include "numerics/rows.h"

#include <fmt/format.h>

namespace alidade::numerics {

namespace {

struct SphereCase {
    Sphere sphere;
    Ray ray;
    double distance;   ///< of the ray's origin from the centre
};

/// A sphere of any size somewhere, and a ray from `distance` radii away that passes `aside` radii from its centre.
SphereCase aimed(Draws& draws, double distance, double aside) {
    SphereCase c;
    c.sphere = {draws.in_box(Vec3(-10), Vec3(10)), std::pow(10, draws.uniform(-6, 6))};
    const Vec3 from = draws.direction();
    Vec3 side, up;
    orthonormal_basis(from, side, up);
    const double phi = draws.uniform(0, 2 * kPi);
    c.ray.origin = c.sphere.center + (from * distance + (side * std::cos(phi) + up * std::sin(phi)) * aside) * c.sphere.radius;
    c.ray.dir = from * -draws.uniform(0.1, 10), c.ray.tmin = -kInf;
    c.distance = distance * c.sphere.radius + length(c.sphere.center);
    return c;
}

std::string text(const SphereCase& c, int count) {
    const auto& [o, d] = std::pair(c.ray.origin, c.ray.dir);
    return fmt::format("sphere <{}, {}, {}>, {}; ray <{}, {}, {}> + t <{}, {}, {}>: {} crossings", c.sphere.center.x, c.sphere.center.y, c.sphere.center.z, c.sphere.radius, o.x, o.y, o.z, d.x, d.y, d.z, count);
}

/// How far the line passes inside of the sphere, exactly.
Exact depth(const SphereCase& c) {
    const ExactVec d(c.ray.dir), to = ExactVec(c.sphere.center) - ExactVec(c.ray.origin);
    return exact(c.sphere.radius) - length(cross(to, d)) / length(d);
}

std::vector<Exact> exact_crossings(const SphereCase& c) {
    const ExactVec d(c.ray.dir), o = ExactVec(c.ray.origin) - ExactVec(c.sphere.center);
    const Exact r = exact(c.sphere.radius);
    return quadratic_roots(dot(d, d), dot(o, d), dot(o, o) - r * r);
}

Crossings found(const SphereCase& c) { return find_shape(c.sphere)->crossings(c.sphere, c.ray); }

}  // namespace

Check sphere_far() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(7, 0, number));
        const double distance = 4 * std::pow(10, draws.uniform(0, 11.4));
        const SphereCase c = aimed(draws, distance, draws.uniform(0, 1.1));
        tally.at(NumericsScale::distance, distance);
        const Crossings got = found(c);
        const auto what = [&] { return text(c, got.count); };
        const std::vector<Exact> t = exact_crossings(c);
        const bool close = abs(depth(c)) <= 4 * ulp(c.distance);
        tally.decide(close || size_t(got.count) == t.size(), what);
        if (size_t(got.count) != t.size()) return;
        for (size_t i = 0; i < t.size(); ++i) tally.measure(ulps(got.at[i].t, t[i], t[i].get_d()), 4, what);
    };
}

Check sphere_tangent() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(8, 0, number));
        const double aside = 1 - draws.sign() * std::pow(10, draws.uniform(-14, -3));
        const SphereCase c = aimed(draws, std::pow(10, draws.uniform(0.5, 3)), aside);
        tally.at(NumericsScale::silhouette, std::abs(1 - aside));
        const Exact inside = depth(c);
        if (abs(inside) <= 4 * ulp(c.distance)) return;
        const Crossings got = found(c);
        const auto what = [&] { return text(c, got.count); };
        tally.decide(got.count == (inside > 0 ? 2 : 0), what);
        if (inside < 0 || got.count != 2) return;
        const std::vector<Exact> t = exact_crossings(c);
        for (size_t i = 0; i < 2; ++i) tally.measure(ulps(got.at[i].t, t[i], t[i].get_d()), 4, what);
    };
}

}  // namespace alidade::numerics
