// SPDX-License-Identifier: Apache-2.0
/// The tests of triangles that a user may choose: right where nothing is close, and where something is, wrong by no more than what docs/accelerators.md tells.
#include "accel/triangles/moller_trumbore.h"
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rational.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"
#include "tests/accel/test_name.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace alidade::test {

using namespace numerics;

namespace {

class Intersects : public testing::TestWithParam<std::tuple<Intersect, Precision>> {
  protected:
    Intersect how() const { return std::get<0>(GetParam()); }
    Precision precision() const { return std::get<1>(GetParam()); }
    AccelOptions options(Isa isa = Isa::best) const { return {precision(), isa, 1, how()}; }
    /// Of t where nothing is close: double but for the fast test in float.
    double tolerance() const { return how() == Intersect::fast && precision() == Precision::float_ ? 1e-4 : 1e-11; }
};

TEST(Intersect, TheTableIsInTheOrderOfTheValues) {
    for (size_t i = 0; i < intersects().size(); ++i) EXPECT_EQ(size_t(intersects()[i].value), i);
    EXPECT_EQ(intersects().front().value, AccelOptions().intersect);
}

/// Rational arithmetic is the oracle. Rays stay clear of edges by a hundredth and do not graze.
TEST_P(Intersects, IsRightOnTrianglesThatAreMetClearly) {
    size_t hits = 0, misses = 0;
    const size_t count = run_size(4000, 400000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(121, 0, n));
        const Vec3 a = draws.in_box(Vec3(-1), Vec3(1)), b = draws.in_box(Vec3(-1), Vec3(1)), c = draws.in_box(Vec3(-1), Vec3(1));
        const TriangleMesh mesh = TriangleMesh("triangle", {a, b, c}, {{0, 1, 2}}).read_at(precision());
        const std::array<Vec3, 3> corners{mesh.corner(0, 0), mesh.corner(0, 1), mesh.corner(0, 2)};
        const double u = draws.uniform(-1, 2), v = draws.uniform(-1, 2);
        Ray ray;
        ray.origin = draws.in_box(Vec3(-3), Vec3(3));
        ray.dir = (1 - u - v) * corners[0] + u * corners[1] + v * corners[2] - ray.origin;
        const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double longest = std::max({length(corners[1] - corners[0]), length(corners[2] - corners[0]), length(corners[2] - corners[1])});
        if (std::abs(std::min({u, v, 1 - u - v})) < 0.01 || std::abs(dot(ray.dir, normal)) < 0.05 * length(ray.dir) * length(normal) || length(normal) < 0.05 * longest * longest) continue;
        const ExactCrossing exact = exact_crossing(ray, corners);
        for (const AcceleratorEntry& entry : accelerators()) {
            const Hit hit = first_hit(*build(entry, mesh, options()), ray);
            ASSERT_EQ(hit.valid(), exact.side > 0) << entry.name << ", seed 121, " << n << ": " << describe(ray);
            ++(hit.valid() ? hits : misses);
            if (!hit.valid()) continue;
            ASSERT_LE(relative_error(hit.t, exact.t), tolerance()) << entry.name << ", seed 121, " << n;
            ASSERT_NEAR(hit.u, exact.u.get_d(), std::max(1e-6, tolerance()));
            ASSERT_NEAR(hit.v, exact.v.get_d(), std::max(1e-6, tolerance()));
            ASSERT_TRUE(within(ray.at(hit.t), hit.error.along_normal, corners)) << entry.name << ", seed 121, " << n;
        }
    }
    EXPECT_GT(hits, count / 10);
    EXPECT_GT(misses, count / 10);
}

/// Where exact brute force sees something clearly, all see that.
TEST_P(Intersects, GenericRaysMeetWhatTheyMeet) {
    const size_t count = run_size(3000, 300000);
    for (const TriangleMesh& source : {geodesic_sphere(8), torus(16, 10), soup(300, 0.3, 2), stadium(4, 4)}) {
        const TriangleMesh mesh = source.read_at(precision());
        const auto truth = brute_force(mesh, precision());
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, options());
            size_t unlike = 0, hits = 0;
            for (size_t i = 0; i < count; ++i) {
                const Ray ray = ray_classes().front().make(mesh, RandomKey(122, 0, i, 0));
                const Hit got = first_hit(*accelerator, ray), want = first_hit(*truth, ray);
                ASSERT_EQ(is_occluded(*accelerator, ray), got.valid()) << entry.name << ", " << mesh.name << ", seed 122, ray " << i;
                hits += want.valid();
                unlike += got.valid() != want.valid() || (want.valid() && std::abs(got.t - want.t) > 100 * tolerance() * std::abs(want.t));
            }
            EXPECT_GT(hits, count / 4) << mesh.name;
            EXPECT_LE(unlike, how() == Intersect::fast ? count / 1000 : 0) << entry.name << ", " << mesh.name << ": silhouettes and edges";
        }
    }
}

