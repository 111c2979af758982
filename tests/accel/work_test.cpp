// SPDX-License-Identifier: Apache-2.0
/// Work is part of the contract: a structure that skips nothing gives the right hits at the price of brute force, and no comparison of hits shows it.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

/// Counters of `count` rays aimed at random points of the mesh.
WorkCounters work_of(const Accelerator& accelerator, const TriangleMesh& mesh, size_t count, bool any_hit = false) {
    WorkCounters work;
    for (size_t i = 0; i < count; ++i) {
        const Ray ray = ray_classes().front().make(mesh, RandomKey(51, 0, i, 0));
        Hit hit;
        any_hit ? accelerator.occluded(ray, work) : accelerator.intersect(ray, hit, work);
    }
    return work;
}

/// The counters count: brute force looks at every triangle.
TEST(Work, OfBruteForceIsEveryTriangle) {
    const TriangleMesh mesh = torus(50, 40);
    ASSERT_EQ(mesh.triangles.size(), 4000u);
    const WorkCounters work = work_of(*brute_force(mesh, Precision::float_), mesh, 100);
    EXPECT_EQ(work.filtered, work.rays * mesh.triangles.size());
    EXPECT_GT(work.rays, 90u);
    EXPECT_LE(work.rays, 100u);
    EXPECT_GT(work.primitives, 90u);
    EXPECT_LE(work.primitives, work.filtered);
}

class Work : public testing::TestWithParam<std::tuple<const AcceleratorEntry*, Precision>> {};

TEST_P(Work, IsAtMostThreePercentOfTheTriangles) {
    const auto [entry, precision] = GetParam();
    const std::pair<TriangleMesh, double> limits[] = {{torus(50, 40), 0.03}, {geodesic_sphere(14), 0.03}, {soup(4000, 0.05, 6), 0.03}};
    for (const auto& [mesh, limit] : limits) {
        const auto accelerator = build(*entry, mesh, {precision});
        const size_t count = 2000, n = mesh.triangles.size();
        for (const bool any_hit : {false, true}) {
            const WorkCounters work = work_of(*accelerator, mesh, count, any_hit);
            const double tests = double(work.filtered) / double(count), boxes = double(work.boxes) / double(count);
            EXPECT_GE(work.primitives, count / 2) << "hits are decided in double";
            EXPECT_GT(boxes, 1) << "something must have led the ray there";
            EXPECT_LE(tests, limit * double(n)) << mesh.name;
            EXPECT_LE(boxes, 0.1 * double(n)) << mesh.name;
            fmt::print("{}{}: {:.1f} triangles of {}, {:.1f} boxes or cells a ray\n", mesh.name, any_hit ? ", any hit" : "", tests, n, boxes);
        }
    }
}

/// What is counted in large meshes: the numbers are the same in a run at a part of its size, for a sanitizer.
class RecordedWork : public testing::Test {
    void SetUp() override {
        if (run_scale() < 1) GTEST_SKIP() << "work is counted in the ordinary run";
    }
};

struct Record {
    TriangleMesh mesh;
    double boxes, triangles;   ///< a ray
};

/// Work as it was recorded: it may become less (then record it), and by 5 % more. The numbers do not depend on the machine.
void expect_kept(const char* name, std::span<const Record> records) {
    for (const Record& record : records) {
        const WorkCounters work = work_of(*build(*find_accelerator(name), record.mesh, {}), record.mesh, 2000);
        const double boxes = double(work.boxes) / 2000, triangles = double(work.filtered) / 2000;
        EXPECT_LE(boxes, 1.05 * record.boxes) << record.mesh.name;
        EXPECT_LE(triangles, 1.05 * record.triangles) << record.mesh.name;
        fmt::print("{}, {}: {:.1f} boxes, {:.1f} triangles a ray\n", name, record.mesh.name, boxes, triangles);
    }
}

TEST_F(RecordedWork, OfTheGridIsKept) {
    const Record records[] = {{geodesic_sphere(71, 0.2), 13.2, 104.4}, {soup(100000, 0.02, 4), 14.1, 85.7}, {battens(1000), 8.1, 5599.9}, {stadium(16, 16), 5.0, 30.4}};
    expect_kept("grid", records);
}

TEST_F(RecordedWork, OfTheOctreeIsKept) {
    const Record records[] = {{geodesic_sphere(71, 0.2), 62.1, 14.9}, {soup(100000, 0.02, 4), 143.2, 61.5}, {battens(1000), 378.7, 910.2}, {stadium(16, 16), 41.7, 12.3}};
    expect_kept("octree", records);
}

TEST_F(RecordedWork, OfTheBvhIsKept) {
    const Record records[] = {{geodesic_sphere(71, 0.2), 56.1, 16.9}, {soup(100000, 0.02, 4), 122.6, 78.3}, {battens(1000), 267.8, 1177.6}, {turned(moved(geodesic_sphere(40), Vec3(1e3, 1, 1), Vec3(0), ""), "needle askew"), 138.5, 410.2}, {stadium(16, 16), 36.2, 14.7}};
    expect_kept("bvh", records);
}

