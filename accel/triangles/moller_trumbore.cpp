// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/moller_trumbore.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/triangles/moller_trumbore.cpp"
#include "hwy/foreach_target.h"
#include "accel/triangles/moller_trumbore-inl.h"

#if HWY_ONCE

namespace alidade {

namespace {

template <class T> Vec3T<T> product_of(const Vec3T<T>& a, const Vec3T<T>& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
template <class T> T sum_of_products(const Vec3T<T>& a, const Vec3T<T>& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

/// One triangle, the oracle of the vector versions: the same operations give the same bits.
template <class T> bool test_lane(const TriangleBlock<T>& block, uint32_t lane, const FastRay<T>& ray) {
    using V = Vec3T<T>;
    const auto corner = [&](int c) { return V(block.v[3 * c][lane], block.v[3 * c + 1][lane], block.v[3 * c + 2][lane]); };
    const V a = corner(0), e = corner(1) - a, f = corner(2) - a, dir(ray.dir[0], ray.dir[1], ray.dir[2]), origin(ray.origin[0], ray.origin[1], ray.origin[2]);
    const V p = product_of(dir, f), s = origin - a, q = product_of(s, e);
    const T whole = 1 / sum_of_products(e, p);
    const T u = sum_of_products(s, p) * whole, v = sum_of_products(dir, q) * whole, t = sum_of_products(f, q) * whole;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && t >= ray.from && t <= ray.until)) return false;   // nor where there is a NaN
    ray.t[lane] = t, ray.u[lane] = u, ray.v[lane] = v;
    return true;
}

template <class T> uint32_t fast_scalar(const TriangleBlock<T>& block, const FastRay<T>& ray, bool) {
    uint32_t bits = 0;
    for (uint32_t lane = 0; lane < kLanes; ++lane) bits |= uint32_t(test_lane(block, lane, ray)) << lane;
    return bits;
}

template <class T> constexpr IsaRow<FastTest<T>> kTests[] = {ALIDADE_ISA_ROWS(fast_scalar<T>, fast_block<T>)};

}  // namespace

template <> FastTest<float> fast_test<float>(Isa isa) { return chosen(kTests<float>, isa); }
template <> FastTest<double> fast_test<double>(Isa isa) { return chosen(kTests<double>, isa); }

}  // namespace alidade

#endif
