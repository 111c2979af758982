// SPDX-License-Identifier: Apache-2.0
#include "core/transform.h"

#include "core/lanes.h"

#include <cstddef>

namespace alidade {

namespace {

/// The box of the images of a box that is not empty.
Bounds bounds_plainly(const Transform& a, const Bounds& b) {
    const auto& [linear, translation] = a;
    Bounds out{translation, translation};
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double k = linear[column][row];
            if (k == 0) continue;   // 0 * infinity says nothing
            out.min[row] += std::min(k * b.min[column], k * b.max[column]);
            out.max[row] += std::max(k * b.min[column], k * b.max[column]);
        }
    }
    // Six roundings a side at the most; an unbounded side stays unbounded.
    for (int row = 0; row < 3; ++row) {
        double size = std::abs(translation[row]);
        for (int column = 0; column < 3; ++column) {
            if (linear[column][row] != 0) size += std::abs(linear[column][row]) * std::max(std::abs(b.min[column]), std::abs(b.max[column]));
        }
        if (std::isfinite(size)) out.min[row] -= gamma_bound(6) * size, out.max[row] += gamma_bound(6) * size;
    }
    return out;
}

}  // namespace

#ifdef __x86_64__

namespace {

static_assert(offsetof(Bounds, max) == 24, "the last lane of one is written before what follows it");
static_assert(offsetof(Ray, origin) == 0 && offsetof(Ray, dir) == 24 && offsetof(Ray, tmin) == 48, "the last lane of one is written before what follows it");

[[gnu::target("avx2"), gnu::always_inline]] inline __m256d image(const Mat3& linear, const Vec3& v) {
    return lanes_and_next(linear[0]) * _mm256_set1_pd(v.x) + lanes_and_next(linear[1]) * _mm256_set1_pd(v.y) + lanes_of(linear[2]) * _mm256_set1_pd(v.z);
}

[[gnu::target("avx2")]] Ray ray_in_lanes(const Transform& a, const Ray& r) {
    Ray out;
    _mm256_storeu_pd(&out.origin.x, image(a.linear, r.origin) + lanes_of(a.translation));
    _mm256_storeu_pd(&out.dir.x, image(a.linear, r.dir));
    out.tmin = r.tmin, out.tmax = r.tmax, out.time = r.time, out.mask = r.mask;
    return out;
}

/// A row in each lane: the same sums in the same order.
[[gnu::target("avx2")]] Bounds bounds_in_lanes(const Transform& a, const Bounds& b) {
    const __m256d sign = _mm256_set1_pd(-0.0), translation = lanes_of(a.translation);
    __m256d low = translation, high = translation, size = _mm256_andnot_pd(sign, translation);
    for (int column = 0; column < 3; ++column) {
        const __m256d k = lanes_of(a.linear[column]), none = _mm256_cmp_pd(k, _mm256_setzero_pd(), _CMP_EQ_OQ);   // 0 * infinity says nothing
        const double min = b.min[column], max = b.max[column];
        const __m256d p = k * _mm256_set1_pd(min), q = k * _mm256_set1_pd(max);
        low = _mm256_blendv_pd(low + _mm256_min_pd(q, p), low, none), high = _mm256_blendv_pd(high + _mm256_max_pd(q, p), high, none);
        size = _mm256_blendv_pd(size + _mm256_andnot_pd(sign, k) * _mm256_set1_pd(std::max(std::abs(min), std::abs(max))), size, none);
    }
    const __m256d finite = _mm256_cmp_pd(size, _mm256_set1_pd(std::numeric_limits<double>::max()), _CMP_LE_OQ), pad = _mm256_set1_pd(gamma_bound(6)) * size;
    low = _mm256_blendv_pd(low, low - pad, finite), high = _mm256_blendv_pd(high, high + pad, finite);
    Bounds out;
    _mm256_storeu_pd(&out.min.x, low);   // the last lane is written over
    _mm_storeu_pd(&out.max.x, _mm256_castpd256_pd128(high)), _mm_store_sd(&out.max.z, _mm256_extractf128_pd(high, 1));
    return out;
}

}  // namespace

#endif

Bounds Transform::bounds(const Bounds& b) const {
    if (b.empty()) return {};
#ifdef __x86_64__
    if (kHasLanes) return bounds_in_lanes(*this, b);
#endif
    return bounds_plainly(*this, b);
}

Ray Transform::ray(const Ray& r) const {
#ifdef __x86_64__
    if (kHasLanes) return ray_in_lanes(*this, r);
#endif
    Ray out = r;
    out.origin = point(r.origin);
    out.dir = vector(r.dir);
    return out;
}

bool Transform::is_finite() const {
    return alidade::is_finite(linear[0]) && alidade::is_finite(linear[1]) && alidade::is_finite(linear[2]) && alidade::is_finite(translation);
}

double Transform::norm() const {
    const Vec3 columns{length(linear[0]), length(linear[1]), length(linear[2])};
    return length(columns);
}

Transform Transform::rotate(const Vec3& axis, double angle) {
    const double s = std::sin(angle / 2);
    return from_quaternion({s * axis.x, s * axis.y, s * axis.z, std::cos(angle / 2)});
}

Transform Transform::from_quaternion(const Vec4& q) {
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    return {Mat3(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
                 2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
                 2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)),
            Vec3(0)};
}

Transform operator*(const Transform& a, const Transform& b) { return {a.linear * b.linear, a.linear * b.translation + a.translation}; }

namespace {

/// The power of two that brings |m| into [1/2, 1); 1 for 0.
double normalising_scale(double m) { return m > 0 ? std::ldexp(1.0, -std::ilogb(m) - 1) : 1.0; }

}  // namespace

std::optional<Transform> inverse(const Transform& a) {
    if (!a.is_finite()) return std::nullopt;
    Mat3 m = a.linear;
    Vec3 column_scale(1), row_scale(1);
    for (int c = 0; c < 3; ++c) column_scale[c] = normalising_scale(max_abs(m[c])), m[c] *= column_scale[c];
    for (int r = 0; r < 3; ++r) {
        row_scale[r] = normalising_scale(std::max({std::abs(m[0][r]), std::abs(m[1][r]), std::abs(m[2][r])}));
        for (int c = 0; c < 3; ++c) m[c][r] *= row_scale[r];
    }
    const Vec3 rows[3] = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};   // of the adjugate
    const double det = dot(m[0], rows[0]);
    if (!(std::abs(det) > gamma_bound(16))) return std::nullopt;   // |det| <= 1 here: below this it is all rounding
    Transform out;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) out.linear[c][r] = rows[r][c] / det * column_scale[r] * row_scale[c];
    out.translation = -(out.linear * a.translation);
    if (!out.is_finite()) return std::nullopt;
    return out;
}

}  // namespace alidade
