// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Crossings crossings(const Plane& p, const Vec3& origin, const Vec3& dir) {
    Ray r;
    r.origin = origin, r.dir = dir;
    return find_shape(p)->crossings(p, r);
}

TEST(Plane, DistanceCountsUnitNormals) {
    const Crossings c = crossings({Vec3(0, 5, 0), 3}, Vec3(7, 0, 7), Vec3(0, 2, 0));
    ASSERT_EQ(c.count, 1);
    EXPECT_EQ(c.at[0].t, 1.5);
}

TEST(Plane, ParallelRaysMiss) {
    EXPECT_EQ(crossings({Vec3(0, 1, 0), 0}, Vec3(0, 1, 0), Vec3(1, 0, 0)).count, 0);
    EXPECT_EQ(crossings({Vec3(0, 1, 0), 0}, Vec3(0, 0, 0), Vec3(1, 0, 0)).count, 0) << "in the plane";
    EXPECT_EQ(crossings({Vec3(0, 1, 0), 0}, Vec3(0, 1e300, 0), Vec3(1, -1e-300, 0)).count, 0) << "t is not a number any more";
    EXPECT_EQ(crossings({Vec3(0), 0}, Vec3(0), Vec3(1)).count, 0) << "no normal";
}

TEST(Plane, TheSolidIsOppositeToTheNormal) {
    const ShapeOps& ops = *find_shape(Plane());
    const Plane p{Vec3(0, 0, 2), 1};
    EXPECT_TRUE(ops.inside(p, Vec3(5, 5, 0.9)));
    EXPECT_TRUE(ops.inside(p, Vec3(5, 5, 1)));
    EXPECT_FALSE(ops.inside(p, Vec3(5, 5, 1.1)));
    EXPECT_EQ(ops.bounds(p).max, Vec3(kInf));
}

TEST(Plane, TextureCoordinatesOfTheGround) {
    const SurfacePoint s = find_shape(Plane())->surface(Plane(), Vec3(3, 0, 5), 0);
    EXPECT_EQ(s.uv, Vec2(3, -5));
    EXPECT_EQ(s.normal, Vec3(0, 1, 0));
    EXPECT_EQ(cross(s.dpdu, s.dpdv), s.normal);
}

#ifdef ALIDADE_HAS_QUAD
/// t against 113 bits: the error of t is that of the height of the origin above the plane.
TEST(Plane, CrossingsAgainst113Bits) {
    test::Draw draw(60);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        Plane p;
        test::randomize(p, draw);
        const Ray r = test::ray_from(draw.decades(-2, 8), draw);
        const Crossings got = crossings(p, r.origin, r.dir);
        ASSERT_EQ(got.count, 1);
        const test::QuadVec n(p.normal), o(r.origin), d(r.dir);
        const test::Quad want = (test::Quad(p.distance) * test::length(n) - test::dot(n, o)) / test::dot(n, d);
        const double speed = std::abs(dot(p.normal, r.dir)) / length(p.normal), size = length(r.origin) + std::abs(p.distance);
        const double growth = 1 + length(p.normal) * length(r.dir) / std::abs(dot(p.normal, r.dir));   // of dot(normal, dir) when it cancels
        worst = std::max(worst, double(fabsq(test::Quad(got.at[0].t) - want)) * speed / size / growth);
    }
    EXPECT_LT(worst, 4 * std::numeric_limits<double>::epsilon());
}
#endif

}  // namespace
}  // namespace alidade
