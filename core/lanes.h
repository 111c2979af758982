// SPDX-License-Identifier: Apache-2.0
/// Vectors in the lanes of one register, where the machine has AVX2. The same operations in the same order, so the same bits as without it.
#pragma once

#include "core/vec.h"

#ifdef __x86_64__
#include <immintrin.h>

namespace alidade {

inline const bool kHasLanes = __builtin_cpu_supports("avx2");

[[gnu::target("avx2"), gnu::always_inline]] inline __m256d lanes_of(const Vec3& v) { return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&v.x)), _mm_load_sd(&v.z), 1); }

/// One instruction for a vector that is not the last in its object: the last lane is what follows it there.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256d lanes_and_next(const Vec3& v) { return _mm256_loadu_pd(&v.x); }

}  // namespace alidade
#endif
