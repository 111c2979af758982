// SPDX-License-Identifier: Apache-2.0
/// The sums of lattice_noise.cpp, term by term in the same order, for four numbers at a time. No instruction rounds once where those round twice.
#include "eval/noise/lattice_cell.h"
#include "eval/noise/lattice_noise.h"

#include <cstring>

#ifdef __x86_64__

#include <immintrin.h>

namespace alidade::avx2 {

namespace {

using Lanes [[gnu::vector_size(32)]] = double;

// Vectors go in and out by reference: what is passed by value depends on the instructions of the caller.
[[gnu::always_inline]] inline void load(const void* from, Lanes& to) { std::memcpy(&to, from, sizeof to); }

/// Values and gradients of the three vector noises at a lattice point: a lane for each.
struct alignas(128) VectorCorner {
    double value[4], gx[4], gy[4], gz[4];
};

constexpr std::array<VectorCorner, 256> kVectorCorners = [] {
    std::array<VectorCorner, 256> all{};
    for (size_t m = 0; m < all.size(); ++m)
        for (size_t c = 0; c < 3; ++c) {
            const LatticeCorner& of = kLatticeCorners[m + 4 * c];
            all[m].value[c] = of.value, all[m].gx[c] = of.gx, all[m].gy[c] = of.gy, all[m].gz[c] = of.gz;
        }
    return all;
}();

[[gnu::always_inline]] inline void at(unsigned hash, double x, double y, double z, Lanes& out) {
    const VectorCorner& corner = kVectorCorners[hash];
    Lanes value, gx, gy, gz;
    load(corner.value, value), load(corner.gx, gx), load(corner.gy, gy), load(corner.gz, gz);
    out = value + gx * x + gy * y + gz * z;
}

[[gnu::always_inline]] inline Vec3 vector_sum(const Vec3& p) {
    const LatticeCell cell(p);
    const double sx = smooth_step(cell.x.offset), sy = smooth_step(cell.y.offset), sz = smooth_step(cell.z.offset);
    const double x0 = cell.x.offset, y0 = cell.y.offset, z0 = cell.z.offset;
    Lanes rows[4];
    for (int i = 0; i < 4; ++i) {
        const double dy = i & 1 ? y0 - 1 : y0, dz = i & 2 ? z0 - 1 : z0;
        Lanes low, high;
        at(cell.hash[2 * i], x0, dy, dz, low);
        at(cell.hash[2 * i + 1], x0 - 1, dy, dz, high);
        rows[i] = low * (1 - sx) + high * sx;
    }
    const Lanes sum = (rows[0] * (1 - sy) + rows[1] * sy) * (1 - sz) + (rows[2] * (1 - sy) + rows[3] * sy) * sz;
    return {sum[0], sum[1], sum[2]};
}

/// Four corners at the point, of those that lie on one side along x: a lane for each.
[[gnu::always_inline]] inline void side(const unsigned* hash, double x, const Lanes& dy, const Lanes& dz, Lanes& out) {
    Lanes a, b, c, d;   // a corner each: value, gx, gy, gz
    load(&kLatticeCorners[hash[0]], a), load(&kLatticeCorners[hash[2]], b), load(&kLatticeCorners[hash[4]], c), load(&kLatticeCorners[hash[6]], d);
    const Lanes ab02 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Lanes cd02 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    const Lanes value = __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5), gx = __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5);
    const Lanes gy = __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7), gz = __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7);
    out = value + gx * x + gy * dy + gz * dz;
}

/// A coordinate of four points, as LatticePlace has it.
struct LatticePlaces {
    __m256d offset;
    alignas(16) unsigned index[4];

    [[gnu::target("avx2")]] explicit LatticePlaces(const __m256d& x) {
        const __m256i negative = _mm256_cmpgt_epi64(_mm256_setzero_si256(), _mm256_castpd_si256(x));
        const __m128i cell = _mm256_cvttpd_epi32(x - _mm256_and_pd(_mm256_castsi256_pd(negative), _mm256_set1_pd(1 - 1e-10)));
        offset = x - _mm256_cvtepi32_pd(cell);
        _mm_store_si128(reinterpret_cast<__m128i*>(index), _mm_and_si128(_mm_add_epi32(cell, _mm_set1_epi32(10000)), _mm_set1_epi32(4095)));
    }
};

