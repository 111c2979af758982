// SPDX-License-Identifier: Apache-2.0
#include "core/draws.h"
#include "eval/shapes/shape_ops.h"
#include "numerics/exact.h"
#include "numerics/rows.h"

#include <fmt/format.h>

namespace alidade::numerics {

namespace {

/// A surface x^2 / a^2 + k y^2 + z^2 / c^2 + l y = m, for the shapes below; its exact crossings are a quadratic's.
struct Kind {
    const char* name;
    ShapeGeometry shape;
    double xx, yy, zz, y, constant;
    double size;   ///< of what is aimed at
};

std::vector<Kind> kinds() {
    constexpr double kLong = 1e6;
    Quadric ellipsoid{Vec3(1, 1 / (kLong * kLong), 1), Vec3(0), Vec3(0), -1}, paraboloid{Vec3(1, 0, 1), Vec3(0), Vec3(0, -1, 0), 0};
    return {{"open cylinder", Cylinder{Vec3(0, -8, 0), Vec3(0, 8, 0), 1, true}, 1, 0, 1, 0, -1, 4},
            {"open cone", Cone{Vec3(0, 0, 0), Vec3(0, 8, 0), 0, 8, true}, 1, -1, 1, 0, 0, 4},
            {"ellipsoid 1:1e6", ellipsoid, 1, ellipsoid.squares.y, 1, 0, -1, 4},
            {"paraboloid", paraboloid, 1, 0, 1, -1, 0, 4}};
}

struct QuadraticForm {
    Exact a, b, c;   ///< a t^2 + 2 b t + c
};

QuadraticForm form(const Kind& k, const Ray& ray) {
    const ExactVec o(ray.origin), d(ray.dir);
    const Exact xx = exact(k.xx), yy = exact(k.yy), zz = exact(k.zz), y = exact(k.y);
    return {xx * d.x * d.x + yy * d.y * d.y + zz * d.z * d.z, xx * o.x * d.x + yy * o.y * d.y + zz * o.z * d.z + y * d.y / 2,
            xx * o.x * o.x + yy * o.y * o.y + zz * o.z * o.z + y * o.y + exact(k.constant)};
}

/// The roots within the shape, and whether the ends of the shape, or a tangent, leave that open to the last digits.
std::vector<Exact> exact_crossings(const Kind& k, const Ray& ray, double unit, bool& undecided) {
    const QuadraticForm q = form(k, ray);
    const Exact discriminant = q.b * q.b - q.a * q.c, near_tangent = abs(q.b) * exact(16 * unit) + abs(q.a) * exact(16 * unit);
    undecided = abs(discriminant) <= near_tangent || abs(q.a) < 1e-9;
    std::vector<Exact> within;
    for (const Exact& t : quadratic_roots(q.a, q.b, q.c)) {
        const Exact y = exact(ray.origin.y) + t * exact(ray.dir.y);
        const Bounds b = find_shape(k.shape)->bounds(k.shape);
        for (const double end : {b.min.y, b.max.y}) undecided = undecided || (std::isfinite(end) && abs(y - exact(end)) < exact(1e-6));
        if (y >= exact(std::max(b.min.y, -1e30)) && y <= exact(std::min(b.max.y, 1e30))) within.push_back(t);
    }
    return within;
}

/// Between the normal at the computed point and the true one at the true point; radians.
double normal_error(const Kind& k, const ShapeOps& ops, const Ray& ray, const Crossing& at, const Exact& t) {
    const ExactVec p = ExactVec(ray.origin) + ExactVec(ray.dir) * t;
    const ExactVec n(exact(k.xx) * p.x, exact(k.yy) * p.y + exact(k.y) / 2, exact(k.zz) * p.z);
    const ExactVec m(ops.normal_at(k.shape, ray.at(at.t), at.part));
    const Exact chord = length(n * (1 / length(n)) - m * (1 / length(m)));
    return chord.get_d();
}

}  // namespace

Check quadric_cancel() {
    const auto all = std::make_shared<std::vector<Kind>>(kinds());
    return [all](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(9, 0, number));
        const Kind& k = (*all)[number % all->size()];
        const double distance = std::pow(10, draws.uniform(1, 6));
        tally.at(NumericsScale::distance, distance);
        const Vec3 aim = draws.in_box(Vec3(-1), Vec3(1)) * Vec3(1, k.size, 1) + Vec3(0, k.yy == 0 && k.y == 0 ? 0 : k.size, 0);
        Ray ray;
        ray.origin = aim + draws.direction() * distance, ray.dir = normalized(aim - ray.origin), ray.tmin = -kInf;
        bool undecided = false;
        const std::vector<Exact> t = exact_crossings(k, ray, ulp(distance), undecided);
        if (undecided) return;
        const ShapeOps& ops = *find_shape(k.shape);
        const Crossings got = ops.crossings(k.shape, ray);
        const auto what = [&] {
            return fmt::format("{}; ray <{}, {}, {}> + t <{}, {}, {}>: {} crossings of {}", k.name, ray.origin.x, ray.origin.y, ray.origin.z, ray.dir.x, ray.dir.y, ray.dir.z, got.count, t.size());
        };
        tally.decide(size_t(got.count) == t.size(), what);
        if (size_t(got.count) != t.size()) return;
        for (size_t i = 0; i < t.size(); ++i) {
            tally.measure(ulps(got.at[i].t, t[i], std::max(std::abs(t[i].get_d()), distance)), 4, what);
            if (distance < 100) tally.decide(normal_error(k, ops, ray, got.at[i], t[i]) <= 1e-12, what);
        }
    };
}

}  // namespace alidade::numerics
