// SPDX-License-Identifier: Apache-2.0
/// `auto`: it chooses, says why, and answers as what it chose.
#include "stress/rays.h"

#include <gtest/gtest.h>

namespace alidade::test {
namespace {

TEST(Automatic, ChoosesTheBvhButForNeedles) {
    for (const StressKind& kind : stress_kinds()) {
        const StressScene scene = kind.make(20000, 1);
        const auto chosen = find_accelerator("auto")->over_triangles(scene.mesh().view(), {});
        const std::string wanted = std::string_view(kind.name) == "needle" ? "octree" : "bvh";
        EXPECT_EQ(chosen->why.substr(0, chosen->why.find(':')), wanted) << kind.name << ": " << chosen->why;
        const auto same = find_accelerator(wanted)->over_triangles(scene.mesh().view(), {});
        WorkCounters work, work_of_same;
        for (const StressRay& ray : camera_rays(scene, 12)) {
            Hit a, b;
            ASSERT_EQ(chosen->intersect(ray.ray(), a, work), same->intersect(ray.ray(), b, work_of_same)) << kind.name;
            ASSERT_EQ(std::tuple(a.t, a.primitive), std::tuple(b.t, b.primitive)) << kind.name;
        }
        EXPECT_EQ(std::tuple(work.boxes, work.filtered), std::tuple(work_of_same.boxes, work_of_same.filtered)) << kind.name;
    }
}

TEST(Automatic, TakesNothingAndLittle) {
    EXPECT_FALSE(find_accelerator("auto")->over_triangles({}, {})->why.empty());
    const Vec3f points[] = {Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
    const Index3 one[] = {Index3(0, 1, 2)};
    EXPECT_EQ(find_accelerator("auto")->over_triangles({points, {}, one}, {})->stats().primitives, 1u);
}

}  // namespace
}  // namespace alidade::test