/// One corner of four cells, at the point of each: a lane for each.
[[gnu::target("avx2")]] inline void corner_of_four(const unsigned (*hash)[8], int corner, const __m256d& x, const __m256d& y, const __m256d& z, __m256d& out) {
    const auto at_point = [&](int i) { return &kLatticeCorners[hash[i][corner]].value; };
    const __m256d a = _mm256_load_pd(at_point(0)), b = _mm256_load_pd(at_point(1)), c = _mm256_load_pd(at_point(2)), d = _mm256_load_pd(at_point(3));
    const __m256d ab02 = _mm256_unpacklo_pd(a, b), ab13 = _mm256_unpackhi_pd(a, b), cd02 = _mm256_unpacklo_pd(c, d), cd13 = _mm256_unpackhi_pd(c, d);
    const __m256d value = _mm256_permute2f128_pd(ab02, cd02, 0x20), gx = _mm256_permute2f128_pd(ab13, cd13, 0x20);
    const __m256d gy = _mm256_permute2f128_pd(ab02, cd02, 0x31), gz = _mm256_permute2f128_pd(ab13, cd13, 0x31);
    out = value + gx * x + gy * y + gz * z;
}

/// smooth_step() of four numbers.
[[gnu::target("avx2")]] inline void smooth_steps(const __m256d& t, __m256d& out) { out = t * t * (_mm256_set1_pd(3) - _mm256_set1_pd(2) * t); }

}  // namespace

[[gnu::target("avx2")]] void four(const Vec3* p, double* values) {
    const LatticePlaces x(_mm256_setr_pd(p[0].x, p[1].x, p[2].x, p[3].x)), y(_mm256_setr_pd(p[0].y, p[1].y, p[2].y, p[3].y)), z(_mm256_setr_pd(p[0].z, p[1].z, p[2].z, p[3].z));
    unsigned hash[4][8];
    for (int i = 0; i < 4; ++i) hash_corners(x.index[i], y.index[i], z.index[i], hash[i]);
    const __m256d one = _mm256_set1_pd(1), x1 = x.offset - one, y1 = y.offset - one, z1 = z.offset - one;
    __m256d sx, sy, sz, rows[4];
    smooth_steps(x.offset, sx), smooth_steps(y.offset, sy), smooth_steps(z.offset, sz);
    for (int i = 0; i < 4; ++i) {
        const __m256d &dy = i & 1 ? y1 : y.offset, &dz = i & 2 ? z1 : z.offset;
        __m256d low, high;
        corner_of_four(hash, 2 * i, x.offset, dy, dz, low);
        corner_of_four(hash, 2 * i + 1, x1, dy, dz, high);
        rows[i] = low * (one - sx) + high * sx;
    }
    _mm256_storeu_pd(values, (rows[0] * (one - sy) + rows[1] * sy) * (one - sz) + (rows[2] * (one - sy) + rows[3] * sy) * sz);
}

[[gnu::target("avx2")]] double lattice_noise(const Vec3& p) {
    const LatticeCell cell(p);
    const double sx = smooth_step(cell.x.offset), sy = smooth_step(cell.y.offset), sz = smooth_step(cell.z.offset);
    const double x0 = cell.x.offset, y0 = cell.y.offset, z0 = cell.z.offset;
    const Lanes above = {0, 1, 0, 1}, behind = {0, 0, 1, 1};
    const Lanes dy = y0 - above, dz = z0 - behind;
    Lanes low, high;
    side(cell.hash, x0, dy, dz, low);
    side(cell.hash + 1, x0 - 1, dy, dz, high);
    const Lanes rows = low * (1 - sx) + high * sx;
    return (rows[0] * (1 - sy) + rows[1] * sy) * (1 - sz) + (rows[2] * (1 - sy) + rows[3] * sy) * sz;
}

[[gnu::target("avx2")]] Vec3 vector_lattice_noise(const Vec3& p) { return vector_sum(p); }

[[gnu::target("avx2")]] Vec3 octaves(const Vec3& p, const Octaves& octaves) {
    Vec3 sum = vector_sum(p);
    double weight = octaves.omega, frequency = octaves.lambda;
    for (int i = 1; i < octaves.count; ++i, weight *= octaves.omega, frequency *= octaves.lambda) sum += weight * vector_sum(p * frequency);
    return sum;
}

}  // namespace alidade::avx2

#endif
