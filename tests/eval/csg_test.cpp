// SPDX-License-Identifier: Apache-2.0
/// Set operations on a line, against what is inside at every point of it.
#include "tests/core/run_size.h"
#include "tests/eval/csg_leaves.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using namespace test;

/// Between two neighbouring crossings nothing changes; at one of them either the whole does, and that is a surface of it, or it does not: then there is a
/// surface only where a union shows its inner ones.
TEST(Csg, SurfacesAreWhereTheWholeChanges) {
    test::Draw draw(1);
    int changes = 0, inner = 0;
    for (size_t round = 0; round < run_size(3000); ++round) {
        ShapeLeaves leaves;
        const bool outline = round % 2;
        const CsgExpression e = random_expression(leaves, draw, 1 + round % 4, outline, round % 3 == 0);
        const Ray ray = whole_line(test::ray_from(6, draw));
        const std::vector<double> at = cuts(leaves, ray);
        if (at.empty()) continue;
        std::vector<double> expected;
        const auto between = [&](size_t i) { return i == 0 ? at[0] - 1 : i == at.size() ? at.back() + 1 : 0.5 * (at[i - 1] + at[i]); };
        for (size_t i = 0; i < at.size(); ++i)
            if (inside(leaves, e, ray.at(between(i))) != inside(leaves, e, ray.at(between(i + 1)))) expected.push_back(at[i]);
        std::vector<double> found;
        for (const Hit& hit : surfaces(e, leaves, ray)) found.push_back(hit.t);
        if (outline) {
            ASSERT_EQ(found, expected) << "round " << round;
        }
        changes += int(expected.size()), inner += int(found.size() - std::min(expected.size(), found.size()));
    }
    EXPECT_GT(changes, 2000 * run_scale());
    EXPECT_GT(inner, 100 * run_scale()) << "unions must be among them";
}

/// A cap of a sphere above a plane: the line leaves the sphere below the plane, and comes into a corner of the cap's box after that.
TEST(Csg, WhereALineIsInThePartsOneAfterTheOtherThereIsNothing) {
    ShapeLeaves leaves;
    const CsgExpression cap = of(CsgOp::intersection, {leaves.add(Sphere{Vec3(0), 1}), inverse(leaves.add(Plane{Vec3(0, 1, 0), 0.5}))});
    const CsgExpression floor = leaves.add(Plane{Vec3(0, 1, 0), -5});   // endless, so that the whole line is looked at
    Ray ray;
    ray.origin = Vec3(0, -0.2, 0), ray.dir = Vec3(1, 0.875, 1);
    const std::vector<Hit> found = surfaces(of(CsgOp::merge, {cap, floor}), leaves, whole_line(ray));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].t, -4.8 / 0.875, 1e-12);
}

TEST(Csg, TheFirstSurfaceIsTheFirstOfAll) {
    test::Draw draw(2);
    int found = 0;
    for (size_t round = 0; round < run_size(3000); ++round) {
        ShapeLeaves leaves;
        const CsgExpression e = random_expression(leaves, draw, 1 + round % 4, false, round % 3 == 0);
        Ray ray = test::ray_from(draw(0, 6), draw);
        ray.tmax = draw(0, 20);
        const std::vector<Hit> all = surfaces(e, leaves, whole_line(ray));
        const auto first = std::find_if(all.begin(), all.end(), [&](const Hit& h) { return h.t >= ray.tmin; });
        Hit hit;
        const bool any = CsgTree(e, leaves.narrow()).first(ray, leaves, hit);
        ASSERT_EQ(any, first != all.end() && first->t <= ray.tmax) << "round " << round;
        if (!any) continue;
        ++found;
        ASSERT_EQ(hit.t, first->t);
        ASSERT_EQ(hit.instance, first->instance);
    }
    EXPECT_GT(found, 500 * run_scale());
}

