// SPDX-License-Identifier: Apache-2.0
#include "accel/local_ray.h"

#include "accel/isa_table.h"
#include "core/powers_of_two.h"

#include <bit>

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/local_ray.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3   // four doubles at once

namespace hn = hwy::HWY_NAMESPACE;
using Four = hn::FixedTag<double, 4>;   // x, y, z, and a lane that decides nothing
using V = hn::Vec<Four>;
constexpr uint64_t kExponent = 0x7ffull << 52, kExponentOfOne = 1023ull << 52;   // of the bits of a double

HWY_INLINE HWY_ATTR V first_three(V v, double last) { return hn::IfThenElse(hn::FirstN(Four(), 3), v, hn::Set(Four(), last)); }
HWY_INLINE HWY_ATTR double greatest(V v) { return hn::GetLane(hn::MaxOfLanes(Four(), v)); }
/// One by one: a ray was written so just before, and a vector that reaches over several writes would wait for all of them.
HWY_INLINE HWY_ATTR V three(const Vec3& v, double last) { return V{_mm256_setr_pd(v.x, v.y, v.z, last)}; }

HWY_INLINE HWY_ATTR V quantized_lanes(V v) {
    const Four d;
    return hn::IfThenElse(hn::Lt(hn::Abs(v), hn::Set(d, kQuantizedBelow)), hn::Sub(hn::Add(v, hn::Set(d, kQuantumShift)), hn::Set(d, kQuantumShift)), v);
}

/// As plain_local_ray() below, the same bits by a shorter way: slabs are in the caller's t until powers of two are known. False, and nothing done, for rays that are
/// along an axis, or very long or short.
HWY_ATTR bool vector_local_ray(const Ray& ray, const Bounds& bounds, bool move, LocalRay& local) {
    const Four d;
    const hn::RebindToUnsigned<Four> bits;
    const V given = three(ray.dir, 0), inverse = hn::Div(hn::Set(d, 1), first_three(given, 1));
    const auto exponent = hn::And(hn::BitCast(bits, hn::MaxOfLanes(d, hn::Abs(given))), hn::Set(bits, kExponent));   // of the largest component, in all lanes
    const double to_local = hn::GetLane(hn::BitCast(d, exponent));
    if (!(to_local >= 0x1p-300 && to_local <= 0x1p300)) return false;
    const V scale = hn::BitCast(d, hn::Sub(hn::Set(bits, 2 * kExponentOfOne), exponent)), dir = first_three(hn::Mul(given, scale), 1);
    if (!hn::AllTrue(d, hn::Ge(hn::Abs(dir), hn::Set(d, kSmallestSlope<float>)))) return false;
    const double to_caller = hn::GetLane(scale);

    alignas(32) static constexpr int64_t kFromZ[4] = {1, 2, 3, 3};   // a box is six numbers, one after the other
    constexpr double kMost = std::numeric_limits<double>::max();
    const V low = first_three(hn::LoadU(d, &bounds.min.x), -kMost);
    const V high = first_three(hn::TableLookupLanes(hn::LoadU(d, &bounds.min.z), hn::SetTableIndices(d, kFromZ)), kMost);
    V origin = quantized_lanes(three(ray.origin, 0));
    const V e = hn::Add(hn::Mul(hn::Abs(origin), hn::Set(d, 4 * kUnitRoundoff<double>)), hn::Set(d, kOriginPad<double>));
    const V a = hn::Mul(hn::Sub(low, hn::Add(origin, e)), inverse), b = hn::Mul(hn::Sub(high, hn::Sub(origin, e)), inverse);
    const V enter = hn::Min(a, b), leave = hn::Max(a, b), near = hn::MaxOfLanes(d, enter), far = hn::MinOfLanes(d, leave);
    local.to_local = to_local, local.to_caller = to_caller;
    local.set_interval(hn::GetLane(near) * to_local, hn::GetLane(far) * to_local);
    if (move && local.enters_box() && (local.tmin > 0 || local.tmax < 0)) {
        const V blur = hn::Abs(hn::Mul(e, inverse));
        local.move(greatest(hn::IfThenElseZero(hn::Eq(enter, near), blur)) * to_local, greatest(hn::IfThenElseZero(hn::Eq(leave, far), blur)) * to_local);
        origin = quantized_lanes(hn::Add(origin, hn::Mul(hn::Set(d, local.shift), dir)));
    }
    hn::Store(origin, d, &local.origin.x), hn::Store(dir, d, &local.dir.x), hn::Store(hn::Mul(inverse, hn::Set(d, to_local)), d, &local.inverse.x);
    return true;
}

#endif

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

/// max_abs, without a branch.
double largest(const Vec3& v) { return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); }
double least(const Vec3& v) { return std::min(std::min(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); }

/// Any ray, on any machine.
void plain_local_ray(const Ray& ray, const Bounds& bounds, bool move, LocalRay& local) {
    const int exponent = std::clamp(exponent_of(largest(ray.dir)), -1000, 1000);
    local.to_local = power_of_two(exponent), local.to_caller = power_of_two(-exponent);
    local.origin = quantized(ray.origin), local.dir = quantized(ray.dir * local.to_caller), local.inverse = Vec3(1.0) / local.dir;
    local.origin_lane = 0, local.dir_lane = local.inverse_lane = 1;
    const bool flat = least(local.dir) < kSmallestSlope<float>;
    if (flat) local.reach = reach_of(local, bounds);
    double near = -std::numeric_limits<double>::max(), far = std::numeric_limits<double>::max(), near_blur = 0, far_blur = 0;
    const SlabRay<double> slab = slab_of<double>(local);
    for (int a = 0; a < 3; ++a) {
        const double enter = slab.enter_slab(a, bounds.min[a], bounds.max[a]), leave = slab.leave_slab(a, bounds.min[a], bounds.max[a]);
        const double blur = (4 * kUnitRoundoff<double> * std::abs(local.origin[a]) + kOriginPad<double>) * std::abs(slab.inverse(a));
        if (enter >= near) near_blur = enter > near ? blur : std::max(near_blur, blur), near = enter;
        if (leave <= far) far_blur = leave < far ? blur : std::max(far_blur, blur), far = leave;
    }
    local.set_interval(near, far);
    if (move && local.enters_box() && (local.tmin > 0 || local.tmax < 0)) {
        local.move(near_blur, far_blur);
        local.origin = quantized(local.origin + local.shift * local.dir);
        if (flat) local.reach = reach_of(local, bounds);
    }
}

using VectorLocalRay = bool (*)(const Ray&, const Bounds&, bool, LocalRay&);

constexpr IsaRow<VectorLocalRay> kVectors[] = {{Isa::scalar, nullptr}, ALIDADE_AVX2_ROW(vector_local_ray) ALIDADE_AVX512_ROW(vector_local_ray)};

}  // namespace

LocalRay local_ray(const Ray& ray, const Bounds& bounds, bool move, Isa isa) {
    static const VectorLocalRay best = chosen(kVectors, Isa::best);
    LocalRay local;
    if (bounds.empty()) return local;
    const VectorLocalRay vector = isa == Isa::best ? best : chosen(kVectors, isa);
    if (!vector || !vector(ray, bounds, move, local)) plain_local_ray(ray, bounds, move, local);
    if (local.enters_box()) local.tmin = std::max(local.tmin, local.lower(ray.tmin)), local.tmax = std::min(local.tmax, local.upper(ray.tmax));
    return local;
}

}  // namespace alidade

#endif
