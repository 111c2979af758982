// SPDX-License-Identifier: Apache-2.0
/// Set operations on a line, against what is inside at every point of it.
#include "eval/csg.h"
#include "tests/eval/shape_samples.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace alidade {
namespace {

/// Shapes as leaves, by their index; counts how many are asked.
class ShapeLeaves final : public CsgLeaves {
  public:
    std::vector<ShapeGeometry> shapes;
    mutable int asked = 0;

    CsgExpression add(ShapeGeometry shape) {
        shapes.push_back(std::move(shape));
        return leaf(uint32_t(shapes.size() - 1));
    }
    CsgExpression leaf(uint32_t id) const {
        const ShapeOps& ops = *find_shape(shapes[id]);
        CsgExpression e;
        e.leaf = {id, ops.solid(shapes[id]) ? CsgInside::by_crossings : CsgInside::at_points, ops.bounds(shapes[id]), csg_cost(ops)};
        return e;
    }
    bool crossings(uint32_t id, const Ray& ray, std::vector<CsgCrossing>& out) const override {
        ++asked;
        const ShapeOps& ops = *find_shape(shapes[id]);
        const Crossings found = ops.crossings(shapes[id], ray);
        for (int i = 0; i < found.count; ++i) {
            Hit hit;
            hit.t = found.at[i].t, hit.instance = id, hit.primitive = 0, hit.part = found.at[i].part;
            out.push_back({hit, 0});
        }
        return begins_inside(ops, shapes[id], ray, found);
    }
    CsgNarrow narrow() const {
        return [this](uint32_t id, bool inverted, const Bounds& box) {
            const ShapeOps& ops = *find_shape(shapes[id]);
            return ops.narrow ? ops.narrow(shapes[id], inverted, box) : box;
        };
    }
    bool inside(uint32_t id, const Vec3& p) const override { return find_shape(shapes[id])->inside(shapes[id], p); }
    Sharpness sharpness(const Ray& ray, const Hit& hit) const override {
        const ShapeGeometry& shape = shapes[hit.instance];
        return {find_shape(shape)->error(shape, ray, hit.t, hit.part).along_normal, std::abs(dot(find_shape(shape)->surface(shape, ray.at(hit.t), hit.part).normal, normalized(ray.dir)))};
    }
};

CsgExpression of(CsgOp op, std::vector<CsgExpression> parts, bool inverse = false) {
    CsgExpression e;
    e.op = op, e.parts = std::move(parts), e.inverse = inverse;
    return e;
}

CsgExpression inverse(CsgExpression e) {
    e.inverse = !e.inverse;
    return e;
}

/// What a set operation is, at a point: the oracle.
bool inside(const ShapeLeaves& leaves, const CsgExpression& e, const Vec3& p) {
    std::vector<bool> parts;
    for (const CsgExpression& part : e.parts) parts.push_back(inside(leaves, part, p));
    const bool any = std::count(parts.begin(), parts.end(), true) > 0, all = std::count(parts.begin(), parts.end(), false) == 0;
    const bool first = !parts.empty() && parts[0];
    const bool others = std::count(parts.begin(), parts.end(), true) > int(first), clips = std::count(parts.begin(), parts.end(), false) == int(!first);
    switch (e.op) {
        case CsgOp::leaf: return leaves.inside(e.leaf.id, p) != e.inverse;
        case CsgOp::union_:
        case CsgOp::merge: return any != e.inverse;
        case CsgOp::intersection: return all != e.inverse;
        case CsgOp::difference: return (first && !others) != e.inverse;
        case CsgOp::clip: return (first != e.inverse) && clips;
    }
    return false;
}

/// `endless`: of planes, quadrics and a few spheres, which bound each other.
CsgExpression random_expression(ShapeLeaves& leaves, test::Draw& draw, int levels, bool outline, bool endless) {
    if (levels == 0 || draw.below(4) == 0) {
        ShapeGeometry shape;
        const ShapeOps* ops;
        do {
            ops = &shapes()[draw.below(uint32_t(shapes().size()))];
            shape = test::sample_shape(*ops, 1, draw);
        } while (!ops->solid(shape) || (endless && !ops->narrow && draw.below(8)));
        CsgExpression e = leaves.add(shape);
        e.inverse = draw.below(5) == 0;
        return e;
    }
    static constexpr CsgOp kOps[] = {CsgOp::merge, CsgOp::intersection, CsgOp::difference, CsgOp::union_, CsgOp::clip};
    CsgExpression e = of(kOps[draw.below(outline ? 3 : 5)], {}, draw.below(5) == 0);
    const uint32_t count = 2 + draw.below(3);
    for (uint32_t i = 0; i < count; ++i) e.parts.push_back(random_expression(leaves, draw, levels - 1, outline, endless));
    return e;
}

Ray whole_line(Ray ray) {
    ray.tmin = -kInf;
    return ray;
}

std::vector<Hit> surfaces(const CsgExpression& e, const ShapeLeaves& leaves, const Ray& ray) {
    std::vector<Hit> out;
    CsgTree(e, leaves.narrow()).all(ray, leaves, out);
    return out;
}

/// All crossings with all leaves, in order; empty if two of them are too near to each other to have a point between them.
std::vector<double> cuts(const ShapeLeaves& leaves, const Ray& ray) {
    std::vector<CsgCrossing> crossings;
    for (uint32_t id = 0; id < leaves.shapes.size(); ++id) leaves.crossings(id, ray, crossings);
    std::vector<double> out;
    for (const CsgCrossing& c : crossings) out.push_back(c.hit.t);
    std::sort(out.begin(), out.end());
    for (size_t i = 1; i < out.size(); ++i)
        if ((out[i] - out[i - 1]) * length(ray.dir) < 1e-6) return {};
    return out;
}

/// Between two neighbouring crossings nothing changes; at one of them either the whole does, and that is a surface of it, or it does not: then there is a
/// surface only where a union shows its inner ones.
TEST(Csg, SurfacesAreWhereTheWholeChanges) {
    test::Draw draw(1);
    int changes = 0, inner = 0;
    for (int round = 0; round < 3000; ++round) {
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
    EXPECT_GT(changes, 2000);
    EXPECT_GT(inner, 100) << "unions must be among them";
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
    for (int round = 0; round < 3000; ++round) {
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
    EXPECT_GT(found, 500);
}

/// What the boxes leave out is not missed.
TEST(Csg, BoundsHoldAllSurfaces) {
    test::Draw draw(3);
    int hits = 0;
    for (int round = 0; round < 3000; ++round) {
        ShapeLeaves leaves;
        const CsgExpression e = random_expression(leaves, draw, 1 + round % 3, false, round % 2 == 0);
        const Ray ray = whole_line(test::ray_from(6, draw));
        Bounds box = CsgTree(e, leaves.narrow()).bounds();
        box.min -= 1e-9, box.max += 1e-9;
        for (const Hit& hit : surfaces(e, leaves, ray)) {
            ++hits;
            ASSERT_TRUE(box.contains(ray.at(hit.t)));
        }
    }
    EXPECT_GT(hits, 1000);
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
    for (int round = 0; round < 8000; ++round) {
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
    EXPECT_GT(found, 1000);
    EXPECT_GT(known, 1000);
    EXPECT_GT(inner, 100);
    EXPECT_GT(whole, 100);
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

std::vector<double> distances(const std::vector<Hit>& hits) {
    std::vector<double> out;
    for (const Hit& hit : hits) out.push_back(hit.t);
    return out;
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

TEST(Csg, DeMorgan) {
    test::Draw draw(7);
    int found = 0;
    for (int round = 0; round < 2000; ++round) {
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
    EXPECT_GT(found, 1000);
}

/// An open cylinder has no caps, and is inside what it was: it drills a hole. A disc is a half space.
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