/// A box that rays stay in, and what its corners and the boxes of shapes tell of it.
class BoxRegion final : public CsgRegion {
  public:
    BoxRegion(const ShapeLeaves& leaves, const Bounds& box) : leaves_(leaves), box_(box) {}
    bool meets(const Bounds& box) const override { return box_.overlaps(box); }
    CsgSide side(uint32_t id) const override {
        const ShapeGeometry& shape = leaves_.shapes[id];
        const ShapeOps& ops = *find_shape(shape);
        if (!box_.overlaps(ops.bounds(shape)) || (ops.narrow && ops.narrow(shape, false, box_).empty())) return CsgSide::outside;
        if (ops.narrow && ops.narrow(shape, true, box_).empty()) return CsgSide::inside;
        bool all = ops.convex;
        for (int c = 0; c < 8; ++c) all = all && ops.inside(shape, {c & 1 ? box_.min.x : box_.max.x, c & 2 ? box_.min.y : box_.max.y, c & 4 ? box_.min.z : box_.max.z});
        return all ? CsgSide::inside : CsgSide::varies;
    }
    Vec3 point(test::Draw& draw) const { return {draw(box_.min.x, box_.max.x), draw(box_.min.y, box_.max.y), draw(box_.min.z, box_.max.z)}; }

  private:
    const ShapeLeaves& leaves_;
    const Bounds& box_;
};

/// To rays in a part of space, what is known of the nodes there changes nothing, and where the side of the whole is known they meet nothing.
TEST(Csg, KnownSidesChangeNothing) {
    test::Draw draw(9);
    int found = 0, known = 0, inner = 0, whole = 0;
    for (size_t round = 0; round < run_size(8000); ++round) {
        ShapeLeaves leaves;
        const CsgExpression e = random_expression(leaves, draw, 1 + round % 4, false, round % 3 == 0);
        const CsgTree tree(e, leaves.narrow());
        const Vec3 middle(draw(-2, 2), draw(-2, 2), draw(-2, 2)), half(draw(0.01, 0.6));
        const Bounds box{middle - half, middle + half};
        const BoxRegion region(leaves, box);
        std::vector<CsgSide> sides(7);   // which stay
        const CsgSide side = tree.sides(region, sides);
        ASSERT_EQ(sides.size(), 7 + tree.nodes().size());
        const std::span<const CsgSide> those = std::span(sides).subspan(7);
        known += std::count_if(those.begin(), those.end(), [](CsgSide s) { return s != CsgSide::varies; }) > 0;
        for (size_t n = 1; n < those.size(); ++n) inner += tree.nodes()[n].op != CsgOp::leaf && those[n] == CsgSide::inside;
        whole += side == CsgSide::inside;
        for (int i = 0; i < 4; ++i) {
            Ray ray;
            ray.origin = region.point(draw), ray.dir = region.point(draw) - ray.origin, ray.tmax = 1;
            Hit want, got;
            const bool hit = tree.first(ray, leaves, want);
            ASSERT_EQ(tree.first(ray, leaves, got, those), hit) << "round " << round;
            ASSERT_TRUE(!hit || (got.t == want.t && got.instance == want.instance));
            ASSERT_TRUE(side == CsgSide::varies || (!hit && tree.inside(ray.origin, leaves) == (side == CsgSide::inside))) << "round " << round;
            found += hit;
        }
    }
    EXPECT_GT(found, 1000 * run_scale());
    EXPECT_GT(known, 1000 * run_scale());
    EXPECT_GT(inner, 100 * run_scale());
    EXPECT_GT(whole, 100 * run_scale());
}

/// Of many parts that all are near, not all are looked at, and what was not looked at varies; groups of them are seen by the rays that see the whole.
TEST(Csg, TheSearchForSidesIsGivenUp) {
    test::Draw draw(10);
    ShapeLeaves leaves;
    CsgExpression e = of(CsgOp::difference, {leaves.add(Plane{{0, 1, 0}, 0.1})});
    for (int i = 0; i < 600; ++i) e.parts.push_back(leaves.add(Sphere{draw.vector(0.5), draw(0.4, 0.6)}));
    e.mask = kMaskShadow;
    const CsgTree tree(e, leaves.narrow());
    const Bounds box{Vec3(-1, -0.2, -1), Vec3(1, 0.2, 1)};
    const BoxRegion region(leaves, box);
    std::vector<CsgSide> sides;
    EXPECT_EQ(tree.sides(region, sides), CsgSide::varies);
    for (const CsgNode& node : tree.nodes()) EXPECT_EQ(node.mask, kMaskShadow);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        Ray ray;
        ray.origin = region.point(draw), ray.dir = region.point(draw) - ray.origin, ray.tmax = 1, ray.mask = kMaskShadow;
        Hit want, got;
        const bool hit = tree.first(ray, leaves, want);
        ASSERT_EQ(tree.first(ray, leaves, got, sides), hit);
        ASSERT_TRUE(!hit || (got.t == want.t && got.instance == want.instance));
        found += hit;
    }
    EXPECT_GT(found, 30);
}

