// SPDX-License-Identifier: Apache-2.0
/// The box tests of Intersect::robust and fast: nothing is padded but the ray's origin, once a ray, or nothing at all.
#pragma once

#include "accel/bvh/wide_scalar.h"

namespace alidade {

/// The ray's origin as planes that it enters (`near`) or leaves are compared with it. Watertight: all roundings are in its pad and in the boxes, so that ends of slabs need none. Fast: rounded, no more.
template <class R, TriangleTest test> R lean_origin(const SlabRay<R>& slab, const LocalRay& ray, int axis, bool near) {
    if constexpr (test == TriangleTest::fast) return R(0.5) * (slab.near_origin(axis) + slab.far_origin(axis));
    const R pad = watertight_origin_pad<R>(ray), outward = slab.negative(axis) == near ? -pad : pad;
    return (near ? slab.near_origin(axis) : slab.far_origin(axis)) + outward;
}

/// One box after the other, the oracle of the vector versions.
template <class R, TriangleTest test> class LeanBoxes {
  public:
    LeanBoxes(const LocalRay& ray, double) : slab_(slab_of<R>(ray)), start_(slab_.start(ray.tmin)) {
        for (int a = 0; a < 3; ++a) near_origin_[a] = lean_origin<R, test>(slab_, ray, a, true), far_origin_[a] = lean_origin<R, test>(slab_, ray, a, false);
    }

    /// Entries are counted from where the ray begins, so that none is negative: rounding that difference keeps the order.
    R limit(double t) const { return slab_.limit(t) - start_; }

    uint32_t enter(const auto& node, R limit, R* entries) const {
        uint32_t bits = 0;
        for (uint32_t i = 0; i < kWide; ++i) {
            R near = start_, far = std::numeric_limits<R>::max();
            for (int a = 0; a < 3; ++a) {
                const bool negative = slab_.negative(a);
                const R enter = (node.plane(uint32_t(2 * a + negative), i) - near_origin_[a]) * slab_.inverse(a), leave = (node.plane(uint32_t(2 * a + !negative), i) - far_origin_[a]) * slab_.inverse(a);
                SlabRay<R>::narrow(enter, leave, near, far);
            }
            entries[i] = near - start_;
            if (near <= far && entries[i] <= limit) bits |= 1u << i;
        }
        return bits & node.places();
    }

  private:
    SlabRay<R> slab_;
    R start_, near_origin_[3], far_origin_[3];
};

template <class R, TriangleTest test> struct LeanMachine : ScalarEntry {
    using Boxes = LeanBoxes<R, test>;
    static decltype(auto) block(const auto& leaf, uint32_t number, uint32_t lanes) { return leaf.blocks().block(number, lanes); }
    static uint32_t filter(const auto& leaf, const TriangleBlock<R>& block, const auto& ray, bool near) { return leaf.filter(block, ray, near); }
};

}  // namespace alidade
