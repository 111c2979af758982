// SPDX-License-Identifier: Apache-2.0
/// Shapes as leaves of set operations, random expressions of them, and what such an expression is at a point: the oracle.
#pragma once

#include "eval/csg.h"
#include "eval/shapes/shape_ops.h"
#include "tests/eval/shape_samples.h"

#include <algorithm>

namespace alidade::test {

/// Shapes as leaves, by their index; counts how many are asked.
class ShapeLeaves final : public CsgLeaves {
  public:
    std::vector<ShapeGeometry> shapes;
    bool solid_alone = true;       ///< what random_expression takes
    bool without_surface = false;  ///< are cylinders and cones without their surfaces?
    mutable int asked = 0;

    CsgExpression add(ShapeGeometry shape) {
        shapes.push_back(std::move(shape));
        return leaf(uint32_t(shapes.size() - 1));
    }
    CsgExpression leaf(uint32_t id) const {
        const ShapeOps& ops = *find_shape(shapes[id]);
        CsgExpression e;
        e.leaf = {id, csg_inside(&ops, shapes[id]), ops.bounds(shapes[id]), csg_cost(ops), csg_endless(shapes[id]), without_surface && csg_without_surface(shapes[id])};
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

inline CsgExpression of(CsgOp op, std::vector<CsgExpression> parts, bool inverse = false) {
    CsgExpression e;
    e.op = op, e.parts = std::move(parts), e.inverse = inverse;
    return e;
}

inline CsgExpression inverse(CsgExpression e) {
    e.inverse = !e.inverse;
    return e;
}

/// What a set operation is, at a point: the oracle.
inline bool inside(const ShapeLeaves& leaves, const CsgExpression& e, const Vec3& p) {
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
inline CsgExpression random_expression(ShapeLeaves& leaves, Draw& draw, int levels, bool outline, bool endless) {
    if (levels == 0 || draw.below(4) == 0) {
        ShapeGeometry shape;
        const ShapeOps* ops;
        do {
            ops = &shapes()[draw.below(uint32_t(shapes().size()))];
            shape = sample_shape(*ops, 1, draw);
        } while (ops->sheet || (leaves.solid_alone && !ops->solid(shape)) || (endless && !ops->narrow && draw.below(8)));
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

inline Ray whole_line(Ray ray) {
    ray.tmin = -kInf;
    return ray;
}

inline std::vector<Hit> surfaces(const CsgExpression& e, const ShapeLeaves& leaves, const Ray& ray) {
    std::vector<Hit> out;
    CsgTree(e, leaves.narrow()).all(ray, leaves, out);
    return out;
}

inline std::vector<double> distances(const std::vector<Hit>& hits) {
    std::vector<double> out;
    for (const Hit& hit : hits) out.push_back(hit.t);
    return out;
}

/// All crossings with all leaves, in order; empty if two of them are too near to each other to have a point between them.
inline std::vector<double> cuts(const ShapeLeaves& leaves, const Ray& ray) {
    std::vector<CsgCrossing> crossings;
    for (uint32_t id = 0; id < leaves.shapes.size(); ++id) leaves.crossings(id, ray, crossings);
    std::vector<double> out;
    for (const CsgCrossing& c : crossings) out.push_back(c.hit.t);
    std::sort(out.begin(), out.end());
    for (size_t i = 1; i < out.size(); ++i)
        if ((out[i] - out[i - 1]) * length(ray.dir) < 1e-6) return {};
    return out;
}

}  // namespace alidade::test