/// So of the compact one: its boxes are larger, and where blocks do not keep their corners, as of large meshes they do, triangles have boxes of their own.
TEST_F(RecordedWork, OfTheCompactBvhIsKept) {
    const Record records[] = {{geodesic_sphere(71, 0.2), 57.4, 17.3}, {soup(100000, 0.02, 4), 143.9, 62.9}, {battens(1000), 1566.6, 1179.0}, {stadium(16, 16), 53.5, 3.1}};
    expect_kept("compact", records);
}

/// A triangle in several cells is decided once: no more of them than in the BVH, where each is in one leaf.
TEST_F(RecordedWork, OfTrianglesInManyCellsIsDoneOnce) {
    const TriangleMesh mesh = geodesic_sphere(71, 0.2);
    const auto decided = [&](const char* name) { return double(work_of(*build(*find_accelerator(name), mesh, {}), mesh, 2000).primitives) / 2000; };
    const double want = decided("bvh");
    for (const char* name : {"grid", "octree"}) {
        const double got = decided(name);
        EXPECT_LE(got, 1.1 * want) << name;
        fmt::print("{}: {:.2f} triangles decided a ray, {:.2f} by the BVH\n", name, got, want);
    }
}

/// The exponent p of work ~ N^p, by least squares over the logarithms.
double growth_exponent(const std::vector<std::pair<double, double>>& n_and_work) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& [n, work] : n_and_work) {
        const double x = std::log(n), y = std::log(work);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double count = double(n_and_work.size());
    return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

/// Over two decades, in full over three, on evenly spread triangles, on a surface and in space. Boxes, cells and triangles weigh the same.
TEST_P(Work, GrowsSlowly) {
    if (run_scale() < 1) GTEST_SKIP() << "work is counted in the ordinary run";
    const auto [entry, precision] = GetParam();
    const double limit = std::string_view(entry->name) == "bvh" ? 0.4 : 0.5;
    using Make = TriangleMesh (*)(double n);
    const std::pair<const char*, Make> kinds[] = {
        {"surface", [](double n) { return geodesic_sphere(int(std::lround(std::sqrt(n / 20))), 0.1); }},
        {"soup", [](double n) { return soup(int(n), 0.5 / std::cbrt(n), 8); }},
    };
    for (const auto& [kind, make] : kinds) {
        std::vector<std::pair<double, double>> n_and_work;
        for (const double n : {1e3, 1e4, 1e5, 1e6}) {
            if (n > 5e5 && (precision == Precision::double_ || !runs_in_full())) continue;   // minutes, and the float run shows it
            const TriangleMesh mesh = make(n);
            const size_t count = 1000;
            const auto accelerator = build(*entry, mesh, {precision});
            const WorkCounters work = work_of(*accelerator, mesh, count);
            n_and_work.emplace_back(double(mesh.triangles.size()), double(work.boxes + work.filtered) / double(count));
            fmt::print("{}: N = {}, {:.1f} a ray; {:.0f} bytes a triangle, built in {:.2f} s\n", kind, mesh.triangles.size(), n_and_work.back().second,
                       double(accelerator->stats().bytes) / double(mesh.triangles.size()), accelerator->stats().seconds);
        }
        const double exponent = growth_exponent(n_and_work);
        fmt::print("{}: exponent {:.3f}\n", kind, exponent);
        EXPECT_LE(exponent, limit) << kind;
    }
}

/// A scene a billion times farther from 0 than it is wide: cells still tell its triangles apart.
TEST_P(Work, DoesNotGrowFarFromZero) {
    const auto [entry, precision] = GetParam();
    if (precision == Precision::float_) GTEST_SKIP() << "float cannot tell such vertices apart";
    const TriangleMesh near = geodesic_sphere(14), far = moved(near, Vec3(1), Vec3(1e9, -7e8, 3e8), "sphere + 1e9");
    const WorkCounters there = work_of(*build(*entry, far, {precision}), far, 2000), here = work_of(*build(*entry, near, {precision}), near, 2000);
    EXPECT_LE(double(there.boxes + there.filtered), 1.5 * double(here.boxes + here.filtered));
    fmt::print("{} boxes and triangles near 0, {} far from it\n", here.boxes + here.filtered, there.boxes + there.filtered);
}

INSTANTIATE_TEST_SUITE_P(Registry, Work,
                         testing::Combine(testing::ValuesIn(accelerators_under_test()), testing::Values(Precision::float_, Precision::double_)),
                         [](const auto& info) { return fmt::format("{}_{}", std::get<0>(info.param)->name, name(std::get<1>(info.param))); });

}  // namespace
}  // namespace alidade::test
