// SPDX-License-Identifier: Apache-2.0
/// Triangles without corners are removed and reported; one alone is hit. Numbers that are none are row T19 of the suite.
#include "numerics/triangles/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr size_t kGood = 1280;

TEST(BadMesh, IndicesOutOfRangeAreReported) {
    const TriangleMesh good = geodesic_sphere(8);
    std::vector<Index3> triangles = good.triangles;
    triangles[7] = {0, 1, uint32_t(good.vertices.size())};
    triangles[9] = {kNoId, kNoId, kNoId};
    for (const AcceleratorEntry& entry : accelerators()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const auto accelerator = entry.over_triangles({good.positions, good.vertices, triangles}, {precision});
            EXPECT_THAT(accelerator->stats().removed, testing::UnorderedElementsAre(7, 9)) << entry.name;
            EXPECT_EQ(accelerator->stats().primitives, kGood - 2) << entry.name;
        }
    }
}

TEST(BadMesh, OfOneTriangleIsHit) {
    const TriangleMesh one("one triangle", {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}, {Index3(0, 1, 2)});
    Ray ray;
    ray.origin = {0.25, 0.25, -1};
    for (const AcceleratorEntry& entry : accelerators()) {
        const Hit hit = first_hit(*build(entry, one, {}), ray);
        EXPECT_EQ(hit.primitive, 0u) << entry.name;
        EXPECT_EQ(hit.t, 2.0) << entry.name;
        EXPECT_EQ(hit.u, 0.25f) << entry.name;
        EXPECT_EQ(hit.v, 0.25f) << entry.name;
    }
}

}  // namespace
}  // namespace alidade::test
