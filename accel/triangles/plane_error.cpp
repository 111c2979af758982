// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/decide.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/triangles/plane_error.cpp"
#include "hwy/foreach_target.h"
#include "accel/local_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

/// The sums of three lanes of each, the first of them first.
HWY_INLINE HWY_ATTR RayLanes::V sums(RayLanes::V a, RayLanes::V b, RayLanes::V c, RayLanes::V e) {
    const RayLanes::D d;
    const auto ab = hn::InterleaveLower(d, a, b), ce = hn::InterleaveLower(d, c, e), ab_y = hn::InterleaveUpper(d, a, b), ce_y = hn::InterleaveUpper(d, c, e);   // x and z, y and the rest
    return hn::Add(hn::Add(hn::ConcatLowerLower(d, ce, ab), hn::ConcatLowerLower(d, ce_y, ab_y)), hn::ConcatUpperUpper(d, ce, ab));
}

/// What plain_error() below sums up, three components at once: the same operations in the same order.
HWY_ATTR void vector_sums(const Ray& ray, double t, const Corners& corners, double (&of)[4]) {
    using L = RayLanes;
    using V = L::V;
    const L::D d;
    const auto y_z_x = [](V v) HWY_ATTR { return V{_mm256_permute4x64_pd(v.raw, 0xc9)}; };
    const auto z_x_y = [](V v) HWY_ATTR { return V{_mm256_permute4x64_pd(v.raw, 0xd2)}; };
    const V origin = L::three(ray.origin, 0), travel = hn::Mul(hn::Set(d, t), L::three(ray.dir, 0)), corner = L::three(corners[0], 0);
    const V e = hn::Sub(L::three(corners[1], 0), corner), f = hn::Sub(L::three(corners[2], 0), corner), q = hn::Sub(hn::Add(origin, travel), corner);
    const V a = hn::Mul(y_z_x(e), z_x_y(f)), b = hn::Mul(y_z_x(f), z_x_y(e)), normal = hn::Sub(a, b), area = hn::Add(hn::Abs(a), hn::Abs(b)), size = hn::Abs(q);
    const V rounding = hn::Mul(hn::Set(d, gamma_bound(3)), hn::Add(hn::Add(hn::Abs(origin), hn::Abs(travel)), size));
    const V wrong = hn::Add(hn::Mul(hn::Mul(hn::Set(d, gamma_bound(8)), area), size), hn::Mul(hn::Abs(normal), rounding));
    hn::StoreU(sums(hn::Mul(normal, normal), hn::Mul(normal, q), wrong, hn::Add(size, rounding)), d, of);
}

#endif

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

/// How far a point is from the plane through a corner: the product of the vector there and the normal, its error, and the normal's length; no more than `far`, since the plane is not farther than the corner, also for needles
/// whose normal is all rounding.
ErrorBound distance_bound(double product, double wrong, double length, double far) {
    const double bound = (std::abs(product) + wrong) / length * (1 + gamma_bound(16));
    return {bound < far ? bound : far};
}

ErrorBound plain_error(const Ray& ray, double t, const Corners& corners) {
    const Vec3 e = corners[1] - corners[0], f = corners[2] - corners[0], q = ray.at(t) - corners[0];
    const Vec3 normal = cross(e, f), area = {std::abs(e.y * f.z) + std::abs(e.z * f.y), std::abs(e.z * f.x) + std::abs(e.x * f.z), std::abs(e.x * f.y) + std::abs(e.y * f.x)};
    const Vec3 travel = t * ray.dir;
    const double size = length(normal);
    double wrong = 0, far = 0;
    for (int i = 0; i < 3; ++i) {
        const double rounding = gamma_bound(3) * (std::abs(ray.origin[i]) + std::abs(travel[i]) + std::abs(q[i]));   // of at(), however it is evaluated, and of q
        wrong += gamma_bound(8) * area[i] * std::abs(q[i]) + std::abs(normal[i]) * rounding;
        far += std::abs(q[i]) + rounding;
    }
    return distance_bound(dot(normal, q), wrong, size, far);
}

/// Of the normal's square, its product with the vector from a corner to the point, that one's error, and how far the corner is.
using VectorSums = void (*)(const Ray&, double, const Corners&, double (&)[4]);
constexpr IsaRow<VectorSums> kVectors[] = {{Isa::scalar, nullptr}, ALIDADE_AVX2_ROW(vector_sums) ALIDADE_AVX512_ROW(vector_sums)};

}  // namespace

ErrorBound plane_error(const Ray& ray, double t, const Corners& corners, Isa isa) {
    static const VectorSums best = chosen(kVectors, Isa::best);
    const VectorSums vector = isa == Isa::best ? best : chosen(kVectors, isa);
    if (!vector) return plain_error(ray, t, corners);
    double of[4];
    vector(ray, t, corners, of);
    return is_plain_square(of[0]) ? distance_bound(of[1], of[2], std::sqrt(of[0]), of[3]) : plain_error(ray, t, corners);
}

}  // namespace alidade

#endif