/// The same numbers by other ways: faces that coincide but for roundings.
TEST(Csg, FacesThatCoincideAreOne) {
    test::Draw draw(6);
    for (int round = 0; round < 2000; ++round) {
        ShapeLeaves leaves;
        const double scale = draw.decades(-3, 3), third = 0.1 * 3 * scale;   // 0.1 * 3 is not 0.3
        const CsgExpression a = leaves.add(Box{Vec3(-1, -1, -1) * scale, Vec3(0.3 * scale, scale, scale)}), b = leaves.add(Box{Vec3(third, -scale, -scale), Vec3(2, 1, 1) * scale});
        const CsgExpression cut = leaves.add(Plane{Vec3(-3, 0, 0), -third});   // inside: x >= 0.3
        Ray ray;
        ray.origin = Vec3(-8, draw(-0.9, 0.9), draw(-0.9, 0.9)) * scale;
        ray.dir = normalized(Vec3(draw(0.5, 1.5), draw(-0.9, 0.9), draw(-0.9, 0.9)) * scale - ray.origin);
        const double first = surfaces(a, leaves, ray).at(0).t;
        ASSERT_EQ(surfaces(of(CsgOp::merge, {a, b}), leaves, ray).size(), 2u) << "no wall between them";
        ASSERT_EQ(surfaces(of(CsgOp::union_, {a, b}), leaves, ray).size(), 4u) << "a union has both walls";
        ASSERT_TRUE(surfaces(of(CsgOp::intersection, {a, b}), leaves, ray).empty());
        ASSERT_TRUE(surfaces(of(CsgOp::intersection, {a, cut}), leaves, ray).empty());
        ASSERT_EQ(surfaces(of(CsgOp::difference, {a, b}), leaves, ray).size(), 2u);
        ASSERT_EQ(surfaces(of(CsgOp::difference, {a, b}), leaves, ray).at(0).t, first);
        ASSERT_EQ(surfaces(of(CsgOp::difference, {of(CsgOp::union_, {a, b}), cut}), leaves, ray).size(), 2u) << "half of them is cut away, walls and all";
        ASSERT_EQ(surfaces(of(CsgOp::intersection, {b, cut}), leaves, ray).size(), 2u) << "one of two equal faces";
    }
}

/// What POV-Ray shows of two cylinders with a common face (probed by pictures, equal in all pixels): its cylinders do not hold their surfaces. Along the axis of:
///     low  |0   1|          flat  |0 1|, narrower
///     high     |1   2|      box   |0 1|, wider
TEST(Csg, CylindersDoNotHoldTheirSurfaces) {
    ShapeLeaves leaves;
    leaves.without_surface = true;
    const CsgExpression low = leaves.add(Cylinder{Vec3(0), Vec3(0, 1, 0), 1}), high = leaves.add(Cylinder{Vec3(0, 1, 0), Vec3(0, 2, 0), 1});
    const CsgExpression flat = leaves.add(Cone{Vec3(0), Vec3(0, 1, 0), 0.7, 0.5}), box = leaves.add(Box{Vec3(-2, 0, -2), Vec3(2, 1, 2)});
    const auto heights = [&](const CsgExpression& e) {
        const Ray up{Vec3(0.1, -3, 0.2), Vec3(0, 1, 0)};
        std::vector<int> found;
        for (const Hit& hit : surfaces(e, leaves, up)) found.push_back(int(std::lround(hit.t)) - 3);
        return found;
    };
    using Heights = std::vector<int>;
    EXPECT_EQ(heights(of(CsgOp::merge, {low, high})), (Heights{0, 1, 1, 2})) << "a wall, seen from both sides";
    EXPECT_EQ(heights(of(CsgOp::merge, {of(CsgOp::merge, {low, high}), leaves.add(Box{Vec3(-2, 0.4, -2), Vec3(2, 1.6, 2)})})), (Heights{0, 2})) << "the box holds the wall";
    EXPECT_EQ(heights(of(CsgOp::intersection, {low, flat})), Heights{}) << "neither holds the other's caps";
    EXPECT_EQ(heights(of(CsgOp::intersection, {low, box})), (Heights{0, 1})) << "the box holds the caps";
    EXPECT_EQ(heights(of(CsgOp::difference, {low, flat})), (Heights{0, 1})) << "a skin is left where caps coincide";
    EXPECT_EQ(heights(of(CsgOp::difference, {low, high})), (Heights{0, 1}));
    EXPECT_EQ(heights(of(CsgOp::difference, {flat, box})), Heights{}) << "the box takes its faces away, too";
    EXPECT_EQ(heights(of(CsgOp::clip, {low, flat})), Heights{});
    EXPECT_EQ(heights(of(CsgOp::merge, {low, inverse(high)})), (Heights{1, 2})) << "turned inside out, they hold them";
}

