// SPDX-License-Identifier: Apache-2.0
/// Shafts leave out nothing that one of their rays hits, and are worth their name.
#include "accel/shaft.h"
#include "core/draws.h"
#include "tests/core/run_size.h"
#include "tests/accel/toy_set.h"

#include <gtest/gtest.h>

namespace alidade::test {

namespace {

constexpr uint64_t kSeed = 1991;
using Kind = ToySolid::Kind;

/// A box of any shape about `center`: a point, a segment, a plate or a solid.
Bounds box_about(Draws& draw, const Vec3& center, double size) {
    Vec3 half(0);
    for (int a = 0; a < 3; ++a)
        if (draw.coin()) half[a] = size * draw.uniform();
    return {center - half, center + half};
}

/// Two boxes in [-2, 2]^3, moved and scaled; some share coordinates, so that the pencil of directions holds ones along axes alone.
struct Ends {
    Bounds from, to;
    Ends(Draws& draw, double scale, const Vec3& offset) {
        const Vec3 a = draw.in_box(Vec3(-2), Vec3(2));
        Vec3 b = draw.in_box(Vec3(-2), Vec3(2));
        for (int axis = 0; axis < 3; ++axis)
            if (draw.below(4) == 0) b[axis] = a[axis];
        from = box_about(draw, a * scale + offset, 0.01 * scale), to = box_about(draw, b * scale + offset, 0.7 * scale);
    }
};

std::vector<ToySolid> solids_at(double scale, const Vec3& offset) {
    std::vector<ToySolid> solids = random_solids(300, 0.2, 7);
    solids.push_back({Kind::plane, Vec3(0, 0, 1.5), Vec3(0, 0, 1)});
    for (ToySolid& s : solids) {
        s.center = s.center * scale + offset;
        if (s.kind != Kind::plane) s.size *= scale;
    }
    return solids;
}

void expect_all_met(const Accelerator& accelerator, const ToySet& set, Draws& draw, double scale, const Vec3& offset, size_t& met) {
    const Ends ends(draw, scale, offset);
    std::vector<uint32_t> ids;
    ASSERT_TRUE(accelerator.candidates(Shaft(ends.from, ends.to), set.size(), ids));
    for (int k = 0; k < 8; ++k) {
        Ray ray;
        ray.origin = draw.in_box(ends.from.min, ends.from.max), ray.dir = draw.in_box(ends.to.min, ends.to.max) - ray.origin, ray.tmax = 1;
        std::vector<Hit> hits;
        WorkCounters work;
        accelerator.all_hits(ray, hits, work);
        met += hits.size();
        for (const Hit& hit : hits) ASSERT_TRUE(std::find(ids.begin(), ids.end(), hit.primitive) != ids.end()) << "solid " << hit.primitive << " at " << hit.t << ", scale " << scale << ", offset " << offset.x;
    }
}

TEST(Shaft, LeavesOutNothingThatItsRaysHit) {
    for (const double scale : {1.0, 1e-30, 1e30})
        for (const double offset : {0.0, 1e3, 1e6}) {
            const Vec3 moved(offset * scale, -offset * scale, 0);
            const auto set = std::make_shared<ToySet>(solids_at(scale, moved));
            const auto bvh = find_accelerator("bvh")->over_set(set, {});
            const size_t count = run_size(2000, 200000);
            size_t met = 0;
            for (size_t i = 0; i < count; ++i) {
                Draws draw(RandomKey(kSeed, uint64_t(offset), i, 0));
                ASSERT_NO_FATAL_FAILURE(expect_all_met(*bvh, *set, draw, scale, moved, met)) << "seed " << kSeed << ", shaft " << i;
            }
            EXPECT_GT(met, count) << "the rays must hit something";
        }
}

/// A thin shaft meets few of many solids, all of those that a box around it would.
TEST(Shaft, IsThin) {
    const auto set = std::make_shared<ToySet>(random_solids(4000, 0.02, 8));
    const auto bvh = find_accelerator("bvh")->over_set(set, {});
    std::vector<uint32_t> ids;
    const Shaft diagonal({Vec3(-1), Vec3(-1)}, {Vec3(0.95), Vec3(1.05)});
    ASSERT_TRUE(bvh->candidates(diagonal, set->size(), ids));
    EXPECT_LT(ids.size(), 60u) << "the box around it holds all 4000";
    EXPECT_GT(ids.size(), 0u);
    EXPECT_FALSE(bvh->candidates(diagonal, ids.size() - 1, ids)) << "one too many";
}

TEST(Shaft, MeetsBoxesByClosedForms) {
    const Shaft along_x({Vec3(0), Vec3(0)}, {Vec3(10, -1, -1), Vec3(10, 1, 1)});   // a pyramid
    EXPECT_TRUE(along_x.meets({Vec3(5, 0.4, 0), Vec3(6, 3, 1)}));
    EXPECT_FALSE(along_x.meets({Vec3(5, 0.61, 0), Vec3(6, 3, 1)}));
    EXPECT_TRUE(along_x.meets({Vec3(5, 0.59, 0), Vec3(6, 3, 1)}));
    EXPECT_FALSE(along_x.meets({Vec3(-2, -1, -1), Vec3(-1e-6, 1, 1)})) << "behind";
    EXPECT_FALSE(along_x.meets({Vec3(10 + 1e-6, -1, -1), Vec3(11, 1, 1)})) << "beyond";
    EXPECT_TRUE(along_x.meets({Vec3(-kInf), Vec3(kInf)}));
    EXPECT_TRUE(along_x.meets({Vec3(-kInf, 0.5, -kInf), Vec3(kInf)}));
    EXPECT_FALSE(along_x.meets({Vec3(-kInf, 1.1, -kInf), Vec3(kInf)}));
    EXPECT_FALSE(along_x.meets(Bounds()));
}

}  // namespace
}  // namespace alidade::test
