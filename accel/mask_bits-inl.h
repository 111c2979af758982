// SPDX-License-Identifier: Apache-2.0
/// A mask of lanes as a number, compiled once for each target that a .cpp file of it includes (hwy/foreach_target.h).
#if defined(ALIDADE_MASK_BITS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_MASK_BITS_INL
#undef ALIDADE_MASK_BITS_INL
#else
#define ALIDADE_MASK_BITS_INL
#endif

#include <cstdint>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Bit i: lane i of the mask, of at most eight.
template <class D, class M> HWY_INLINE HWY_ATTR uint32_t mask_bits(D d, M mask) {
    uint8_t stored[8] = {};
    hn::StoreMaskBits(d, mask, stored);
    return stored[0];
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
