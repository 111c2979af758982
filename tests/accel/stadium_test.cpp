// SPDX-License-Identifier: Apache-2.0
/// A teapot in a stadium: a hundred thousand triangles in a thousandth, or a millionth, of the length of the scene. No structure may die of it.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"
#include "tests/accel/stadium.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr uint64_t kSeed = 20250404;

/// The work of a ray against the BVH's, for the same rays; boxes, cells and triangles weigh the same. Measured: 2.3 at most (grid), a uniform grid 4500.
constexpr double kMostOfBvh = 3;

/// Of each triangle: the measured 166 (float) and 289 (double, where a triangle alone has 80), both of the grid, and a tenth.
double most_bytes(Precision precision) { return precision == Precision::float_ ? 183 : 318; }

Ray nth_ray(const StadiumScene& scene, const StadiumRays& rays, size_t i) { return rays.make(scene, RandomKey(kSeed, 0, i, 0)); }

/// A ray of a kind, on average over `count`.
double work_of(const Accelerator& accelerator, const StadiumScene& scene, const StadiumRays& rays, size_t count) {
    WorkCounters work;
    for (size_t i = 0; i < count; ++i) {
        Hit hit;
        const Ray ray = nth_ray(scene, rays, i);
        rays.any_hit ? accelerator.occluded(ray, work) : accelerator.intersect(ray, hit, work);
    }
    return double(work.boxes + work.filtered) / double(count);
}

void expect_same_answers(const Accelerator& got, const Accelerator& want, const char* name, const StadiumScene& scene, size_t count) {
    for (const StadiumRays& rays : stadium_rays()) {
        size_t hits = 0;
        for (size_t i = 0; i < count; ++i) {
            const Ray ray = nth_ray(scene, rays, i);
            const Answers expected = answers(want, ray);
            hits += expected.first.valid();
            ASSERT_EQ(difference(answers(got, ray), expected), "") << name << ", " << scene.mesh.name << ", " << rays.name << ", ray " << i << ": " << describe(ray);
        }
        EXPECT_GT(hits, count / 20) << scene.mesh.name << ", " << rays.name << ": the test must exercise hits";
    }
}

class Stadium : public testing::TestWithParam<size_t> {};

TEST_P(Stadium, CostsEveryStructureWhatItCostsTheBvh) {
    if (run_scale() < 1) GTEST_SKIP() << "work is counted in the ordinary run";
    const StadiumCase& c = stadium_cases()[GetParam()];
    const Precision precision = c.needs_double ? Precision::double_ : Precision::float_;
    const StadiumScene scene = c.make();
    const auto bvh = build(*find_accelerator("bvh"), scene.mesh, {precision});
    for (const AcceleratorEntry* entry : accelerators_under_test()) {
        const auto accelerator = build(*entry, scene.mesh, {precision});
        const BuildStats& stats = accelerator->stats();
        const double bytes = double(stats.bytes) / double(stats.primitives);
        fmt::print("{} in {}: {} triangles, {:.0f} bytes each, built in {:.2f} s\n", entry->name, c.name, stats.primitives, bytes, stats.seconds);
        EXPECT_LE(bytes, most_bytes(precision)) << entry->name;
        const size_t count = run_size(300, 10000);
        for (const StadiumRays& rays : stadium_rays()) {
            const double work = work_of(*accelerator, scene, rays, count), want = work_of(*bvh, scene, rays, count);
            fmt::print("    {}: {:.1f} a ray, {:.2f} of the BVH's\n", rays.name, work, work / want);
            EXPECT_LE(work, kMostOfBvh * want) << entry->name << ", " << rays.name;
        }
        expect_same_answers(*accelerator, *bvh, entry->name, scene, run_size(200, 100000));
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, Stadium, testing::Range(size_t(0), stadium_cases().size()),
                         [](const auto& info) { return stadium_cases()[info.param].name; });

/// Small enough for brute force: levels within levels, sizes of 1e-2 to 1e-9 of the stadium's, in both precisions.
TEST(SmallStadium, AgreesWithBruteForce) {
    for (const double size : {1.0, 1e-2, 1e-4, 1e-6}) {
        const TeapotPlace places[] = {{Vec3(0.3, 0.2, 0), size}, {Vec3(0.3, 0.2 + 2 * size, 0), 1e-1 * size}, {Vec3(80.03, 1.3, 16), size}};
        const StadiumScene scene = teapots_in_a_stadium(fmt::format("small, {}", size), 150, 700, places);
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            if (precision == Precision::float_ && size < 1e-3) continue;   // float would make lumps of them
            const auto brute = brute_force(scene.mesh, precision);
            for (const AcceleratorEntry* entry : accelerators_under_test())
                expect_same_answers(*build(*entry, scene.mesh, {precision}), *brute, entry->name, scene, run_size(300, 30000));
        }
    }
}

}  // namespace
}  // namespace alidade::test
