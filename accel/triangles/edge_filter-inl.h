// SPDX-License-Identifier: Apache-2.0
/// The edge filter on vectors, compiled once for each target that a .cpp file of it includes (hwy/foreach_target.h).
#if defined(ALIDADE_EDGE_FILTER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_EDGE_FILTER_INL
#undef ALIDADE_EDGE_FILTER_INL
#else
#define ALIDADE_EDGE_FILTER_INL
#endif

#include "accel/triangles/behind-inl.h"
#include "accel/triangles/edge_filter.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// may_hit() of edge_filter.cpp, on as many lanes as `d` has: the same operations in the same order, but for the products that are fused with a sum where the machine does so.
/// Sums with kQuanta are not, which is all that `blur` is where a ray begins at the origin: processors take a hundred cycles for a fused sum with a denormal number, but none for a plain one.
template <class T, class D> HWY_INLINE HWY_ATTR uint32_t filter_lanes(D d, const TriangleBlock<T>& block, uint32_t lane, const FilterRay<T>& ray, bool near) {
    using V = hn::Vec<D>;
    using Error = EdgeError<T>;
    const auto all = [&](T value) HWY_ATTR { return hn::Set(d, value); };
    const T *const at_x = block.v[ray.axes.x] + lane, *const at_y = block.v[ray.axes.y] + lane, *const at_z = block.v[ray.axes.z] + lane;
    const V ox = all(ray.origin[0]), oy = all(ray.origin[1]), oz = all(ray.origin[2]), shear_x = all(ray.shear[0]), shear_y = all(ray.shear[1]);
    const auto depth_of = [&](size_t corner) HWY_ATTR { return hn::Sub(oz, hn::Load(d, at_z + 3 * kLanes * corner)); };
    const auto sheared = [&](V o, V shear, const T* at, size_t corner, V z) HWY_ATTR { return hn::NegMulAdd(shear, z, hn::Sub(o, hn::Load(d, at + 3 * kLanes * corner))); };
    const V z0 = depth_of(0), z1 = depth_of(1), z2 = depth_of(2);
    const V x0 = sheared(ox, shear_x, at_x, 0, z0), x1 = sheared(ox, shear_x, at_x, 1, z1), x2 = sheared(ox, shear_x, at_x, 2, z2);
    const V y0 = sheared(oy, shear_y, at_y, 0, z0), y1 = sheared(oy, shear_y, at_y, 1, z1), y2 = sheared(oy, shear_y, at_y, 2, z2);

    const V m = hn::Max(largest_of(x0, x1, x2), largest_of(y0, y1, y2)), depth = largest_of(z0, z1, z2);
    const V blur = hn::Add(all(ray.origin_blur), hn::Mul(all(ray.depth_blur), depth)), off = hn::Add(blur, hn::Mul(all(Error::kSheared), m));
    const V squares = hn::Add(hn::Mul(all(Error::kSquare), hn::Mul(off, off)), all(Error::kQuanta));
    const V error = hn::MulAdd(hn::Mul(all(Error::kBoth), m), blur, hn::MulAdd(all(Error::kBothSheared), hn::Mul(m, m), squares));

    const auto edge = [&](V xa, V ya, V xb, V yb) HWY_ATTR { return hn::MulSub(xa, yb, hn::Mul(ya, xb)); };
    const V u = edge(x1, y1, x2, y2), v = edge(x2, y2, x0, y0), w = edge(x0, y0, x1, y1);
    const uint32_t bits = mask_bits(d, hn::Not(hn::And(hn::Gt(hn::Max(u, hn::Max(v, w)), error), hn::Lt(hn::Min(u, hn::Min(v, w)), hn::Neg(error)))));
    if (!near) return bits;
    const V depths = hn::Mul(all(ray.ahead), hn::MulAdd(w, z2, hn::MulAdd(v, z1, hn::Mul(u, z0))));
    return bits & ~behind_lanes(d, depths, hn::Add(hn::Add(u, v), w), ray.behind_blur, hn::Max(m, depth));
}

template <class T> HWY_INLINE HWY_ATTR uint32_t filter_block(const TriangleBlock<T>& block, const FilterRay<T>& ray, bool near) {
    const hn::CappedTag<T, kLanes> d;
    const auto lanes = uint32_t(hn::Lanes(d));
    uint32_t bits = 0;
    for (uint32_t lane = 0; lane < kLanes; lane += lanes) bits |= filter_lanes(d, block, lane, ray, near) << lane;
    return bits;
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
