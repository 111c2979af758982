// SPDX-License-Identifier: Apache-2.0
/// What accelerators promise besides the answers of brute force (numerics T15): closed intervals, prior hits, meshes without doubles.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"

#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr uint64_t kSeed = 20250101;

/// Found by a full run: rays just inside the bounds of a mesh whose sides differ by 2^100, where the planes of a grid are coarser than the distance.
TEST(Replay, RaysThatRunJustInsideTheBounds) {
    const TriangleMesh mesh = scaled(wild_soup(12, 4), 1e6).read_at(Precision::float_);
    const auto brute = brute_force(mesh, Precision::float_);
    for (const auto& [origin, dir] : {std::pair{Vec3(-0x1.c17a72p-110, -0x1.4c020ap-107, 0x1.5e913cp+86), Vec3(0x1.1411fe2f4e4p-91, -0x1.192ffbfdf6p-91, -0x1.5e913cp+86)},
                                      {Vec3(-0x1.c17a72p-110, 0x1.85f74ap+77, 0x1.28cff2p+86), Vec3(0x1.eb40c09c8p-100, -0x1.85f74ap+77, -0x1.28cff2p+86)},
                                      {Vec3(0x1.ead062p-100, -0x1.193148p-91, 0x1.28cff2p+86), Vec3(0x1.131c5dcfp-91, 0x1.193147fa5a608p-91, -0x1.28cff2p+86)}}) {
        Ray ray;
        ray.origin = origin;
        ray.dir = dir;
        ASSERT_TRUE(answers(*brute, ray).first.valid());
        for (const AcceleratorEntry* entry : accelerators_under_test())
            EXPECT_EQ(difference(answers(*build(*entry, mesh, {Precision::float_}), ray), answers(*brute, ray)), "") << entry->name;
    }
}

/// A hit at exactly tmin or tmax belongs to the ray, and one ulp further it does not.
TEST(Interval, IsClosedToTheLastBit) {
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        const TriangleMesh mesh = geodesic_sphere(4).read_at(precision);
        AccelOptions options;
        options.precision = precision;
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, options);
            for (size_t i = 0; i < 2000; ++i) {
                Ray ray = ray_classes().front().make(mesh, RandomKey(kSeed, 1, i, 0));
                const Hit hit = first_hit(*accelerator, ray);
                if (!hit.valid()) continue;
                ray.tmin = ray.tmax = hit.t;
                EXPECT_EQ(first_hit(*accelerator, ray).t, hit.t) << entry.name << ", ray " << i << ": " << describe(ray);
                EXPECT_TRUE(is_occluded(*accelerator, ray)) << entry.name << ", ray " << i << ": " << describe(ray);
                ray.tmin = 0, ray.tmax = std::nextafter(hit.t, 0);
                EXPECT_FALSE(first_hit(*accelerator, ray).valid()) << entry.name << ", ray " << i << ": " << describe(ray);
                EXPECT_FALSE(is_occluded(*accelerator, ray)) << entry.name << ", ray " << i << ": " << describe(ray);
            }
        }
    }
}

/// `hit` is an input too: what comes before it replaces it, what comes behind leaves it alone, and a tie goes to the lower ids.
TEST(PriorHit, IsReplacedOnlyByOneThatComesBefore) {
    const TriangleMesh mesh = cube_lattice(2, 3, 4).read_at(Precision::float_);
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto accelerator = build(entry, mesh, {});
        WorkCounters work;
        size_t tried = 0;
        for (size_t i = 0; i < 2000; ++i) {
            const Ray ray = ray_classes().front().make(mesh, RandomKey(kSeed, 2, i, 0));
            Hit first;
            if (!accelerator->intersect(ray, first, work, 5)) continue;
            EXPECT_EQ(first.instance, 5u);
            ++tried;
            for (const double t : {std::nextafter(first.t, -kInf), first.t, std::nextafter(first.t, kInf)}) {
                for (const uint32_t instance : {4u, 5u, 6u}) {
                    Hit prior = first;
                    prior.t = t, prior.instance = instance, prior.u = 7;
                    const bool expected = comes_before(first.t, 5, first.primitive, prior);
                    Hit hit = prior;
                    EXPECT_EQ(accelerator->intersect(ray, hit, work, 5), expected) << entry.name << ", " << describe(ray);
                    EXPECT_EQ(difference(hit, expected ? first : prior), "") << entry.name << ", " << describe(ray);
                }
            }
        }
        EXPECT_GT(tried, 1000u) << "the test must exercise hits";
    }
}

/// A mesh without doubles is the mesh with the doubles that its floats are.
TEST(DoublePrecision, ReadsFloatPositionsWhereThereAreNoOthers) {
    const TriangleMesh mesh = torus(16, 10).read_at(Precision::float_);
    AccelOptions options;
    options.precision = Precision::double_;
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto with = build(entry, mesh, options);
        const auto without = entry.over_triangles({mesh.positions, {}, mesh.triangles}, options);
        for (size_t i = 0; i < 500; ++i) {
            const Ray ray = ray_classes().front().make(mesh, RandomKey(kSeed, 3, i, 0));
            ASSERT_EQ(difference(answers(*without, ray), answers(*with, ray)), "") << entry.name << ", " << describe(ray);
        }
    }
}

}  // namespace
}  // namespace alidade::test
