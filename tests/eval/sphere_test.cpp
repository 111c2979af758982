// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Crossings crossings(const Sphere& s, const Ray& ray) { return find_shape(s)->crossings(s, ray); }

Ray ray(const Vec3& origin, const Vec3& dir) {
    Ray r;
    r.origin = origin, r.dir = dir;
    return r;
}

TEST(Sphere, OfTheLecture) {
    const Crossings c = crossings({Vec3(0, 0, 5), 2}, ray(Vec3(0), Vec3(0, 0, 0.5)));
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.at[0].t, 6);
    EXPECT_EQ(c.at[1].t, 14);
}

TEST(Sphere, ANegativeRadiusDrawsAsAPositiveOne) {
    const Crossings c = crossings({Vec3(0, 0, 5), -2}, ray(Vec3(0), Vec3(0, 0, 1)));
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.at[0].t, 3);
    EXPECT_TRUE(find_shape(Sphere())->inside(Sphere{Vec3(0), -1}, Vec3(0.5)));
}

/// A tangent is met twice at one t, whichever way it is approached: entries and exits pair.
TEST(Sphere, TangentsAreTwiceOrNotAtAll) {
    const Crossings c = crossings({Vec3(0), 1}, ray(Vec3(1, 0, -5), Vec3(0, 0, 1)));
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.at[0].t, c.at[1].t);
    EXPECT_EQ(crossings({Vec3(0), 1}, ray(Vec3(std::nextafter(1.0, 2.0), 0, -5), Vec3(0, 0, 1))).count, 0);
    test::Draw draw(50);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 dir = draw.direction();
        Vec3 side, up;
        orthonormal_basis(dir, side, up);
        ASSERT_NE(crossings({Vec3(0), 1}, ray(side - 5.0 * dir, dir)).count, 1);
    }
}

/// From 1e12 radii away the first shift is rounded by 1e-4 radii: only the second one lets a silhouette be decided.
TEST(Sphere, TheSilhouetteIsSharpFromTrillionsOfRadii) {
    test::Draw draw(54);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 dir(0, 0, draw(0.1, 10));   // parallel to an axis: the distance of the line from the centre is exact
        for (const double depth : {1e-14, 1e-12, 1e-9}) {
            ASSERT_EQ(crossings({Vec3(0), 1}, ray(Vec3(1 - depth, 0, -1e12), dir)).count, 2) << depth;
            ASSERT_EQ(crossings({Vec3(0), 1}, ray(Vec3(1 + depth, 0, -1e12), dir)).count, 0) << depth;
        }
    }
}

/// As pixels of POV-Ray 3.7.0.10 renders of sphere { 0, 1 } with uv_mapping show them.
TEST(Sphere, TextureCoordinatesAroundTheEquatorAndAtThePoles) {
    const ShapeOps& ops = *find_shape(Sphere());
    const Sphere s{Vec3(1, 2, 3), 2};
    const auto uv = [&](const Vec3& dir) { return ops.surface(s, s.center + 2.0 * dir, 0).uv; };
    EXPECT_EQ(uv({1, 0, 0}), Vec2(0, 0.5));
    EXPECT_EQ(uv({0, 0, 1}), Vec2(0.25, 0.5));
    EXPECT_EQ(uv({-1, 0, 0}), Vec2(0.5, 0.5));
    EXPECT_EQ(uv({0, 0, -1}), Vec2(0.75, 0.5));
    EXPECT_EQ(uv({0, 1, 0}), Vec2(0, 1));
    EXPECT_EQ(uv({0, -1, 0}), Vec2(0, 0));
    EXPECT_GT(length(ops.surface(s, s.center + Vec3(0, 2, 0), 0).dpdu), 1) << "a pole has tangents too";
}

}  // namespace
}  // namespace alidade
