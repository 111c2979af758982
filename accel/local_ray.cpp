// SPDX-License-Identifier: Apache-2.0
#include "accel/local_ray.h"

#include "core/next_up.h"
#include "core/powers_of_two.h"

namespace alidade {

bool can_hit(const Ray& ray, double largest) {
    return is_finite(ray.origin) && max_abs(ray.origin) <= largest && is_finite(ray.dir) && max_abs(ray.dir) > 0 && ray.tmin <= ray.tmax;
}

namespace {

/// A number above x, the next one but for 0: processors take a hundred cycles for a product with a denormal number, and most rays begin at 0. What is
/// given away is far below kOriginPad.
double above(double x) { return x == 0 ? 0x1p-600 : next_up(x); }

}  // namespace

double LocalRay::upper(double caller) const { return padded_up((above(caller) - shift * to_caller) * to_local, kHitPad); }

double LocalRay::lower(double caller) const { return padded_down((-above(-caller) - shift * to_caller) * to_local, kHitPad); }

namespace {

/// Not less than any |t| at which the ray is in the box: it is not along the largest component of the direction, which is at least 1.
double reach_of(const LocalRay& ray, const Bounds& box) {
    return padded_up(std::max(max_abs(box.min - ray.origin), max_abs(box.max - ray.origin)));
}

/// The local interval in which the ray is in the box, padded; empty on a miss.
void clip_to_box(LocalRay& ray, const Bounds& box) {
    ray.reach = reach_of(ray, box);
    const SlabRay<double>& slab = ray.slab.emplace(ray.origin, ray.dir, ray.reach);
    double near = -std::numeric_limits<double>::max(), far = std::numeric_limits<double>::max();
    slab.clip(box, near, far);
    if (near <= far) {
        ray.tmin = padded_down(near), ray.tmax = padded_up(far);
    } else {
        ray.tmin = 0, ray.tmax = -1;
    }
}

}  // namespace

LocalRay local_ray(const Ray& ray, const Bounds& bounds, bool move) {
    LocalRay local;
    if (bounds.empty()) return local;
    const int exponent = std::clamp(exponent_of(max_abs(ray.dir)), -1000, 1000);
    local.to_local = power_of_two(exponent), local.to_caller = power_of_two(-exponent);
    local.origin = quantized(ray.origin), local.dir = quantized(ray.dir * local.to_caller);
    clip_to_box(local, bounds);
    if (!local.enters_box()) return local;
    if (move && (local.tmin > 0 || local.tmax < 0)) {
        local.shift = local.tmin;
        local.origin = quantized(local.origin + local.shift * local.dir);
        clip_to_box(local, bounds);
        if (!local.enters_box()) return local;
    }
    local.tmin = std::max(local.tmin, local.lower(ray.tmin)), local.tmax = std::min(local.tmax, local.upper(ray.tmax));
    return local;
}

}  // namespace alidade
