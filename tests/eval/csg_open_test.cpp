// SPDX-License-Identifier: Apache-2.0
/// All that set operations leave of their surfaces, and what is not solid: discs, cylinders and cones without caps.
#include "tests/core/run_size.h"
#include "tests/eval/csg_leaves.h"

#include <gtest/gtest.h>

using namespace alidade;
using namespace alidade::test;

namespace {

/// Is the point inside of a part that is turned inside out or not? What clips an object is not turned with it.
bool inside_turned(const ShapeLeaves& leaves, const CsgExpression& e, bool inverted, const Vec3& p);

/// A part's surface is left where all other parts hold it (1), where none does (-1), or everywhere (0).
int keeps(const CsgExpression& e, bool inverted) {
    if (e.op == CsgOp::clip) return 1;
    if (e.op == CsgOp::union_ && !inverted) return 0;
    return (e.op == CsgOp::union_ || e.op == CsgOp::merge) == inverted ? 1 : -1;
}

bool turned(const CsgExpression& e, size_t i, bool inverted) {
    if (i > 0 && e.op == CsgOp::clip) return false;
    return inverted != (i > 0 && e.op == CsgOp::difference);
}

bool inside_turned(const ShapeLeaves& leaves, const CsgExpression& e, bool inverted, const Vec3& p) {
    inverted = inverted != e.inverse;
    if (e.op == CsgOp::leaf) return leaves.inside(e.leaf.id, p) != inverted;
    const bool all = keeps(e, inverted) > 0;
    for (size_t i = 0; i < e.parts.size(); ++i)
        if (inside_turned(leaves, e.parts[i], turned(e, i, inverted), p) != all) return !all;
    return all;
}

/// The crossings that the operations leave, found at the points: the oracle, also for what is not solid. It knows no boxes. A line is kept if its crossings are apart.
void left(const ShapeLeaves& leaves, const CsgExpression& e, bool inverted, const Ray& ray, std::vector<double>& out) {
    inverted = inverted != e.inverse;
    if (e.op == CsgOp::leaf) {
        std::vector<CsgCrossing> crossings;
        leaves.crossings(e.leaf.id, ray, crossings);
        for (const CsgCrossing& c : crossings) out.push_back(c.hit.t);
        return;
    }
    const int keep = keeps(e, inverted);
    for (size_t i = 0; i < (e.op == CsgOp::clip ? 1 : e.parts.size()); ++i) {
        std::vector<double> own;
        left(leaves, e.parts[i], turned(e, i, inverted), ray, own);
        for (const double t : own) {
            bool stays = true;
            for (size_t k = 0; keep != 0 && k < e.parts.size(); ++k)
                stays = stays && (k == i || inside_turned(leaves, e.parts[k], turned(e, k, inverted), ray.at(t)) == (keep > 0));
            if (stays) out.push_back(t);
        }
    }
}

/// All operations, of solids, of what has no end, and of discs, cylinders and cones without caps, whose surfaces end where their insides need not: no box cuts any of them off.
TEST(Csg, SurfacesAreThoseOfTheirParts) {
    test::Draw draw(11);
    int found = 0, finite = 0;
    for (size_t round = 0; round < run_size(9000); ++round) {
        ShapeLeaves leaves;
        leaves.solid_alone = round % 3 != 0;
        const CsgExpression e = random_expression(leaves, draw, 1 + round % 4, false, round % 3 == 1);
        const Ray ray = whole_line(test::ray_from(6, draw));
        const std::vector<double> at = cuts(leaves, ray);
        if (at.empty()) continue;
        std::vector<double> expected;
        left(leaves, e, false, ray, expected);
        std::sort(expected.begin(), expected.end());
        ASSERT_EQ(distances(surfaces(e, leaves, ray)), expected) << "round " << round;
        found += int(expected.size()), finite += CsgTree(e, leaves.narrow()).bounds().finite();
    }
    EXPECT_GT(found, 3000 * run_scale());
    EXPECT_GT(finite, 2000 * run_scale());
}

/// What is open or flat has a box for its surface, wherever its inside ends.
TEST(Csg, WhatIsNotSolidHasABox) {
    ShapeLeaves leaves;
    const CsgExpression ball = leaves.add(Sphere{Vec3(0), 0.5}), pipe = leaves.add(Cylinder{Vec3(0), Vec3(1, 0, 0), 0.3, true}), disc = leaves.add(Disc{Vec3(0), Vec3(1, 0, 0), 3, 0});
    const auto box = [&](const CsgExpression& e) { return CsgTree(e, leaves.narrow()).bounds(); };
    for (const CsgExpression& part : {pipe, disc}) {
        for (const CsgOp op : {CsgOp::merge, CsgOp::union_, CsgOp::difference, CsgOp::intersection}) EXPECT_TRUE(box(of(op, {part, ball})).finite());
        EXPECT_TRUE(box(of(CsgOp::clip, {part, inverse(ball)})).finite());
        EXPECT_TRUE(box(of(CsgOp::clip, {of(CsgOp::union_, {part, ball}), inverse(leaves.add(Plane{Vec3(0, 1, 0), 0}))})).finite());
    }
    EXPECT_LT(max_abs(box(of(CsgOp::merge, {pipe, ball})).max - Vec3(1, 0.5, 0.5)), 1e-12);
    EXPECT_FALSE(box(of(CsgOp::merge, {disc, leaves.add(Plane{Vec3(1, 1, 0), 0})})).finite());
}

TEST(Csg, WhatIsNotSolidIsAskedAtPoints) {
    ShapeLeaves leaves;
    const CsgExpression box = leaves.add(Box{Vec3(-5), Vec3(5)}), pipe = leaves.add(Cylinder{Vec3(-1, 0, 0), Vec3(1, 0, 0), 1, true}), disc = leaves.add(Disc{Vec3(0), Vec3(1, 0, 0), 3, 0});
    Ray ray;
    ray.origin = Vec3(-20, 0.01, 0.02), ray.dir = Vec3(1, 0, 0);
    const auto at = [&](const CsgExpression& e) {
        std::vector<double> x = distances(surfaces(e, leaves, ray));
        for (double& t : x) t -= 20;
        return x;
    };
    using List = std::vector<double>;
    EXPECT_EQ(at(of(CsgOp::intersection, {box, disc})), (List{-5, 0}));
    EXPECT_EQ(at(of(CsgOp::difference, {box, disc})), (List{0, 5}));
    EXPECT_EQ(at(of(CsgOp::difference, {box, pipe})), (List{-5, 5}));
    EXPECT_EQ(at(of(CsgOp::intersection, {box, pipe})), List());
    ray.origin = Vec3(0, 0.01, -20), ray.dir = Vec3(0, 0, 1);
    EXPECT_EQ(at(of(CsgOp::difference, {box, pipe})).size(), 4u);
    EXPECT_EQ(at(of(CsgOp::clip, {box, pipe})), List());
}

}  // namespace
