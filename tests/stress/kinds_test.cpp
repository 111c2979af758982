// SPDX-License-Identifier: Apache-2.0
/// Generated scenes are what their kind says, the same for the same seed, and accelerators agree on them.
#include "stress/instances.h"
#include "stress/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace alidade::test {
namespace {

class StressKinds : public testing::TestWithParam<size_t> {
  protected:
    const StressKind& kind() const { return stress_kinds()[GetParam()]; }
};

TEST_P(StressKinds, HaveAboutAsManyTrianglesAsAskedFor) {
    for (const size_t n : {20000u, 200000u}) {
        const StressScene scene = kind().make(n, 1);
        EXPECT_NEAR(double(scene.triangles()), double(n), 0.25 * double(n)) << kind().name;
        const auto bvh = find_accelerator("bvh")->over_triangles(scene.mesh().view(), {});
        const bool zoo = std::string_view(kind().name) == "zoo";
        EXPECT_LE(bvh->stats().removed.size(), n / (zoo ? 10 : 100)) << kind().name << ": few are without area";
        EXPECT_EQ(bvh->stats().removed.size() > n / 20, zoo) << "which is what a zoo is for";
    }
}

/// What the compact BVH is for. Its triangles stay where they are, and of the hits nothing is lost: all rows of the table meet alike, below.
TEST_P(StressKinds, TakeLittleMemoryWhenCompact) {
    const StressScene scene = kind().make(100000, 1);
    for (const StressMesh& mesh : scene.meshes) {
        const auto compact = find_accelerator("compact")->over_triangles(mesh.view(), {});
        EXPECT_LE(double(compact->stats().bytes), 32.0 * double(compact->stats().primitives)) << kind().name;
        EXPECT_GE(double(compact->stats().bytes), 12.0 * double(compact->stats().primitives)) << "all that is kept is counted: a block has twelve for each triangle";
    }
}

TEST_P(StressKinds, DependOnTheSeedAlone) {
    const StressScene a = kind().make(5000, 1), same = kind().make(5000, 1), other = kind().make(5000, 2);
    EXPECT_EQ(a.mesh().positions, same.mesh().positions);
    EXPECT_EQ(a.mesh().triangles, same.mesh().triangles);
    EXPECT_NE(a.mesh().positions, other.mesh().positions) << kind().name;
}

TEST_P(StressKinds, AreMetAlikeByAll) {
    const StressScene scene = kind().make(2000, 1);
    StressOptions options;
    options.rounds = 1, options.oracle_tests = 2e6;
    const StressFigures figures = stress_entries(scene, accelerators().subspan(1), scene.places.empty() ? 24 : 12, options);
    for (const StressDisagreement& wrong : figures.disagreements) ADD_FAILURE() << kind().name << ": " << wrong.sentence();
    ASSERT_EQ(figures.peers.size(), 2 * (accelerators().size() - 1));
    for (const StressPeerFigures& peer : figures.peers) {
        ASSERT_EQ(peer.rays.size(), 4u);
        EXPECT_GE(peer.rays[2].count, peer.rays[0].count / 10) << kind().name << ": the camera must see something";
        EXPECT_EQ(peer.rays[2].count, peer.rays[1].count);
        for (const StressRayFigures& rays : peer.rays) EXPECT_EQ(rays.unlike, 0u) << peer.name << ' ' << rays.rays;
    }
    for (const StressChecked& checked : figures.checked) EXPECT_GE(checked.count, 16u) << checked.rays;
}

/// All crossings of a ray, which no kind of ray is asked for when times are taken.
TEST_P(StressKinds, AreCrossedAlikeByAll) {
    const StressScene scene = kind().make(2000, 1);
    const std::vector<StressRay> rays = camera_rays(scene, 6);
    const auto crossings = [&](const AcceleratorEntry& entry) {
        std::vector<std::unique_ptr<Accelerator>> meshes;
        std::vector<const Accelerator*> below;
        for (const StressMesh& mesh : scene.meshes) meshes.push_back(entry.over_triangles(mesh.view(), {})), below.push_back(meshes.back().get());
        const auto top = scene.places.empty() ? nullptr : entry.over_set(std::make_shared<StressInstances>(std::move(below), scene), {});
        std::vector<std::vector<std::tuple<double, uint32_t, uint32_t>>> all;
        for (const StressRay& ray : rays) {
            std::vector<Hit> hits;
            WorkCounters work;
            (top ? *top : *meshes.front()).all_hits(ray.ray(), hits, work);
            auto& found = all.emplace_back();
            for (const Hit& hit : hits) found.emplace_back(hit.t, hit.instance, hit.primitive);
            std::sort(found.begin(), found.end());
        }
        return all;
    };
    const auto wanted = crossings(accelerators().front());
    EXPECT_TRUE(std::any_of(wanted.begin(), wanted.end(), [](const auto& hits) { return hits.size() > 1; })) << kind().name;
    for (const AcceleratorEntry& entry : accelerators().subspan(1)) EXPECT_EQ(crossings(entry), wanted) << entry.name << ", " << kind().name;
}

INSTANTIATE_TEST_SUITE_P(Table, StressKinds, testing::Range(size_t(0), stress_kinds().size()),
                         [](const auto& info) { return std::string(stress_kinds()[info.param].name); });

TEST(StressTable, FindsByName) {
    for (const StressKind& kind : stress_kinds()) EXPECT_EQ(find_stress_kind(kind.name), &kind);
    EXPECT_EQ(find_stress_kind("nonsense"), nullptr);
}

}  // namespace
}  // namespace alidade::test
