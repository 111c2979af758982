// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Crossings crossings(const Box& b, const Ray& r) { return find_shape(b)->crossings(b, r); }

Ray ray(const Vec3& origin, const Vec3& dir) {
    Ray r;
    r.origin = origin, r.dir = dir;
    return r;
}

TEST(Box, FacesAreNumberedByAxisAndSide) {
    const Box box{Vec3(1, -2, 3), Vec3(-1, 2, -3)};   // corners in any order
    for (uint32_t face = 0; face < 6; ++face) {
        const int axis = int(face / 2);
        Vec3 dir(0);
        dir[axis] = face % 2 ? -1 : 1;   // comes in through the face
        const Crossings c = crossings(box, ray(-10.0 * dir, dir));
        ASSERT_EQ(c.count, 2);
        EXPECT_EQ(c.at[0].part, face);
        EXPECT_EQ(c.at[1].part, face ^ 1);
        EXPECT_EQ(c.at[0].t, 10 - (axis + 1));
        EXPECT_EQ(c.at[1].t, 10 + (axis + 1));
        EXPECT_EQ(find_shape(box)->surface(box, Vec3(0), face).normal, -dir);
    }
}

/// The oracle: the set of t at which the point lies between the planes, with each comparison made in 64-bit arithmetic and without any division.
/// entry <= t is the same as plane - o <= t d for d > 0.
struct Oracle {
    bool hit = true;
    long double entry = -kInf, exit = kInf;
};

Oracle brute_force(const Box& b, const Ray& r) {
    Oracle o;
    for (int axis = 0; axis < 3; ++axis) {
        const long double low = std::min(b.a[axis], b.b[axis]), high = std::max(b.a[axis], b.b[axis]), at = r.origin[axis], d = r.dir[axis];
        if (d == 0) {
            o.hit = o.hit && low <= at && at <= high;
            continue;
        }
        o.entry = std::max(o.entry, (d > 0 ? low - at : high - at) / d);
        o.exit = std::min(o.exit, (d > 0 ? high - at : low - at) / d);
    }
    o.hit = o.hit && o.entry <= o.exit;
    return o;
}

void expect_agreement(const Box& b, const Ray& r) {
    const Oracle want = brute_force(b, r);
    const Crossings got = crossings(b, r);
    const long double slack = 2e-16L * (1 + std::abs(want.entry) + std::abs(want.exit));
    if (std::abs(want.entry - want.exit) <= slack && want.entry != want.exit) return;   // within a rounding of an edge
    ASSERT_EQ(got.count > 0, want.hit) << "origin " << r.origin.x << " " << r.origin.y << " " << r.origin.z << " dir " << r.dir.x << " " << r.dir.y << " " << r.dir.z;
    if (!want.hit) return;
    ASSERT_EQ(got.count, 2);
    ASSERT_LE(std::abs((long double)got.at[0].t - want.entry), slack);
    ASSERT_LE(std::abs((long double)got.at[1].t - want.exit), slack);
}

TEST(Box, RandomRaysAgainstBruteForce) {
    test::Draw draw(70);
    for (int i = 0; i < 200000; ++i) {
        Box b;
        test::randomize(b, draw);
        expect_agreement(b, test::ray_from(draw.decades(-2, 6), draw));
        if (testing::Test::HasFatalFailure()) FAIL() << i;
    }
}

/// Origins and directions on a lattice that holds the planes, edges and corners of the box: every degenerate case, and every one exact.
TEST(Box, LatticeRaysAgainstBruteForce) {
    const double places[] = {-2, -1, 0, 1, 2}, steps[] = {-1, -0.0, 0.0, 1};
    const Box boxes[] = {{Vec3(-1), Vec3(1)}, {Vec3(-1, 0, -1), Vec3(1, 0, 1)}, {Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {Vec3(1), Vec3(1)}};
    int hits = 0;
    for (const Box& box : boxes)
        for (const double x : places)
            for (const double y : places)
                for (const double z : places)
                    for (const double dx : steps)
                        for (const double dy : steps)
                            for (const double dz : steps) {
                                const Ray r = ray(Vec3(x, y, z), Vec3(dx, dy, dz));
                                if (r.dir == Vec3(0)) continue;
                                expect_agreement(box, r);
                                if (testing::Test::HasFatalFailure()) return;
                                hits += crossings(box, r).count > 0;
                            }
    EXPECT_GT(hits, 2000) << "the test must exercise hits";
}

/// From outside towards a point inside, exactly on edges between two faces that both face the ray, from any distance: never through a gap.
TEST(Box, EdgesDoNotLeak) {
    test::Draw draw(71);
    const Box box{Vec3(-1), Vec3(1)};
    for (int i = 0; i < 100000; ++i) {
        const Vec3 edge(-1, -1, draw(-0.9, 0.9));
        const double distance = draw.decades(0, 8);
        const Vec3 origin = edge - distance * Vec3(draw(0.1, 1), draw(0.1, 1), draw(-1, 1));
        ASSERT_EQ(crossings(box, ray(origin, edge - origin)).count, 2) << i;
    }
}

TEST(Box, AFlatBoxIsHitTwiceAtOnce) {
    const Box flat{Vec3(-1, 2, -1), Vec3(1, 2, 1)};
    const Crossings c = crossings(flat, ray(Vec3(0.5, 0, 0.25), Vec3(0.1, 1, 0)));
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.at[0].t, 2);
    EXPECT_EQ(c.at[1].t, 2);
    EXPECT_EQ(c.at[0].part, 2u);
    EXPECT_EQ(c.at[1].part, 3u);
    EXPECT_GT(length(find_shape(flat)->surface(flat, Vec3(0, 2, 0), 0).dpdv), 0) << "a face without area has tangents";
}

/// Pixels of POV-Ray 3.7.0.10 renders of box { -1, 1 } with uv_mapping gradient x and y, to four digits.
TEST(Box, TextureCoordinatesAreThoseOfPovRay) {
    const ShapeOps& ops = *find_shape(Box());
    const struct {
        Vec3 point;
        Vec2 uv;
    } samples[] = {
        {Vec3(-1, 0.6, 0.6), Vec2(0.2, 0.6)},       {Vec3(1, 0.6, -0.6), Vec2(0.7, 0.6)},     {Vec3(0.6, -1, 0.6), Vec2(0.45, 0.2667)},
        {Vec3(-0.6, 1, 0.6), Vec2(0.3, 0.7333)},    {Vec3(-0.6, -0.6, -1), Vec2(0.95, 0.4)}, {Vec3(0.6, -0.6, 1), Vec2(0.45, 0.4)},
    };
    for (uint32_t face = 0; face < 6; ++face) {
        const SurfacePoint s = ops.surface(Box(), samples[face].point, face);
        EXPECT_NEAR(s.uv.x, samples[face].uv.x, 1e-4) << face;
        EXPECT_NEAR(s.uv.y, samples[face].uv.y, 1e-4) << face;
        EXPECT_EQ(normalized(cross(s.dpdu, s.dpdv)), s.normal) << face;
    }
}

TEST(Box, TheSurfaceIsInside) {
    const ShapeOps& ops = *find_shape(Box());
    EXPECT_TRUE(ops.inside(Box(), Vec3(1, -1, 1)));
    EXPECT_FALSE(ops.inside(Box(), Vec3(1, -1, std::nextafter(1.0, 2.0))));
}

}  // namespace
}  // namespace alidade
