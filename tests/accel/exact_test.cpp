// SPDX-License-Identifier: Apache-2.0
/// Brute force, the oracle of all other tests, against rational arithmetic: the hit decision has the exact sign, t, u, v and the error bound are
/// right.
///
/// A mesh moves the origin of a ray that starts outside its box to the box, in double; the crossing of the moved ray is another one. So each
/// triangle here comes with two small ones far out at opposite corners: the box holds every origin, no ray is moved, and the decision must be exact.
#include "tests/accel/compare.h"
#include "core/draws.h"
#include "tests/accel/exact_oracle.h"
#include "tests/accel/rays.h"
#include "tests/accel/run_size.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade::test {
namespace {

constexpr uint64_t kSeed = 71;
using Triangle = std::array<Vec3, 3>;

/// Sizes, shapes and distances at which triangle tests fail (numerics research 2.2).
struct TriangleClass {
    const char* name;
    double size;      ///< of the triangle
    double offset;    ///< of the triangle from the origin of coordinates
    double sliver;    ///< width over length
    double distance;  ///< of the ray's origin, in sizes
    double angle;     ///< between ray and plane in radians; 0: any
};

constexpr TriangleClass kClasses[] = {
    {"generic", 1, 0, 1, 3, 0},
    {"grazing 1e-3", 1, 0, 1, 3, 1e-3},
    {"grazing 1e-5", 1, 0, 1, 3, 1e-5},
    {"grazing 1e-9", 1, 0, 1, 3, 1e-9},
    {"far", 1, 0, 1, 1e6, 0},
    {"sliver", 1, 0, 1e-4, 3, 0},
    {"size 1e6, origin at 1", 1e6, 0, 1, 1e-6, 0},
    {"size 1e-3 at 1", 1e-3, 1, 1, 3, 0},
    {"size 1e-5 at 1", 1e-5, 1, 1, 3, 0},
    {"size 1e-20", 1e-20, 0, 1, 3, 0},
    {"size 1e15", 1e15, 0, 1, 3, 0},
};

/// In double precision, with corners that are no floats.
Triangle random_triangle(const TriangleClass& c, Precision precision, Draws& draws) {
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
    const Vec3 along = normalized(triangle[1] - triangle[0]), n = normalized(cross(along, normalized(triangle[2] - triangle[0])));
    const Vec3 to = c.angle > 0 ? along + draws.sign() * c.angle * n : draws.direction();
    const Vec3 aim = target(triangle, draws);
    Ray ray;
    ray.origin = aim - c.distance * c.size * to;
    ray.dir = draws.coin() ? aim - ray.origin : to;
    return ray;
}

/// The triangle, and two that widen the box.
Mesh with_wide_box(const Triangle& triangle, const TriangleClass& c) {
    const double reach = 4 * (c.size * std::max(c.distance, 1.0) + c.offset);
    std::vector<Vec3> vertices(triangle.begin(), triangle.end());
    for (const double side : {-reach, reach})
        for (int axis = 0; axis < 3; ++axis) vertices.emplace_back(side), vertices.back()[axis] *= 1.125;
    return {"triangle", vertices, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}};
}

/// The worst seen in a class.
struct Worst {
    size_t rays = 0, hits = 0, edges = 0;
    double t = 0, uv = 0;
};

/// t is rounded: where it is 0 but for a few ulps of the ray's coordinates, the crossing may fall on either side of tmin = 0.
bool begins_on_triangle(const Ray& ray, const ExactCrossing& exact) {
    return exact.side >= 0 && std::abs(exact.t.get_d()) * max_abs(ray.dir) <= 8 * kUnitRoundoff<double> * max_abs(ray.origin);
}

