// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Crossings crossings(const Polygon& p, const Vec3& origin, const Vec3& dir) {
    Ray ray;
    ray.origin = origin, ray.dir = dir;
    return find_shape(p)->crossings(p, ray);
}

const std::vector<Vec3> kSquare = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}, kHole = {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};

TEST(Polygon, AHoleIsALoopTurnedEitherWay) {
    for (const bool turned : {false, true}) {
        Polygon p{{kSquare, kHole}};
        if (turned) std::reverse(p.loops[1].begin(), p.loops[1].end());
        EXPECT_EQ(crossings(p, Vec3(0.5, 0.5, -5), Vec3(0, 0, 2)).count, 1);
        EXPECT_EQ(crossings(p, Vec3(0.5, 0.5, -5), Vec3(0, 0, 2)).at[0].t, 2.5);
        EXPECT_EQ(crossings(p, Vec3(1.5, 1.5, -5), Vec3(0, 0, 2)).count, 0);
        EXPECT_EQ(crossings(p, Vec3(3.5, 1.5, -5), Vec3(0, 0, 2)).count, 0);
        EXPECT_EQ(crossings(p, Vec3(-1, 1.5, 0), Vec3(1, 0, 0)).count, 0) << "in its plane";
    }
}

TEST(Polygon, HasNoInside) {
    const Polygon p{{kSquare}};
    EXPECT_FALSE(find_shape(p)->inside(p, Vec3(1, 1, 0)));
    EXPECT_FALSE(find_shape(p)->inside(p, Vec3(1, 1, -1)));
    EXPECT_FALSE(find_shape(p)->solid(p));
}

/// As POV-Ray 3.7 has it: by the first corner, also where that one turns against all others.
TEST(Polygon, TheNormalIsThatOfTheFirstCorner) {
    const std::vector<Vec3> arrow = {{-1, -1, 0}, {0, 0, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}};
    EXPECT_EQ(normal_of(Polygon{{arrow}}), Vec3(0, 0, 1));
    std::vector<Vec3> later = arrow;
    std::rotate(later.begin(), later.begin() + 1, later.end());
    EXPECT_EQ(normal_of(Polygon{{later}}), Vec3(0, 0, -1));
    EXPECT_EQ(normal_of(Polygon{{{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}), Vec3(0, 0, 1)) << "three points in a line";
    EXPECT_EQ(normal_of(Polygon{{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}}), Vec3(0));
    EXPECT_EQ(normal_of(Polygon{{}}), Vec3(0));
    EXPECT_EQ(crossings(Polygon{{}}, Vec3(0, 0, -1), Vec3(0, 0, 1)).count, 0);
}

/// Rays through the corners and sides of a fan of triangles hit one of them at least: sides belong to one neighbour.
TEST(Polygon, NeighboursLeaveNoGapAlongAxes) {
    const Polygon left{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}}, right{{{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}}};
    for (int i = 0; i < 100; ++i) {
        const Vec3 from(1, (i + 0.5) / 100, -3);
        EXPECT_EQ(crossings(left, from, Vec3(0, 0, 1)).count + crossings(right, from, Vec3(0, 0, 1)).count, 1) << i;
    }
}

}  // namespace
}  // namespace alidade
