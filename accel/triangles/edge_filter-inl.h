// SPDX-License-Identifier: Apache-2.0
/// The edge filter on vectors, compiled once for each target that a .cpp file of it includes (hwy/foreach_target.h).
#if defined(ALIDADE_EDGE_FILTER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_EDGE_FILTER_INL
#undef ALIDADE_EDGE_FILTER_INL
#else
#define ALIDADE_EDGE_FILTER_INL
#endif

#include "accel/triangles/edge_filter.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// may_hit() of edge_filter.cpp, on as many lanes as `d` has: multiplications, additions and comparisons in the same order.
template <class T, class D> HWY_INLINE HWY_ATTR auto may_hit_lanes(D d, const TriangleBlock<T>& block, uint32_t lane, const FilterRay<T>& ray) {
    using V = hn::Vec<D>;
    using Error = EdgeError<T>;
    const auto all = [&](T value) HWY_ATTR { return hn::Set(d, value); };
    const auto load = [&](int corner, int axis, int origin) HWY_ATTR { return hn::Sub(hn::Load(d, &block.v[3 * corner + axis][lane]), all(ray.origin[origin])); };
    const auto sheared = [&](int corner, int axis, int i, V z) HWY_ATTR { return hn::Sub(load(corner, axis, i), hn::Mul(all(ray.shear[i]), z)); };
    const auto largest = [&](V a, V b, V c) HWY_ATTR { return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c)); };
    const V z0 = load(0, ray.axes.z, 2), z1 = load(1, ray.axes.z, 2), z2 = load(2, ray.axes.z, 2);
    const V x0 = sheared(0, ray.axes.x, 0, z0), x1 = sheared(1, ray.axes.x, 0, z1), x2 = sheared(2, ray.axes.x, 0, z2);
    const V y0 = sheared(0, ray.axes.y, 1, z0), y1 = sheared(1, ray.axes.y, 1, z1), y2 = sheared(2, ray.axes.y, 1, z2);

    const V mx = largest(x0, x1, x2), my = largest(y0, y1, y2), depth = largest(z0, z1, z2);
    const auto corner = [&](int i, V m) HWY_ATTR {
        const V near = hn::Add(all(Error::kOrigin * ray.farthest[i]), hn::Mul(all(Error::kSheared), m));
        return hn::Add(hn::Add(near, hn::Mul(all(Error::kDepth), hn::Mul(all(ray.slope[i]), depth))), all(Error::kQuanta));
    };
    const V dx = corner(0, mx), dy = corner(1, my);
    const V linear = hn::Mul(all(Error::kLinear), hn::Add(hn::Mul(dx, my), hn::Mul(dy, mx)));
    const V error = hn::Add(hn::Add(linear, hn::Mul(all(Error::kSquare), hn::Mul(dx, dy))), all(Error::kQuanta));

    const auto edge = [&](V xa, V ya, V xb, V yb) HWY_ATTR { return hn::Sub(hn::Mul(xa, yb), hn::Mul(ya, xb)); };
    const V u = edge(x1, y1, x2, y2), v = edge(x2, y2, x0, y0), w = edge(x0, y0, x1, y1), below = hn::Neg(error);
    const auto positive = hn::Or(hn::Or(hn::Gt(u, error), hn::Gt(v, error)), hn::Gt(w, error));
    const auto negative = hn::Or(hn::Or(hn::Lt(u, below), hn::Lt(v, below)), hn::Lt(w, below));
    return hn::Not(hn::And(positive, negative));
}

/// Bit i: triangle i of the block may be hit.
template <class T> HWY_INLINE HWY_ATTR uint32_t filter_block(const TriangleBlock<T>& block, const FilterRay<T>& ray) {
    const hn::CappedTag<T, kLanes> d;
    const auto lanes = uint32_t(hn::Lanes(d));
    uint32_t bits = 0;
    for (uint32_t lane = 0; lane < kLanes; lane += lanes) {
        uint8_t stored[8] = {};
        hn::StoreMaskBits(d, may_hit_lanes(d, block, lane, ray), stored);
        bits |= uint32_t(stored[0]) << lane;
    }
    return bits;
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
