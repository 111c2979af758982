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
    if (draw.below(2) == 0) return box;   // some shapes are narrowed in finite boxes alone
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

/// (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) <= 0, R = 3, r = 1: endless boxes become finite, to a lattice's width outside of the torus.
TEST(Narrow, BoundedPolynomials) {
    Polynomial f;
    f.order = 4, f.coefficients.assign(Polynomial::terms(4), 0.0);
    const auto c = [&](int i, int j, int k) -> double& { return f.coefficients[test::power_index(4, i, j, k)]; };
    c(4, 0, 0) = c(0, 4, 0) = c(0, 0, 4) = 1, c(2, 2, 0) = c(2, 0, 2) = c(0, 2, 2) = 2;
    c(2, 0, 0) = c(0, 0, 2) = 16 - 36, c(0, 2, 0) = 16, c(0, 0, 0) = 64;
    const Bounds all{Vec3(-kInf), Vec3(kInf)}, torus{Vec3(-4, -1, -4), Vec3(4, 1, 4)}, box = narrowed(f, false, all);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(box.min[axis], torus.min[axis]);
        EXPECT_GE(box.max[axis], torus.max[axis]);
        EXPECT_LT(box.extent()[axis], torus.extent()[axis] + 2);
    }
    EXPECT_FALSE(narrowed(f, true, all).finite()) << "outside of it there is no end";
    Polynomial drop = f;   // x^4 - x^2 + y^2 + z^2 <= 0: the highest powers are not of the same degree
    std::fill(drop.coefficients.begin(), drop.coefficients.end(), 0.0);
    const auto d = [&](int i, int j, int k) -> double& { return drop.coefficients[test::power_index(4, i, j, k)]; };
    d(4, 0, 0) = d(0, 2, 0) = d(0, 0, 2) = 1, d(2, 0, 0) = -1;
    const Bounds around = narrowed(drop, false, all);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(around.max[axis], axis == 0 ? 1 : 0.5);
        EXPECT_LT(around.max[axis], axis == 0 ? 1.25 : 0.75);
    }
    c(0, 0, 0) = 1e4;
    EXPECT_TRUE(narrowed(f, false, all).empty()) << "nowhere";
    c(1, 3, 0) = 0.1;
    EXPECT_FALSE(narrowed(f, false, all).finite()) << "the highest terms may be negative, for all that is looked at";
}

/// Random polynomials of order 2, 4 and 6 that do not go on for ever, by either of the two rules: no point inside is lost.
TEST(Narrow, BoundedPolynomialsLoseNothing) {
    test::Draw draw(3);
    int inside = 0;
    for (int round = 0; round < 300; ++round) {
        Polynomial f;
        f.order = 2 + 2 * int(draw.below(3)), f.coefficients.assign(Polynomial::terms(f.order), 0.0);
        const bool apart = draw.below(2) == 0;   // what is not along one axis is never negative; otherwise it is of a lower degree
        for (int i = 0; i <= f.order; ++i)
            for (int j = 0; i + j <= f.order; ++j)
                for (int k = 0; i + j + k <= f.order; ++k) {
                    const bool even = i % 2 == 0 && j % 2 == 0 && k % 2 == 0, pure = std::max({i, j, k}) == i + j + k, highest = i + j + k == f.order;
                    double& c = f.coefficients[test::power_index(f.order, i, j, k)];
                    if (highest && pure) c = draw(0.1, 2);
                    else if (apart ? !pure : highest) c = even ? draw(0, 1) : 0;
                    else c = draw(-2, 1);
                }
        const Bounds box = narrowed(f, false, {Vec3(-kInf), Vec3(kInf)});
        EXPECT_TRUE(box.finite() || box.empty()) << round;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 p = draw.vector(4);
            if (!find_shape(f)->inside(f, p)) continue;
            ++inside;
            ASSERT_TRUE(box.contains(p)) << round;
        }
    }
    EXPECT_GT(inside, 10000);
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
