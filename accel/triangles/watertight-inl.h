// SPDX-License-Identifier: Apache-2.0
/// The watertight test on vectors, compiled once for each target that a .cpp file of it includes (hwy/foreach_target.h).
#if defined(ALIDADE_WATERTIGHT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_WATERTIGHT_INL
#undef ALIDADE_WATERTIGHT_INL
#else
#define ALIDADE_WATERTIGHT_INL
#endif

#include "accel/triangles/behind-inl.h"
#include "accel/triangles/watertight.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// test_lane() of watertight.cpp, on as many lanes as `d` has: the same operations in the same order. Bits from `lane` on.
template <class T, class D> HWY_INLINE HWY_ATTR uint32_t watertight_lanes(D d, const TriangleBlock<T>& block, uint32_t lane, const WatertightRay<T>& ray, bool near) {
    using V = hn::Vec<D>;
    const auto load = [&](int corner, int axis, int origin) HWY_ATTR { return hn::Sub(hn::Load(d, &block.v[3 * corner + axis][lane]), hn::Set(d, ray.origin[origin])); };
    const auto sheared = [&](int corner, int axis, int i, V z) HWY_ATTR { return hn::Sub(load(corner, axis, i), hn::Mul(hn::Set(d, ray.shear[i]), z)); };
    const V z0 = load(0, ray.axes.z, 2), z1 = load(1, ray.axes.z, 2), z2 = load(2, ray.axes.z, 2);
    const V x0 = sheared(0, ray.axes.x, 0, z0), x1 = sheared(1, ray.axes.x, 0, z1), x2 = sheared(2, ray.axes.x, 0, z2);
    const V y0 = sheared(0, ray.axes.y, 1, z0), y1 = sheared(1, ray.axes.y, 1, z1), y2 = sheared(2, ray.axes.y, 1, z2);
    const auto edge = [&](V xa, V ya, V xb, V yb) HWY_ATTR { return hn::Sub(hn::Mul(xa, yb), hn::Mul(ya, xb)); };
    const V u = edge(x1, y1, x2, y2), v = edge(x2, y2, x0, y0), w = edge(x0, y0, x1, y1), zero = hn::Zero(d);
    const auto positive = hn::Or(hn::Or(hn::Gt(u, zero), hn::Gt(v, zero)), hn::Gt(w, zero));
    const auto negative = hn::Or(hn::Or(hn::Lt(u, zero), hn::Lt(v, zero)), hn::Lt(w, zero));
    const V sum = hn::Add(hn::Add(u, v), w);
    uint32_t bits = mask_bits(d, hn::Not(hn::And(positive, negative)));
    if (near) {
        const V depths = hn::Mul(hn::Set(d, ray.ahead), hn::Add(hn::Add(hn::Mul(u, z0), hn::Mul(v, z1)), hn::Mul(w, z2)));
        bits &= ~behind_lanes(d, depths, sum, ray.behind_blur, hn::Max(hn::Max(largest_of(x0, x1, x2), largest_of(y0, y1, y2)), largest_of(z0, z1, z2)));
    }
    if (bits) ray.unsure |= (bits & ~mask_bits(d, hn::Gt(hn::Abs(sum), zero))) << lane;   // not so of NaN
    return bits << lane;
}

template <class T> HWY_INLINE HWY_ATTR uint32_t watertight_block(const TriangleBlock<T>& block, const WatertightRay<T>& ray, bool near) {
    const hn::CappedTag<T, kLanes> d;
    const auto lanes = uint32_t(hn::Lanes(d));
    uint32_t bits = 0;
    ray.unsure = 0;
    for (uint32_t lane = 0; lane < kLanes; lane += lanes) bits |= watertight_lanes(d, block, lane, ray, near);
    return bits;
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