/// On anything: it ends, and what it says is a hit of the mesh in the ray's interval.
TEST_P(Intersects, EndsOnAnything) {
    for (const TriangleMesh& source : {wild_soup(60, 4), scaled(geodesic_sphere(4), 1e-30), scaled(cube(4), 1e30), moved(torus(16, 10), Vec3(1), Vec3(1e7), "far torus"), slivers(40, 1e-6, 3)}) {
        const TriangleMesh mesh = source.read_at(precision());
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, options());
            for (size_t i = 0; i < run_size(200, 20000) * ray_classes().size(); ++i) {
                Ray ray = ray_classes()[i % ray_classes().size()].make(mesh, RandomKey(123, 0, i, 0));
                if (i % 50 == 0) ray.dir[int(i / 50 % 3)] = i % 100 ? std::numeric_limits<double>::quiet_NaN() : kInf;
                if (i % 70 == 0) ray.dir *= 1e-300;
                for (const Hit& hit : answers(*accelerator, ray).all) {
                    ASSERT_LT(hit.primitive, mesh.triangles.size());
                    ASSERT_TRUE(hit.t >= ray.tmin && hit.t <= ray.tmax && hit.error.along_normal >= 0) << entry.name << ", " << mesh.name << ", seed 123, ray " << i << ": " << describe(ray);
                }
            }
        }
    }
}

TEST_P(Intersects, InstructionSetsChangeNoBit) {
    for (const TriangleMesh& source : {geodesic_sphere(12), soup(1000, 0.1, 7)}) {
        const TriangleMesh mesh = source.read_at(precision());
        for (const char* word : {"brute", "bvh", "compact"}) {
            const AcceleratorEntry& entry = *find_accelerator(word);
            const auto scalar = build(entry, mesh, options(Isa::scalar));
            for (const Isa isa : available_isas().subspan(1)) {
                const auto simd = build(entry, mesh, options(isa));
                for (size_t i = 0; i < run_size(100, 10000) * ray_classes().size(); ++i) {
                    const Ray ray = ray_classes()[i % ray_classes().size()].make(mesh, RandomKey(124, 0, i, 0));
                    ASSERT_EQ(difference(answers(*simd, ray), answers(*scalar, ray)), "") << alidade::name(isa) << ", " << word << ", " << mesh.name << ", seed 124, ray " << i << ": " << describe(ray);
                }
            }
        }
    }
}

/// Rays at vertices of closed meshes of size 1 around the origin, from inside. The fast test loses at most what the table in docs/accelerators.md tells, and it does lose some.
TEST_P(Intersects, LosesWhatIsToldAtVertices) {
    constexpr double kToldOfMillion = 80000;
    const size_t count = run_size(4000, 1000000);
    size_t asked = 0, lost = 0;
    for (const TriangleMesh& source : {geodesic_sphere(16), cube(8), torus(20, 12)}) {
        const TriangleMesh mesh = source.read_at(precision());
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, options());
            for (size_t i = 0; i < count; ++i) lost += !first_hit(*accelerator, vertex_aimed_from_inside(mesh, RandomKey(125, 0, i, 0))).valid(), ++asked;
        }
    }
    EXPECT_EQ(lost > 0, how() == Intersect::fast);
    EXPECT_LE(double(lost), how() == Intersect::fast ? kToldOfMillion * 1e-6 * double(asked) : 0.0) << "of " << asked;
    fmt::print("{:.0f} of a million\n", 1e6 * double(lost) / double(asked));
}

/// Seen from the origin, where what a ray is widened by is nothing, the boxes alone must make up for the roundings of the tests.
TEST_P(Intersects, ClosedMeshesHoldFromTheOrigin) {
    size_t meshes = 0, lost = 0;
    std::string first;
    for (const TriangleMesh& closed : closed_meshes()) {
        if (!closed.inside.contains(Vec3(0))) continue;
        ++meshes;
        const TriangleMesh mesh = closed.read_at(precision());
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, options());
            for (size_t i = 0; i < run_size(4000, 1000000); ++i) {
                Ray ray = (i % 4 ? edge_aimed_from_inside : vertex_aimed_from_inside)(mesh, RandomKey(127, 0, i, 0));
                ray.dir = ray.origin + ray.dir, ray.origin = Vec3(0);
                if (!first_hit(*accelerator, ray).valid() && lost++ == 0) first = fmt::format("{}, {}, seed 127, ray {}: {}", entry.name, mesh.name, i, describe(ray));
            }
        }
    }
    EXPECT_GE(meshes, 6u);
    EXPECT_EQ(lost > 0, how() == Intersect::fast) << lost << " of them, the first by " << first;
}

