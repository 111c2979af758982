// SPDX-License-Identifier: Apache-2.0
/// Boxes of what is placed: they hold it, and no more than the moved box of the whole does.
#include "accel/cell_boxes.h"
#include "core/draws.h"
#include "numerics/triangles/meshes.h"

#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;
namespace {

Transform anywhere(Draws& draws) {
    const Vec3 a(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1)), b(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1));
    Transform t = Transform::translate(a * std::ldexp(1.0, int(draws.below(40)) - 20));
    t.linear = {a, b, cross(a, b)};
    return t;
}

void expect_holds(const TriangleView& view, Draws& draws, const std::string& name) {
    Bounds all;
    for (const Vec3f& p : view.positions) all.extend(Vec3(p));
    const CellBoxes cells(view);
    ASSERT_LE(cells.cells().size(), 64u) << name;
    for (int i = 0; i < 20; ++i) {
        const Transform to_world = anywhere(draws);
        const Bounds placed = cells.placed(to_world, all), whole = to_world.bounds(all);
        for (const Index3& triangle : view.triangles)
            for (int k = 0; k < 3; ++k) ASSERT_TRUE(placed.contains(to_world.point(Vec3(view.positions[triangle[k]])))) << name;
        ASSERT_TRUE(whole.contains(placed.min) && whole.contains(placed.max)) << name;
    }
}

TEST(CellBoxes, HoldWhatIsPlaced) {
    Draws draws(RandomKey(81, 0, 0, 0));
    for (const TriangleMesh& mesh : small_meshes()) expect_holds({mesh.positions, {}, mesh.triangles}, draws, mesh.name);
}

TEST(CellBoxes, AreSmallAroundATurnedBall) {
    const TriangleMesh ball = geodesic_sphere(20);
    Draws draws(RandomKey(82, 0, 0, 0));
    double parts = 0, whole = 0;
    const CellBoxes cells({ball.positions, {}, ball.triangles});
    const Bounds all{Vec3(-1), Vec3(1)};
    for (int i = 0; i < 100; ++i) {
        Transform turn;
        orthonormal_basis(normalized(Vec3(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1))), turn.linear[0], turn.linear[1]);
        turn.linear[2] = cross(turn.linear[0], turn.linear[1]);
        parts += cells.placed(turn, all).half_area(), whole += turn.bounds(all).half_area();
    }
    EXPECT_LT(parts, 0.75 * whole);
    EXPECT_GT(parts, 100 * 12) << "a ball's own box";
}

TEST(CellBoxes, PassOverWhatHasNoPlace) {
    const Vec3f corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}, {std::numeric_limits<float>::infinity(), 0, 0}};
    const Index3 triangles[] = {{0, 1, 2}, {0, 1, 3}, {1, 2, 4}, {0, 1, 5}};   // the last names no vertex
    const CellBoxes boxes({corners, {}, triangles});
    ASSERT_EQ(boxes.cells().size(), 1u);
    EXPECT_EQ(boxes.cells()[0].middle, Vec3(0.5, 0.5, 0));
    EXPECT_EQ(boxes.cells()[0].half, Vec3(0.5, 0.5, 0));
    const Bounds all{Vec3(-1), Vec3(2)};
    EXPECT_TRUE(CellBoxes({corners, {}, {}}).cells().empty());
    EXPECT_EQ(CellBoxes({corners, {}, {}}).placed(Transform(), all).min, Transform().bounds(all).min) << "nothing is known of it";
    const Vec3 far[] = {{-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}, Vec3(0), Vec3(0)};
    EXPECT_TRUE(CellBoxes({corners, far, {triangles, 1}}).cells().empty());
    const Bounds endless{Vec3(-kInf), Vec3(kInf)};
    EXPECT_EQ(boxes.placed(Transform(), endless).max, Vec3(kInf));
}

TEST(CellBoxes, HaveTheCornersOfBothPrecisions) {
    const Vec3f corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Vec3 exact[] = {{-1e-9, 0, 0}, {1, 0, 0}, {0, 1 + 1e-9, 0}};
    const Index3 triangles[] = {{0, 1, 2}};
    const Bounds placed = CellBoxes({corners, exact, triangles}).placed(Transform(), {Vec3(-1), Vec3(2)});
    EXPECT_LE(placed.min.x, -1e-9);
    EXPECT_GE(placed.max.y, 1 + 1e-9);
    EXPECT_LT(placed.max.y, 1 + 2e-9);
}

}  // namespace
}  // namespace alidade::test