TEST(Csg, DeMorgan) {
    test::Draw draw(7);
    int found = 0;
    for (size_t round = 0; round < run_size(2000); ++round) {
        ShapeLeaves leaves;
        const CsgExpression a = random_expression(leaves, draw, 1, true, false), b = random_expression(leaves, draw, 1, true, false);
        const Ray ray = whole_line(test::ray_from(6, draw));
        const auto same = [&](const CsgExpression& x, const CsgExpression& y) {
            const std::vector<double> of_x = distances(surfaces(x, leaves, ray));
            ASSERT_EQ(of_x, distances(surfaces(y, leaves, ray)));
            found += int(of_x.size());
        };
        same(of(CsgOp::union_, {a, b}, true), of(CsgOp::intersection, {inverse(a), inverse(b)}));
        same(of(CsgOp::intersection, {a, b}, true), of(CsgOp::merge, {inverse(a), inverse(b)}));
        same(of(CsgOp::difference, {a, b}), of(CsgOp::intersection, {a, inverse(b)}));
        same(inverse(inverse(a)), a);
    }
    EXPECT_GT(found, 1000 * run_scale());
}

/// An open cylinder has no caps, and is inside what it was: it drills a hole. A disc is a half space.
/// A thousand holes: few of them are near a line, and only those are asked.
TEST(Csg, ALineMeetsFewOfManyParts) {
    test::Draw draw(8);
    for (const CsgOp op : {CsgOp::union_, CsgOp::difference}) {
        ShapeLeaves leaves;
        CsgExpression e = of(op, {leaves.add(Box{Vec3(-10, -1, -10), Vec3(10, 1, 10)})});
        for (int i = 0; i < 1000; ++i) e.parts.push_back(leaves.add(Sphere{Vec3(draw(-10, 10), draw(-1, 1), draw(-10, 10)), 0.1}));
        const CsgTree tree(e);
        leaves.asked = 0;
        for (int i = 0; i < 100; ++i) {
            Ray ray;
            ray.origin = Vec3(draw(-10, 10), 20, draw(-10, 10)), ray.dir = Vec3(0.1, -1, 0.1);
            Hit hit;
            tree.first(ray, leaves, hit);
        }
        EXPECT_LT(leaves.asked, 100 * 6);
    }
}

/// A line through a corner of the sphere's box misses the sphere: the torus around it is not asked, wherever it stands.
TEST(Csg, WhatIsCostlyIsAskedLast) {
    ShapeLeaves leaves;
    const CsgExpression torus = leaves.add(Torus{Vec3(0), 0.7, 0.6}), sphere = leaves.add(Sphere{Vec3(0), 1});
    ASSERT_TRUE(torus.leaf.cost > sphere.leaf.cost);
    Ray ray;
    ray.origin = Vec3(0.9, 0.5, -8), ray.dir = Vec3(0, 0, 1);
    for (const CsgOp op : {CsgOp::intersection, CsgOp::clip})
        for (const bool torus_first : {true, false}) {
            const CsgTree tree(torus_first ? of(op, {torus, sphere}) : of(op, {sphere, torus}));
            leaves.asked = 0;
            std::vector<Hit> hits;
            tree.all(ray, leaves, hits);
            EXPECT_TRUE(hits.empty());
            EXPECT_EQ(leaves.asked, 1);
        }
}

}  // namespace
}  // namespace alidade
