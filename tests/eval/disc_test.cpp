// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Crossings crossings(const Disc& d, const Vec3& origin, const Vec3& dir) {
    Ray ray;
    ray.origin = origin, ray.dir = dir;
    return find_shape(d)->crossings(d, ray);
}

TEST(Disc, IsHitBetweenItsHoleAndItsRim) {
    const Disc d{Vec3(1, 2, 3), Vec3(0, 0, 5), 2, 0.5};
    for (const auto& [x, hits] : {std::pair(0.0, 0), {0.49, 0}, {0.5, 1}, {1.9, 1}, {2.0, 1}, {2.001, 0}}) {
        const Crossings c = crossings(d, Vec3(1 + x, 2, 13), Vec3(0, 0, -2));
        ASSERT_EQ(c.count, hits) << x;
        if (hits > 0) {
            EXPECT_EQ(c.at[0].t, 5);
        }
    }
}

TEST(Disc, NegativeRadiiDrawAsPositiveOnes) {
    EXPECT_EQ(crossings({Vec3(0), Vec3(0, 1, 0), -1, -0.5}, Vec3(0.75, 1, 0), Vec3(0, -1, 0)).count, 1);
    EXPECT_EQ(crossings({Vec3(0), Vec3(0, 1, 0), -1, -0.5}, Vec3(0.25, 1, 0), Vec3(0, -1, 0)).count, 0);
}

TEST(Disc, WithoutANormalOrAlongItNothingIsHit) {
    EXPECT_EQ(crossings({Vec3(0), Vec3(0), 1, 0}, Vec3(0, 1, 0), Vec3(0, -1, 0)).count, 0);
    EXPECT_EQ(crossings(Disc(), Vec3(-5, 0, 0), Vec3(1, 0, 0)).count, 0);
}

TEST(Disc, ItsInsideIsAHalfSpaceAndTheHoleIsNot) {
    const Disc d{Vec3(0), Vec3(0, 1, 0), 1, 0.5};
    const ShapeOps& ops = *find_shape(d);
    EXPECT_TRUE(ops.inside(d, Vec3(100, -1, 0)));
    EXPECT_TRUE(ops.inside(d, Vec3(0, -1, 0)));
    EXPECT_FALSE(ops.inside(d, Vec3(0, 1, 0)));
    EXPECT_FALSE(ops.solid(d));
}

#ifdef ALIDADE_HAS_QUAD
/// t against the plane equation in 113 bits, from near and far.
TEST(Disc, DistancesAgainst113Bits) {
    test::Draw draw(60);
    for (const double distance : {4.0, 1e4, 1e8}) {
        double worst = 0;
        int hits = 0;
        for (int i = 0; i < 20000; ++i) {
            Disc d;
            test::randomize(d, draw);
            const Ray ray = test::ray_from(distance, draw);
            const double cosine = std::abs(dot(normalized(d.normal), normalized(ray.dir)));
            const Crossings c = find_shape(d)->crossings(d, ray);
            if (c.count == 0 || cosine < 0.05) continue;
            ++hits;
            const test::QuadVec n(d.normal);
            const test::Quad want = dot(n, test::QuadVec(d.center) - test::QuadVec(ray.origin)) / dot(n, test::QuadVec(ray.dir));
            const double unit = std::numeric_limits<double>::epsilon() * (std::abs(c.at[0].t) + 4 / length(ray.dir));
            worst = std::max(worst, double(fabsq(test::Quad(c.at[0].t) - want)) / unit * cosine);
        }
        EXPECT_GT(hits, 3000);
        std::printf("[          ] from %g: %.2f eps (|t| + 4 / |d|) / cosine\n", distance, worst);
        EXPECT_LT(worst, 4);
    }
}
#endif

}  // namespace
}  // namespace alidade
