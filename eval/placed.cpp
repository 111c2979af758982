// SPDX-License-Identifier: Apache-2.0
#include "eval/placed.h"

#include "core/lanes.h"

namespace alidade {

/// Source   T. Ogita, S. M. Rump and S. Oishi, "Accurate Sum and Dot Product", SIAM Journal on Scientific Computing 26(6), 2005: algorithm 5.3 (Dot2). The roundings of all products and sums are known, and
///          are themselves added up in plain numbers.
Vec3 corrected_plainly(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near) {
    Vec3 left;
    for (int row = 0; row < 3; ++row) {
        Twice sum = Twice::sum(world[row], -shift[row]);
        double lost = sum.low;
        for (int column = 0; column < 3; ++column) {
            const Twice moved = Twice::product(near[column], to_world[column][row]);
            sum = Twice::sum(sum.high, -moved.high);
            lost += sum.low - moved.low;
        }
        left[row] = sum.high + lost;
    }
    return near + to_local * left;
}

#ifdef __x86_64__

/// The same sums in the same order, a lane for each component.
namespace avx2 {
namespace {

/// a - b, and what rounding has taken from it.
[[gnu::target("avx2,fma"), gnu::always_inline]] inline __m256d difference(__m256d a, __m256d b, __m256d& taken) {
    const __m256d s = a - b, of_b = s - a;
    taken = (a - (s - of_b)) - (b + of_b);
    return s;
}

[[gnu::target("avx2,fma")]] Vec3 corrected(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near) {
    const __m256d n[] = {_mm256_set1_pd(near.x), _mm256_set1_pd(near.y), _mm256_set1_pd(near.z)};
    const __m256d columns[] = {lanes_and_next(to_world[0]), lanes_and_next(to_world[1]), lanes_of(to_world[2])};
    __m256d lost, taken, sum = difference(lanes_of(world), lanes_of(shift), lost);
    for (int i = 0; i < 3; ++i) {
        const __m256d moved = n[i] * columns[i];
        sum = difference(sum, moved, taken);
        lost += taken - _mm256_fmsub_pd(n[i], columns[i], moved);
    }
    const __m256d left = sum + lost;
    const __m256d off = lanes_and_next(to_local[0]) * _mm256_permute4x64_pd(left, 0x00) + lanes_and_next(to_local[1]) * _mm256_permute4x64_pd(left, 0x55) + lanes_of(to_local[2]) * _mm256_permute4x64_pd(left, 0xaa);
    const __m256d out = lanes_of(near) + off;
    return {out[0], out[1], out[2]};
}

const bool kHasFusedLanes = kHasLanes && __builtin_cpu_supports("fma");

}  // namespace
}  // namespace avx2

#endif

Vec3 corrected(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near) {
#ifdef __x86_64__
    if (avx2::kHasFusedLanes) return avx2::corrected(to_world, to_local, shift, world, near);
#endif
    return corrected_plainly(to_world, to_local, shift, world, near);
}

}  // namespace alidade
