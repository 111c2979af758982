// SPDX-License-Identifier: Apache-2.0
#include "core/clamp.h"

#include "core/lanes.h"

#include <cmath>

namespace alidade {

/// Divided by one instruction: what this function takes is mostly the time of its divisions.
using Pair [[gnu::vector_size(16)]] = double;

LineInterval inside_bounds_plainly(const Ray& ray, const Bounds& bounds) {
    LineInterval inside;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.dir[axis];
        if (d == 0) {   // 0 / 0 says nothing: parallel to the slab, the line is in it as a whole or not at all; its faces belong to it
            if (!(bounds.min[axis] <= o && o <= bounds.max[axis])) return {kInf, -kInf};
            continue;
        }
        const Pair ends = (Pair{bounds.min[axis], bounds.max[axis]} - o) / d;
        if (std::isnan(ends[0]) || std::isnan(ends[1])) return {kInf, -kInf};
        inside.entry = std::max(inside.entry, std::min(ends[0], ends[1]));
        inside.exit = std::min(inside.exit, std::max(ends[0], ends[1]));
    }
    return inside;
}

#ifdef __x86_64__

namespace {

/// All axes at once, unless something is said of one of them that is no number.
[[gnu::target("avx2")]] LineInterval inside_bounds_in_lanes(const Ray& ray, const Bounds& bounds) {
    const __m256d o = lanes_and_next(ray.origin), d = lanes_and_next(ray.dir);
    const __m256d a = (lanes_and_next(bounds.min) - o) / d, b = (lanes_of(bounds.max) - o) / d;
    const __m256d odd = _mm256_or_pd(_mm256_cmp_pd(d, _mm256_setzero_pd(), _CMP_EQ_OQ), _mm256_cmp_pd(a, b, _CMP_UNORD_Q));
    if (_mm256_movemask_pd(odd) & 7) return inside_bounds_plainly(ray, bounds);
    const __m256d entries = _mm256_min_pd(b, a), exits = _mm256_max_pd(b, a);
    const __m128d entry = _mm256_castpd256_pd128(entries), exit = _mm256_castpd256_pd128(exits);
    const __m128d last_entry = _mm_max_sd(_mm256_extractf128_pd(entries, 1), _mm_max_sd(_mm_unpackhi_pd(entry, entry), entry));
    const __m128d first_exit = _mm_min_sd(_mm256_extractf128_pd(exits, 1), _mm_min_sd(_mm_unpackhi_pd(exit, exit), exit));
    return {_mm_cvtsd_f64(last_entry), _mm_cvtsd_f64(first_exit)};
}

}  // namespace

#endif

LineInterval inside_bounds(const Ray& ray, const Bounds& bounds) {
#ifdef __x86_64__
    if (kHasLanes) return inside_bounds_in_lanes(ray, bounds);
#endif
    return inside_bounds_plainly(ray, bounds);
}

double clamp_to_bounds(double t, const Ray& ray, const Bounds& bounds) {
    if (bounds.min == Vec3(-kInf) && bounds.max == Vec3(kInf)) return t;
    const LineInterval inside = inside_bounds(ray, bounds);
    return inside.empty() ? t : std::clamp(t, inside.entry, inside.exit);
}

}  // namespace alidade
