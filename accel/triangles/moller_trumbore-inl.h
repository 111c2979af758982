// SPDX-License-Identifier: Apache-2.0
/// The fast test on vectors, compiled once for each target that a .cpp file of it includes (hwy/foreach_target.h).
#if defined(ALIDADE_MOLLER_TRUMBORE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_MOLLER_TRUMBORE_INL
#undef ALIDADE_MOLLER_TRUMBORE_INL
#else
#define ALIDADE_MOLLER_TRUMBORE_INL
#endif

#include "accel/mask_bits-inl.h"
#include "accel/triangles/moller_trumbore.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V> struct Lanes3 {
    V x, y, z;
};
template <class V> HWY_INLINE HWY_ATTR Lanes3<V> difference(const Lanes3<V>& a, const Lanes3<V>& b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
template <class V> HWY_INLINE HWY_ATTR V product(const Lanes3<V>& a, const Lanes3<V>& b) { return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z)); }
template <class V> HWY_INLINE HWY_ATTR Lanes3<V> cross_product(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)), hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// test_lane() of moller_trumbore.cpp, on as many lanes as `d` has: the same operations in the same order. Bits from `lane` on.
template <class T, class D> HWY_INLINE HWY_ATTR uint32_t fast_lanes(D d, const TriangleBlock<T>& block, uint32_t lane, const FastRay<T>& ray) {
    using V = hn::Vec<D>;
    const auto corner = [&](int c) HWY_ATTR { return Lanes3<V>{hn::Load(d, &block.v[3 * c][lane]), hn::Load(d, &block.v[3 * c + 1][lane]), hn::Load(d, &block.v[3 * c + 2][lane])}; };
    const auto all = [&](const T* p) HWY_ATTR { return Lanes3<V>{hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])}; };
    const Lanes3<V> a = corner(0), e = difference(corner(1), a), f = difference(corner(2), a), dir = all(ray.dir);
    const Lanes3<V> p = cross_product(dir, f), s = difference(all(ray.origin), a), q = cross_product(s, e);
    const V whole = hn::Div(hn::Set(d, T(1)), product(e, p));
    const V u = hn::Mul(product(s, p), whole), v = hn::Mul(product(dir, q), whole), t = hn::Mul(product(f, q), whole);
    const V zero = hn::Zero(d);
    const auto inside = hn::And(hn::And(hn::Ge(u, zero), hn::Ge(v, zero)), hn::Le(hn::Add(u, v), hn::Set(d, T(1))));
    const auto hit = hn::And(inside, hn::And(hn::Ge(t, hn::Set(d, ray.from)), hn::Le(t, hn::Set(d, ray.until))));
    const uint32_t bits = mask_bits(d, hit);
    if (bits) hn::Store(t, d, ray.t + lane), hn::Store(u, d, ray.u + lane), hn::Store(v, d, ray.v + lane);
    return bits << lane;
}

template <class T> HWY_INLINE HWY_ATTR uint32_t fast_block(const TriangleBlock<T>& block, const FastRay<T>& ray, bool) {
    const hn::CappedTag<T, kLanes> d;
    const auto lanes = uint32_t(hn::Lanes(d));
    uint32_t bits = 0;
    for (uint32_t lane = 0; lane < kLanes; lane += lanes) bits |= fast_lanes(d, block, lane, ray);
    return bits;
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
