// SPDX-License-Identifier: Apache-2.0
/// Boxes around what is inside of endless shapes within a box.
#include "eval/csg.h"
#include "eval/shapes/narrow.h"
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Bounds random_box(test::Draw& draw) {
    Bounds box;
    box.extend(draw.vector(3)), box.extend(draw.vector(3));
    for (int axis = 0; axis < 3; ++axis) {
        if (draw.below(3) == 0) box.min[axis] = -kInf;
        if (draw.below(3) == 0) box.max[axis] = kInf;
    }
    return box;
}

/// In the box, and not too far away where it has no side.
Vec3 point_in(const Bounds& box, test::Draw& draw) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = draw.decades(-1, 3), low = std::isfinite(box.min[axis]) ? box.min[axis] : std::min(box.max[axis], 0.0) - reach;
        p[axis] = draw(low, std::isfinite(box.max[axis]) ? box.max[axis] : low + 2 * reach);
    }
    return p;
}

TEST(Narrow, LosesNothing) {
    test::Draw draw(1);
    for (const ShapeOps& ops : shapes()) {
        if (!ops.narrow) continue;
        int inside = 0, narrower = 0;
        for (int round = 0; round < 3000; ++round) {
            const ShapeGeometry shape = test::sample_shape(ops, round, draw);
            const Bounds box = random_box(draw);
            const bool outside = draw.below(2) == 0;
            const Bounds narrow = ops.narrow(shape, outside, box);
            narrower += narrow.min != box.min || narrow.max != box.max;
            for (int i = 0; i < 30; ++i) {
                const Vec3 p = point_in(box, draw);
                if (ops.inside(shape, p) == outside) continue;
                ++inside;
                ASSERT_TRUE(narrow.contains(p)) << ops.name << " round " << round;
            }
        }
        EXPECT_GT(inside, 10000) << ops.name;
        EXPECT_GT(narrower, 300) << ops.name;
    }
}

void expect_box(const Bounds& box, const Vec3& min, const Vec3& max) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], min[axis], 1e-9);
        EXPECT_NEAR(box.max[axis], max[axis], 1e-9);
    }
}

const Bounds kSlab{Vec3(-kInf, 1, -kInf), Vec3(kInf, 3, kInf)};

TEST(Narrow, ClosedForms) {
    const double root10 = std::sqrt(10.0), root3 = std::sqrt(3.0);
    expect_box(narrowed(Quadric{{1, -1, 1}, Vec3(0), Vec3(0), -1}, false, kSlab), {-root10, 1, -root10}, {root10, 3, root10});              // x^2 + z^2 <= 1 + y^2
    expect_box(narrowed(Quadric{{1, 0, 1}, Vec3(0), {0, -1, 0}, 0}, false, kSlab), {-root3, 1, -root3}, {root3, 3, root3});                 // x^2 + z^2 <= y
    expect_box(narrowed(Quadric{{1, 0, 1}, Vec3(0), {-4, 0, 0}, 3}, false, kSlab), {1, 1, -1}, {3, 3, 1});                                  // around x = 2
    EXPECT_TRUE(narrowed(Quadric{{1, 0, 1}, Vec3(0), {0, 1, 0}, 0}, false, kSlab).empty());                                                // x^2 + z^2 <= -y
    EXPECT_FALSE(narrowed(Quadric{{1, -1, 1}, Vec3(0), Vec3(0), -1}, true, kSlab).finite());                                                // all that is outside of it
}

CsgExpression leaf(uint32_t id) {
    CsgExpression e;
    e.leaf = {id, CsgInside::by_crossings, {Vec3(-kInf), Vec3(kInf)}, false};
    return e;
}

/// A wedge of planes none of which has a box: each side follows from others.
TEST(Narrow, PlanesOfAnIntersectionBoundEachOther) {
    const ShapeGeometry planes[] = {Plane{{0, 1, 0}, -0.15}, Plane{{0, -1, 0}, 3}, Plane{{0, 0, -1}, 35}, Plane{{-1, 0, 1}, 0}, Plane{{1, 0, 1}, 0}};
    CsgExpression e;
    e.op = CsgOp::intersection;
    for (uint32_t i = 0; i < 5; ++i) e.parts.push_back(leaf(i));
    const CsgTree tree(e, [&](uint32_t id, bool inverted, const Bounds& box) { return find_shape(planes[id])->narrow(planes[id], inverted, box); });
    expect_box(tree.bounds(), {-35, -3, -35}, {35, -0.15, 35});
}

}  // namespace
}  // namespace alidade
