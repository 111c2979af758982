// SPDX-License-Identifier: Apache-2.0
/// The box test for the two children of a node at once.
#pragma once

#include "accel/slab.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace alidade {

/// Two calls of SlabRay::enter().
template <class R> class SlabPair {
  public:
    explicit SlabPair(const SlabRay<R>& slab) : slab_(slab) {}
    void enter(const BoundsT<R>& a, const BoundsT<R>& b, R start, R limit, R (&entries)[2]) const { entries[0] = slab_.enter(a, start, limit), entries[1] = slab_.enter(b, start, limit); }

  private:
    const SlabRay<R>& slab_;
};

#ifdef __SSE2__

/// The same bits, a lane for each box. The instructions for the greater and the lesser give their second operand where one is NaN, as SlabRay::narrow() does.
template <> class SlabPair<double> {
  public:
    explicit SlabPair(const SlabRay<double>& slab) {
        for (int a = 0; a < 3; ++a) {
            near_origin_[a] = _mm_set1_pd(slab.near_origin(a)), far_origin_[a] = _mm_set1_pd(slab.far_origin(a)), inverse_[a] = _mm_set1_pd(slab.inverse(a));
            near_[a] = slab.negative(a) ? a + 3 : a, far_[a] = slab.negative(a) ? a : a + 3;
        }
    }
    [[gnu::always_inline]] inline void enter(const Bounds& a, const Bounds& b, double start, double limit, double (&entries)[2]) const {
        const double *of_a = &a.min.x, *of_b = &b.min.x;   // a box is six numbers, one after the other
        const __m128d limits = _mm_set1_pd(limit);
        __m128d near = _mm_set1_pd(start), far = limits;
        for (int i = 0; i < 3; ++i) {
            near = _mm_max_pd(_mm_mul_pd(_mm_sub_pd(_mm_set_pd(of_b[near_[i]], of_a[near_[i]]), near_origin_[i]), inverse_[i]), near);
            far = _mm_min_pd(_mm_mul_pd(_mm_sub_pd(_mm_set_pd(of_b[far_[i]], of_a[far_[i]]), far_origin_[i]), inverse_[i]), far);
        }
        far = _mm_add_pd(far, _mm_mul_pd(_mm_andnot_pd(_mm_set1_pd(-0.0), far), _mm_set1_pd(kSlabPad * kUnitRoundoff<double>)));
        const __m128d met = _mm_and_pd(_mm_cmple_pd(near, far), _mm_cmple_pd(near, limits));
        _mm_storeu_pd(entries, _mm_or_pd(_mm_and_pd(met, near), _mm_andnot_pd(met, _mm_set1_pd(std::numeric_limits<double>::infinity()))));
    }

  private:
    __m128d near_origin_[3], far_origin_[3], inverse_[3];
    int near_[3], far_[3];
};

#endif

}  // namespace alidade
