// SPDX-License-Identifier: Apache-2.0
/// What is behind a ray, on vectors, compiled once for each target that a .cpp file of it includes (hwy/foreach_target.h).
#if defined(ALIDADE_BEHIND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_BEHIND_INL
#undef ALIDADE_BEHIND_INL
#else
#define ALIDADE_BEHIND_INL
#endif

#include "accel/mask_bits-inl.h"
#include "accel/triangles/behind.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V> HWY_INLINE HWY_ATTR V largest_of(V a, V b, V c) { return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c)); }

/// is_behind(): the same operations in the same order.
template <class T, class D, class V> HWY_INLINE HWY_ATTR uint32_t behind_lanes(D d, V depths, V sum, T blur, V m) {
    using Error = BehindError<T>;
    const V square = hn::Mul(m, m), cube = hn::Mul(hn::Mul(hn::Set(d, T(8)), m), square);
    const V bound = hn::Add(hn::Add(hn::Mul(square, hn::Set(d, blur)), hn::Mul(cube, hn::Set(d, Error::kCubes))), hn::Set(d, Error::kTiny));
    return mask_bits(d, hn::Lt(hn::Xor(depths, hn::And(sum, hn::SignBit(d))), hn::Neg(bound)));
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
