// SPDX-License-Identifier: Apache-2.0
/// Rays and triangles against rational arithmetic: the decision has the exact sign; t, u, v and the error bound are right.
#include "accel/triangles/kernel.h"
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/triangles/rational.h"
#include "numerics/triangles/rays.h"
#include "numerics/triangles/subjects.h"

#include <fmt/format.h>

#include <array>
#include <span>

namespace alidade::numerics {

namespace {

using Triangle = std::array<Vec3, 3>;
constexpr uint64_t kRays = 8;   // at the same triangle

/// Sizes, shapes and distances at which triangle tests fail.
struct TriangleClass {
    const char* name;
    double size;            ///< of the triangle
    double offset;          ///< of the triangle from the origin of coordinates
    double sliver;          ///< width over length
    double distance;        ///< of the ray's origin, in sizes
    double angle;           ///< between ray and plane in radians; 0: any
    double goal = 1;        ///< of t, in units of roundoff of float
    bool lattice = false;   ///< corners, origins and targets are small integers: each second ray passes exactly through an edge or a vertex
};

constexpr TriangleClass kUsual[] = {
    {"generic", 1, 0, 1, 3, 0},
    {"grazing 1e-3", 1, 0, 1, 3, 1e-3},
    {"grazing 1e-5", 1, 0, 1, 3, 1e-5},
    {"grazing 1e-9", 1, 0, 1, 3, 1e-9},
    {"far", 1, 0, 1, 1e6, 0},
    {"moved", 1, 0, 1, 200, 0},   // a little more than as far as rays are left where they are
    {"moved, grazing 1e-5", 1, 0, 1, 200, 1e-5},
    {"sliver", 1, 0, 1e-4, 3, 0},
    {"sliver, moved", 1, 0, 1e-4, 200, 0},
    {"size 1e6, origin at 1", 1e6, 0, 1, 1e-6, 0},
    {"size 1e-3 at 1", 1e-3, 1, 1, 3, 0},
    {"size 1e-5 at 1", 1e-5, 1, 1, 3, 0},
    {"lattice", 4, 4, 1, 1, 0, 1e-14 * 0x1p24, true},
};
constexpr TriangleClass kExtreme[] = {
    {"size 1e-20", 1e-20, 0, 1, 3, 0},
    {"size 1e-30", 1e-30, 0, 1, 3, 0},
    {"size 1e15", 1e15, 0, 1, 3, 0},
    {"size 1e18", 1e18, 0, 1, 3, 0},
};

Vec3 lattice_point(Draws& draws) {
    const double x = draws.below(5), y = draws.below(5), z = draws.below(5);
    return {x, y, z};
}

/// In double precision, with corners that are no floats.
Triangle random_triangle(const TriangleClass& c, Precision precision, Draws& draws) {
    if (c.lattice) {
        const Vec3 a = lattice_point(draws), b = lattice_point(draws);
        return {a, b, lattice_point(draws)};
    }
    const Vec3 center = c.offset * Vec3(1, -0.7, 0.4), along = draws.direction(), across = draws.direction();
    Triangle triangle{center, center + c.size * along, center + c.size * (draws.uniform() * along + c.sliver * across)};
    if (precision == Precision::float_)
        for (Vec3& corner : triangle) corner = Vec3(Vec3f(corner));
    return triangle;
}

/// A third of the targets lie within 1e-6 of an edge, a third on an edge or vertex as well as double can say it, a third anywhere near.
Vec3 target(const Triangle& p, Draws& draws) {
    double u = draws.uniform(-0.3, 1.3), v = draws.uniform(-0.3, 1.3);
    const uint32_t kind = draws.below(3);
    if (kind == 1) u = draws.uniform(-1e-6, 1e-6), v = draws.uniform();
    if (kind == 2) u = 0, v = draws.below(5) / 4.0;
    const uint32_t first = draws.below(3);
    const Vec3 a = p[first], b = p[(first + 1) % 3], c = p[(first + 2) % 3];
    return a + u * (b - a) + v * (c - a);
}

Ray ray_at(const Triangle& triangle, const TriangleClass& c, Draws& draws) {
    Ray ray;
    if (c.lattice) {
        ray.origin = lattice_point(draws), ray.dir = lattice_point(draws) - ray.origin;
        return ray;
    }
    const Vec3 along = normalized(triangle[1] - triangle[0]), n = normalized(cross(along, normalized(triangle[2] - triangle[0])));
    const Vec3 to = c.angle > 0 ? along + draws.sign() * c.angle * n : draws.direction();
    const Vec3 aim = target(triangle, draws);
    ray.origin = aim - c.distance * c.size * to;
    ray.dir = draws.coin() ? aim - ray.origin : to;
    return ray;
}

/// The triangle; `wide`: and two others far out at opposite corners. Their box holds every origin, so that no ray is moved to it.
TriangleMesh mesh_of(const Triangle& triangle, const TriangleClass& c, bool wide) {
    std::vector<Vec3> vertices(triangle.begin(), triangle.end());
    std::vector<Index3> triangles{{0, 1, 2}};
    if (!wide) return {c.name, vertices, triangles};
    const double reach = 4 * (c.size * std::max(c.distance, 1.0) + c.offset);
    for (const double side : {-reach, reach})
        for (int axis = 0; axis < 3; ++axis) vertices.emplace_back(side), vertices.back()[axis] *= 1.125;
    triangles.emplace_back(3, 4, 5), triangles.emplace_back(6, 7, 8);
    return {fmt::format("{}, in a wide box", c.name), vertices, triangles};
}

/// What rational arithmetic says of the local ray, which is the ray of all structures.
struct Truth {
    ExactCrossing crossing;   ///< t along the caller's ray
    bool hit = false;
    bool open = false;        ///< it begins on the triangle but for a few ulps: the crossing may be computed on either side of tmin = 0
};

Truth truth(const Ray& ray, const LocalRay& local, const Triangle& triangle) {
    Ray seen;
    seen.origin = local.origin, seen.dir = local.dir;
    Truth truth{exact_crossing(seen, triangle)};
    ExactCrossing& c = truth.crossing;
    if (c.side < 0) return truth;
    c.t = (c.t + Rational(local.shift)) * Rational(local.to_caller);
    truth.hit = c.t >= 0;
    truth.open = std::abs(c.t.get_d()) * max_abs(ray.dir) <= 8 * kUnitRoundoff<double> * max_abs(ray.origin);
    return truth;
}

void check_hit(const Hit& hit, const Truth& truth, const TriangleClass& c, const Ray& ray, const Triangle& triangle, NumericsTally& tally, const auto& what) {
    const ExactCrossing& exact = truth.crossing;
    tally.measure(relative_error(hit.t, exact.t) * 0x1p24, c.goal, what);
    tally.decide(std::max(std::abs(hit.u - exact.u.get_d()), std::abs(hit.v - exact.v.get_d())) <= 1e-6, what);
    tally.decide(within(ray.at(hit.t), hit.error.along_normal, triangle), what);
}

void check_ray(const std::vector<Built>& structures, const TriangleClass& c, const Triangle& triangle, const Ray& ray, bool wide, NumericsTally& tally) {
    const LocalRay local = local_ray(ray, structures.front().accelerator->bounds(), TriangleKernel<float, TriangleTest::exact>::kEntry);
    const Truth exact = truth(ray, local, triangle);
    if (exact.open) return;
    for (const Built& built : structures) {
        const auto what = [&] { return fmt::format("{}: side {}, t {}", built.text(ray), exact.crossing.side, exact.crossing.t.get_d()); };
        Hit found;
        for (const Hit& hit : all_hits(*built.accelerator, ray))
            if (hit.primitive == 0) found = hit;
        tally.decide(found.valid() == exact.hit && (!wide || local.shift == 0), what);
        if (found.valid() && exact.hit) check_hit(found, exact, c, ray, triangle, tally, what);
    }
}

/// A case is a triangle with its rays.
Check exact_signs(std::span<const TriangleClass> classes, uint64_t row) {
    return [classes, row](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(row, 0, number));
        const TriangleClass& c = classes[number / 4 % classes.size()];
        tally.at(NumericsScale::size, c.size), tally.at(NumericsScale::angle, c.angle);
        const Precision precision = precision_of(number % 2 == 1);
        const bool wide = number / 2 % 2 == 0;
        const Triangle triangle = random_triangle(c, precision, draws);
        if (max_abs(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) == 0) return;   // on the lattice
        const TriangleMesh mesh = mesh_of(triangle, c, wide);
        std::vector<Built> structures = built(precision, mesh);
        structures.emplace_back(Subject{&accelerators().front(), precision, false}, mesh);
        for (uint64_t i = 0; i < kRays; ++i) {
            const Ray ray = ray_at(triangle, c, draws);
            if (max_abs(ray.dir) > 0) check_ray(structures, c, triangle, ray, wide, tally);
        }
    };
}

}  // namespace

Check tri_exact() { return exact_signs(kUsual, 5); }
Check tri_underflow() { return exact_signs(kExtreme, 6); }

}  // namespace alidade::numerics
