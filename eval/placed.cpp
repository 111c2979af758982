// SPDX-License-Identifier: Apache-2.0
#include "eval/placed.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace alidade {

Vec3 corrected_plainly(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near) {
    TwiceVec rest = TwiceVec::difference(world, shift);
    for (int column = 0; column < 3; ++column) rest = rest.moved(Twice(-near[column]), TwiceVec(to_world[column]));
    return near + to_local * Vec3(rest.v[0].value(), rest.v[1].value(), rest.v[2].value());
}

#ifdef __x86_64__

/// The same sums in the same order, a lane for each component.
namespace avx2 {
namespace {

using Lanes [[gnu::vector_size(32)]] = double;

[[gnu::target("avx2,fma"), gnu::always_inline]] inline void load(const Vec3& v, Lanes& to) { to = Lanes{v.x, v.y, v.z, 0}; }

struct TwiceLanes {
    Lanes high, low;

    [[gnu::target("avx2,fma"), gnu::always_inline]] inline void sum(const Lanes& a, const Lanes& b) {
        const Lanes s = a + b, of_b = s - a;
        low = (a - (s - of_b)) + (b - of_b), high = s;
    }
    [[gnu::target("avx2,fma"), gnu::always_inline]] inline void product(const Lanes& a, const Lanes& b) {
        high = a * b;
        low = _mm256_fmsub_pd(a, b, high);
    }
    [[gnu::target("avx2,fma"), gnu::always_inline]] inline void add(const TwiceLanes& b) {
        TwiceLanes first, second;
        first.sum(high, b.high), second.sum(low, b.low);
        sum(first.high, first.low + second.high);
        sum(high, low + second.low);
    }
};

[[gnu::target("avx2,fma")]] Vec3 corrected(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near) {
    Lanes a, b, column;
    TwiceLanes rest, moved;
    load(world, a), load(-shift, b);
    rest.sum(a, b);
    for (int i = 0; i < 3; ++i) {
        load(Vec3(-near[i]), a), load(to_world[i], column);
        moved.product(a, column);
        rest.add(moved);
    }
    const Lanes left = rest.high + rest.low;
    return near + to_local * Vec3(left[0], left[1], left[2]);
}

}  // namespace
}  // namespace avx2

#endif

Vec3 corrected(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near) {
#ifdef __x86_64__
    static const bool has_lanes = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (has_lanes) return avx2::corrected(to_world, to_local, shift, world, near);
#endif
    return corrected_plainly(to_world, to_local, shift, world, near);
}

}  // namespace alidade
