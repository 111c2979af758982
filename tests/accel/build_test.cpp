// SPDX-License-Identifier: Apache-2.0
/// The registry, and what a finished structure says of itself.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

#include <set>

namespace alidade::test {

using namespace numerics;

namespace {

TEST(Registry, BeginsWithBruteForceAndFindsByName) {
    ASSERT_GE(accelerators().size(), 4u);
    EXPECT_STREQ(accelerators().front().name, "brute");
    std::set<std::string> names;
    for (const AcceleratorEntry& entry : accelerators()) {
        EXPECT_EQ(find_accelerator(entry.name), &entry);
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " is there twice";
        EXPECT_GT(std::string_view(entry.doc).size(), 5u) << entry.name;
    }
    EXPECT_STREQ(find_accelerator("auto")->name, "auto");
    for (const char* name : {"bvh", "grid", "octree"}) EXPECT_TRUE(find_accelerator(name)) << name;
    EXPECT_EQ(find_accelerator("nonsense"), nullptr);
    EXPECT_EQ(find_accelerator(""), nullptr);
}

TEST(BuildStats, SayWhatWasBuilt) {
    const TriangleMesh mesh = geodesic_sphere(16).read_at(Precision::float_);
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto accelerator = build(entry, mesh, {});
        const BuildStats& stats = accelerator->stats();
        EXPECT_EQ(stats.primitives, mesh.triangles.size()) << entry.name;
        EXPECT_GE(stats.references, stats.primitives) << entry.name;
        EXPECT_GE(stats.bytes, stats.references * sizeof(uint32_t)) << entry.name << ": leaves hold at least an id for each reference";
        EXPECT_TRUE(stats.removed.empty()) << entry.name;
        EXPECT_GE(stats.seconds, 0) << entry.name;
        const Bounds box = accelerator->bounds(), want = mesh.bounds();
        EXPECT_TRUE(box.contains(want.min) && box.contains(want.max)) << entry.name;
        EXPECT_LE(max_abs(box.min - want.min), 1e-5) << entry.name;
        EXPECT_LE(max_abs(box.max - want.max), 1e-5) << entry.name;
    }
}

/// Phases are parts of the build, one after the other, and leave out next to nothing of it.
TEST(BuildStats, PhasesAddUpToTheBuild) {
    const TriangleMesh mesh = geodesic_sphere(60);
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto accelerator = build(entry, mesh, {});
        const BuildStats& s = accelerator->stats();
        double sum = 0;
        std::vector<std::string> names;
        for (const BuildPhase& phase : s.phases) {
            EXPECT_GE(phase.seconds, 0) << entry.name << ' ' << phase.name;
            sum += phase.seconds, names.push_back(phase.name);
        }
        EXPECT_LE(sum, s.seconds) << entry.name;
        EXPECT_GE(sum, 0.5 * s.seconds) << entry.name;
        ASSERT_GE(names.size(), 2u) << entry.name;
        EXPECT_EQ(names.front(), "sort out") << entry.name;
        EXPECT_EQ(names.back(), "pack") << entry.name;
    }
}

/// The caller may free or overwrite its arrays once the structure is built: but for those that the compact BVH in float reads as long as it lives.
TEST(Build, KeepsNothingOfTheCallersArrays) {
    for (const AcceleratorEntry& entry : accelerators()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            if (std::string_view(entry.name) == "compact" && precision == Precision::float_) continue;
            const TriangleMesh original = torus(16, 10).read_at(precision);
            const auto want = build(entry, original, {precision});
            TriangleMesh lent = original;
            const auto accelerator = build(entry, lent, {precision});
            lent.vertices.assign(lent.vertices.size(), Vec3(0)), lent.positions.assign(lent.positions.size(), Vec3f(0));
            lent.triangles.assign(lent.triangles.size(), Index3(0));
            for (size_t i = 0; i < 200; ++i) {
                const Ray ray = ray_classes().front().make(original, RandomKey(61, 0, i, 0));
                ASSERT_EQ(difference(answers(*accelerator, ray), answers(*want, ray)), "") << entry.name << ": " << describe(ray);
            }
        }
    }
}

/// The structure does not depend on the threads that built it: not its sizes, not its hits, not a single step of a ray.
TEST(Build, DoesNotDependOnThreads) {
    for (const TriangleMesh& mesh : {geodesic_sphere(run_scale() < 1 ? 20 : 40, 0.2), soup(run_scale() < 1 ? 8000 : 30000, 0.03, 9)}) {
        for (const AcceleratorEntry* entry : accelerators_under_test()) {
            const auto one = build(*entry, mesh, {Precision::float_, Isa::best, 1}), many = build(*entry, mesh, {Precision::float_, Isa::best, 4});
            const BuildStats &a = one->stats(), &b = many->stats();
            EXPECT_EQ(std::tie(a.nodes, a.leaves, a.depth, a.references, a.bytes, a.sah_cost),
                      std::tie(b.nodes, b.leaves, b.depth, b.references, b.bytes, b.sah_cost))
                << entry->name;
            WorkCounters work_one, work_many;
            for (size_t i = 0; i < 1000; ++i) {
                const Ray ray = ray_classes()[i % ray_classes().size()].make(mesh, RandomKey(67, 0, i, 0));
                Hit hit_one, hit_many;
                one->intersect(ray, hit_one, work_one), many->intersect(ray, hit_many, work_many);
                ASSERT_EQ(difference(hit_many, hit_one), "") << entry->name << ": " << describe(ray);
            }
            EXPECT_EQ(work_one.boxes, work_many.boxes) << entry->name;
            EXPECT_EQ(work_one.filtered, work_many.filtered) << entry->name;
            EXPECT_EQ(work_one.primitives, work_many.primitives) << entry->name;
        }
    }
}

}  // namespace
}  // namespace alidade::test
