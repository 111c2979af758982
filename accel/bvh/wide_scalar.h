// SPDX-License-Identifier: Apache-2.0
/// The box tests and filters of Intersect::exact without vectors.
#pragma once

#include "accel/bvh/wide.h"

namespace alidade {

/// One box after the other, the oracle of the vector versions.
template <class R, int kUnits = kTriangleUnits> class ScalarBoxes {
  public:
    ScalarBoxes(const LocalRay& ray, double size) : ray_(ray, size, false) {}

    R limit(double t) const { return ray_.limit(t); }

    uint32_t enter(const auto& node, R limit, R* entries) const {
        uint32_t bits = 0;
        for (uint32_t i = 0; i < kWide; ++i) {
            entries[i] = ray_.enter({{node.plane(0, i), node.plane(2, i), node.plane(4, i)}, {node.plane(1, i), node.plane(3, i), node.plane(5, i)}}, limit);
            if (entries[i] <= limit) bits |= 1u << i;
        }
        return bits & node.places();
    }

  private:
    WideRay<R, kUnits> ray_;
};

/// Without vectors.
struct ScalarEntry {
    template <class Leaf> static bool enter(const Ray& ray, const RayBounds& bounds, LocalRay& local) {
        if (!can_hit(ray, kLargestCoordinate<typename Leaf::Real>)) return false;
        if (!bounds.empty()) local = local_ray(ray, bounds, kWideEntry<Leaf>, Isa::scalar);
        return true;
    }
};

template <class R> struct ScalarMachine : ScalarEntry {
    using Boxes = ScalarBoxes<R>;
    static decltype(auto) block(const auto& leaf, uint32_t number, uint32_t lanes) { return leaf.blocks().block(number, lanes); }
    static uint32_t filter(const auto& leaf, const TriangleBlock<R>& block, const FilterRay<R>& ray, bool near) { return leaf.filter(block, ray, near); }
};

template <class Node, int kUnits = kTriangleUnits> uint32_t enter_boxes_scalar(const Node& node, const LocalRay& ray, double size, typename Node::Real limit, typename Node::Real* entries) {
    return ScalarBoxes<typename Node::Real, kUnits>(ray, size).enter(node, limit, entries);
}

}  // namespace alidade