void check(const Accelerator& accelerator, const Triangle& triangle, const Ray& ray, Worst& worst) {
    const ExactCrossing exact = exact_crossing(ray, triangle);
    const bool in_interval = exact.side >= 0 && exact.t >= 0;
    Hit of_triangle;
    for (const Hit& hit : all_hits(accelerator, ray))
        if (hit.primitive == 0) of_triangle = hit;
    if (begins_on_triangle(ray, exact)) return;
    ASSERT_EQ(of_triangle.valid(), in_interval) << "side " << exact.side << ", t " << (exact.side >= 0 ? exact.t.get_d() : 0) << ": "
                                                << describe(ray);
    ++worst.rays, worst.hits += in_interval, worst.edges += exact.side == 0;
    if (!in_interval) return;
    worst.t = std::max(worst.t, relative_error(of_triangle.t, exact.t));
    worst.uv = std::max({worst.uv, std::abs(of_triangle.u - exact.u.get_d()), std::abs(of_triangle.v - exact.v.get_d())});
    EXPECT_TRUE(within(ray.at(of_triangle.t), of_triangle.error.along_normal, triangle))
        << "the computed point is further from the plane than " << of_triangle.error.along_normal << ": " << describe(ray);
}

class Exact : public testing::TestWithParam<std::tuple<size_t, Precision>> {};

TEST_P(Exact, BruteForceDecidesAsRationalsDo) {
    const auto [index, precision] = GetParam();
    const TriangleClass& c = kClasses[index];
    Worst worst;
    for (size_t i = 0; i < run_size(1500, 60000) && !HasFatalFailure(); ++i) {
        Draws draws(RandomKey(kSeed, index, i, 0));
        const Triangle triangle = random_triangle(c, precision, draws);
        const auto accelerator = brute_force(with_wide_box(triangle, c), precision);
        for (int k = 0; k < 8 && !HasFatalFailure(); ++k) {
            SCOPED_TRACE(fmt::format("{}, seed {}, triangle {}, ray {}", c.name, kSeed, i, k));
            check(*accelerator, triangle, ray_at(triangle, c, draws), worst);
        }
    }
    fmt::print("{}: {} rays, {} hits, {} exactly on an edge; worst relative error of t {:.2g}, of u and v {:.2g}\n", c.name, worst.rays, worst.hits,
               worst.edges, worst.t, worst.uv);
    EXPECT_GT(worst.hits, worst.rays / 5) << "the test must exercise hits";
    EXPECT_LE(worst.t, 0x1p-24) << "t is good to half an ulp of float, however the ray lies";
    EXPECT_LE(worst.uv, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Triangles, Exact,
                         testing::Combine(testing::Range(size_t(0), std::size(kClasses)), testing::Values(Precision::float_, Precision::double_)),
                         [](const auto& info) {
                             return test_name(fmt::format("{}_{}", kClasses[std::get<0>(info.param)].name, name(std::get<1>(info.param))));
                         });

/// Corners and rays on a small integer lattice: every second ray passes exactly through an edge or a vertex.
TEST(ExactLattice, BruteForceDecidesAsRationalsDo) {
    const auto lattice_point = [](Draws& draws) { return Vec3(draws.below(5), draws.below(5), draws.below(5)); };
    const TriangleClass c{"lattice", 4, 4, 1, 1, 0};
    Worst worst;
    for (size_t i = 0; i < run_size(4000, 200000) && !HasFatalFailure(); ++i) {
        Draws draws(RandomKey(kSeed, 100, i, 0));
        const Triangle triangle{lattice_point(draws), lattice_point(draws), lattice_point(draws)};
        if (max_abs(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) == 0) continue;
        const auto accelerator = brute_force(with_wide_box(triangle, c), Precision::float_);
        for (int k = 0; k < 8 && !HasFatalFailure(); ++k) {
            Ray ray;
            ray.origin = lattice_point(draws), ray.dir = lattice_point(draws) - ray.origin;
            if (max_abs(ray.dir) == 0) continue;
            SCOPED_TRACE(fmt::format("lattice, seed {}, triangle {}, ray {}", kSeed, i, k));
            check(*accelerator, triangle, ray, worst);
        }
    }
    fmt::print("{} rays, {} hits, {} exactly on an edge; worst relative error of t {:.2g}\n", worst.rays, worst.hits, worst.edges, worst.t);
    EXPECT_GT(worst.edges, worst.rays / 50) << "the test must exercise edges";
    EXPECT_LE(worst.t, 1e-14);
}

}  // namespace
}  // namespace alidade::test