/// What stands in a face of the bounds is met where the ray leaves them: a floor, the walls of a room.
TEST_P(Intersects, WallsOfTheBoundsAreMet) {
    const TriangleMesh floor("floor", {{-1, -1, 0.3}, {1, -1, 0.3}, {1, 1, 0.3}, {-1, 1, 0.3}}, {{0, 1, 2}, {0, 2, 3}});
    size_t asked = 0, lost = 0;
    for (const TriangleMesh& source : {floor, cube(1), moved(cube(3), Vec3(1, 0.7, 1.3), Vec3(0.2, 0.1, -0.3), "room")}) {
        const TriangleMesh mesh = source.read_at(precision());
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, options());
            for (size_t i = 0; i < run_size(2000, 1000000); ++i) {
                Draws draws(RandomKey(127, 0, i));
                const bool room = mesh.triangles.size() > 2;
                const Vec3 from = room ? draws.in_box(Vec3(-0.3), Vec3(0.3)) : draws.in_box(Vec3(-0.9, -0.9, 1), Vec3(0.9, 0.9, 2));
                const Ray ray{from, room ? draws.direction() : draws.in_box(Vec3(-0.9, -0.9, 0.3), Vec3(0.9, 0.9, 0.3)) - from};
                WorkCounters work;
                lost += !first_hit(*accelerator, ray).valid(), lost += !accelerator->occluded(ray, work), asked += 2;
            }
        }
    }
    EXPECT_LE(lost, how() == Intersect::fast ? asked / 10000 : 0) << "of " << asked;
}

template <class T> TriangleBlock<T> wild_block(Draws& draws) {
    TriangleBlock<T> block{};
    const auto wild = [&]() -> T {
        switch (draws.below(8)) {
            case 0: return T(0);
            case 1: return T(int(draws.below(5)) - 2);
            case 2: return T(draws.sign() * std::ldexp(1.0, int(draws.below(240)) - 120));
            default: return T(draws.uniform(-1, 1));
        }
    };
    for (auto& lane : block.v)
        for (T& x : lane) x = wild();
    return block;
}

template <class T> void expect_equal_lanes(size_t count) {
    size_t hits = 0;
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(126, 0, n));
        const TriangleBlock<T> block = wild_block<T>(draws);
        LocalRay local;
        local.origin = draws.in_box(Vec3(-1), Vec3(1)), local.dir = draws.in_box(Vec3(-1), Vec3(1));
        if (draws.below(4) == 0) local.origin = Vec3(block.corners(0)[0]);
        if (draws.below(4) == 0) local.dir = block.corners(1)[1] - local.origin;
        const FastRay<T> want(local, -kInf, kInf);
        const uint32_t bits = fast_test<T>(Isa::scalar)(block, want, false);
        hits += bits != 0;
        for (const Isa isa : available_isas()) {
            const FastRay<T> got(local, -kInf, kInf);
            ASSERT_EQ(fast_test<T>(isa)(block, got, false), bits) << name(isa) << ", seed 126, " << n;
            for (uint32_t lane = 0; lane < kLanes; ++lane)
                ASSERT_TRUE(!(bits >> lane & 1) || (got.t[lane] == want.t[lane] && got.u[lane] == want.u[lane] && got.v[lane] == want.v[lane])) << name(isa) << ", seed 126, " << n;
        }
    }
    EXPECT_GT(hits, count / 10);
}

TEST(FastTest, EightLanesAreEightTimesOne) {
    expect_equal_lanes<float>(run_size(20000, 2000000));
    expect_equal_lanes<double>(run_size(20000, 2000000));
}

std::vector<Intersect> all_intersects() {
    std::vector<Intersect> all;
    for (const IntersectEntry& row : intersects()) all.push_back(row.value);
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, Intersects, testing::Combine(testing::ValuesIn(all_intersects()), testing::Values(Precision::float_, Precision::double_)),
                         [](const auto& info) { return test_name(fmt::format("{}_{}", alidade::name(std::get<0>(info.param)), numerics::name(std::get<1>(info.param)))); });

}  // namespace
}  // namespace alidade::test
