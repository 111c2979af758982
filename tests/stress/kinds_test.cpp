// SPDX-License-Identifier: Apache-2.0
/// Generated scenes are what their kind says, the same for the same seed, and accelerators agree on them.
#include "stress/instances.h"
#include "stress/rays.h"
#include "stress/scene.h"
#include "tests/accel/compare.h"

#include <gtest/gtest.h>

namespace alidade::test {
namespace {

class StressKinds : public testing::TestWithParam<size_t> {
  protected:
    const StressKind& kind() const { return stress_kinds()[GetParam()]; }
};

TEST_P(StressKinds, HaveAboutAsManyTrianglesAsAskedFor) {
    for (const size_t n : {20000u, 200000u}) {
        const StressScene scene = kind().make(n, 1);
        EXPECT_NEAR(double(scene.triangles.size()), double(n), 0.25 * double(n)) << kind().name;
        const auto bvh = find_accelerator("bvh")->over_triangles(scene.view(), {});
        EXPECT_LE(bvh->stats().removed.size(), n / 100) << kind().name << ": few are without area";
    }
}

TEST_P(StressKinds, DependOnTheSeedAlone) {
    const StressScene a = kind().make(5000, 1), same = kind().make(5000, 1), other = kind().make(5000, 2);
    EXPECT_EQ(a.positions, same.positions);
    EXPECT_EQ(a.triangles, same.triangles);
    EXPECT_NE(a.positions, other.positions) << kind().name;
}

/// The accelerator over a scene, and what it stands on.
struct Built {
    std::unique_ptr<Accelerator> mesh, top;

    Built(const AcceleratorEntry& entry, const StressScene& scene) : mesh(entry.over_triangles(scene.view(), {})) {
        if (!scene.instances.empty()) top = entry.over_set(std::make_shared<StressInstances>(*mesh, scene.instances), {});
    }
    const Accelerator& asked() const { return top ? *top : *mesh; }
};

TEST_P(StressKinds, AreMetByTheirRaysAsByBruteForce) {
    const StressScene scene = kind().make(3000, 1);
    const Built brute(accelerators().front(), scene), bvh(*find_accelerator("bvh"), scene);
    const size_t side = scene.instances.empty() ? 24 : 8;
    const StressRays rays = make_stress_rays(scene, bvh.asked(), side, 1);
    ASSERT_EQ(rays.primary.size(), side * side);
    EXPECT_GE(rays.diffuse.size(), rays.primary.size() / 10) << kind().name << ": the camera must see something";
    EXPECT_EQ(rays.diffuse.size(), rays.shadow.size());
    size_t i = 0;
    for (const auto* set : {&rays.primary, &rays.shadow, &rays.diffuse}) {
        for (const StressRay& ray : *set) ASSERT_EQ(difference(answers(bvh.asked(), ray.ray()), answers(brute.asked(), ray.ray())), "") << kind().name << ", ray " << i++;
    }
}

INSTANTIATE_TEST_SUITE_P(Table, StressKinds, testing::Range(size_t(0), stress_kinds().size()),
                         [](const auto& info) { return std::string(stress_kinds()[info.param].name); });

TEST(StressTable, FindsByName) {
    for (const StressKind& kind : stress_kinds()) EXPECT_EQ(find_stress_kind(kind.name), &kind);
    EXPECT_EQ(find_stress_kind("nonsense"), nullptr);
}

}  // namespace
}  // namespace alidade::test
