// SPDX-License-Identifier: Apache-2.0
#include "accel/local_ray.h"

#include "accel/isa_table.h"
#include "core/powers_of_two.h"

#include <bit>

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/local_ray.cpp"
#include "hwy/foreach_target.h"
#include "accel/local_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
HWY_ATTR bool vector_local_ray(const Ray& ray, const RayBounds& bounds, RayEntry entry, LocalRay& local) { return local_ray_lanes(ray, bounds, entry, std::numeric_limits<double>::infinity(), local); }
#endif

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

/// max_abs, without a branch.
double largest(const Vec3& v) { return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); }
double least(const Vec3& v) { return std::min(std::min(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); }

/// Does the ray begin near the bounds?
bool is_near(const Vec3& origin, const RayBounds& bounds, double far) { return largest((origin + origin) - Vec3(bounds.doubled_middle[0], bounds.doubled_middle[1], bounds.doubled_middle[2])) <= far * bounds.doubled_size; }

/// The interval of the ray: the caller's, or clipped to the bounds; if it moves, it then begins there.
void set_interval(const Ray& ray, const RayBounds& bounds, RayEntry entry, bool flat, LocalRay& local) {
    double near = -std::numeric_limits<double>::max(), far = std::numeric_limits<double>::max(), near_blur = 0, far_blur = 0;
    const SlabRay<double> slab = slab_of<double>(local);
    for (int a = 0; a < 3; ++a) {
        const double enter = slab.enter_slab(a, bounds.low[a], bounds.high[a]), leave = slab.leave_slab(a, bounds.low[a], bounds.high[a]);
        const double blur = (4 * kUnitRoundoff<double> * std::abs(local.origin[a]) + kOriginPad<double>) * std::abs(slab.inverse(a));
        if (enter >= near) near_blur = enter > near ? blur : std::max(near_blur, blur), near = enter;
        if (leave <= far) far_blur = leave < far ? blur : std::max(far_blur, blur), far = leave;
    }
    const bool begins_near = is_near(local.origin, bounds, entry.far);
    if (begins_near && !entry.clips && ray.tmin >= 0 && local.is_plain()) return local.leave_unclipped(ray, near, far);
    local.set_interval(near, far);
    if (!begins_near && entry.moves && local.enters_box() && (local.tmin > 0 || local.tmax < 0)) {
        local.move(near_blur, far_blur);
        local.origin = quantized(local.origin + local.shift * local.dir);
        if (flat) local.reach = reach_of(local, bounds.bounds());
    }
    if (local.enters_box()) local.narrow(ray);
}

/// Any ray, on any machine.
void plain_local_ray(const Ray& ray, const RayBounds& bounds, RayEntry entry, LocalRay& local) {
    const int exponent = std::clamp(exponent_of(largest(ray.dir)), -1000, 1000);
    local.to_local = power_of_two(exponent), local.to_caller = power_of_two(-exponent);
    local.origin = quantized(ray.origin), local.dir = quantized(ray.dir * local.to_caller), local.inverse = Vec3(1.0) / local.dir;
    local.origin_lane = 0, local.dir_lane = local.inverse_lane = 1;
    const bool flat = least(local.dir) < kSmallestSlope<float>;
    if (flat) local.reach = reach_of(local, bounds.bounds());
    set_interval(ray, bounds, entry, flat, local);
}

using VectorLocalRay = bool (*)(const Ray&, const RayBounds&, RayEntry, LocalRay&);

constexpr IsaRow<VectorLocalRay> kVectors[] = {{Isa::scalar, nullptr}, ALIDADE_AVX2_ROW(vector_local_ray) ALIDADE_AVX512_ROW(vector_local_ray)};

}  // namespace

RayBounds::RayBounds(const Bounds& bounds) : doubled_size(bounds.empty() ? -1 : 2 * max_component(bounds.extent())) {
    constexpr double kMost = std::numeric_limits<double>::max();
    for (int a = 0; a < 3; ++a) low[a] = bounds.min[a], high[a] = bounds.max[a], doubled_middle[a] = low[a] + high[a];
    low[3] = -kMost, high[3] = kMost, doubled_middle[3] = 0;
}

LocalRay local_ray(const Ray& ray, const RayBounds& bounds, RayEntry entry, Isa isa) {
    static const VectorLocalRay best = chosen(kVectors, Isa::best);
    LocalRay local;
    if (bounds.empty()) return local;
    const VectorLocalRay vector = isa == Isa::best ? best : chosen(kVectors, isa);
    if (!vector || !vector(ray, bounds, entry, local)) plain_local_ray(ray, bounds, entry, local);
    return local;
}

}  // namespace alidade

#endif
