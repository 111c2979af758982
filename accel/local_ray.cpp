// SPDX-License-Identifier: Apache-2.0
#include "accel/local_ray.h"

#include "core/powers_of_two.h"

namespace alidade {

namespace {

/// Does a SlabRay of any precision take a component of the direction as 0?
bool is_flat(const Vec3& dir) {
    const auto flat = [](double d) { return std::abs(d) < kSmallestSlope<float>; };
    return flat(dir.x) || flat(dir.y) || flat(dir.z);
}

/// The largest |t| at which the ray can be in the box: along the largest component of the direction nothing overflows.
double reach_of(const LocalRay& ray, const Bounds& box) {
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
        if (std::abs(ray.dir[a]) > std::abs(ray.dir[axis])) axis = a;
    }
    const double distance = std::max(std::abs(box.min[axis] - ray.origin[axis]), std::abs(box.max[axis] - ray.origin[axis]));
    return padded_up(distance / std::abs(ray.dir[axis]));
}

/// The local interval in which the ray is in the box, padded; empty on a miss.
void clip_to_box(LocalRay& ray, const Bounds& box, double tmin, double tmax) {
    ray.reach = is_flat(ray.dir) ? reach_of(ray, box) : 0;
    ray.slab = SlabRay<double>(ray.origin, ray.dir, ray.reach);
    double near = -std::numeric_limits<double>::max(), far = std::numeric_limits<double>::max();
    ray.slab.clip(box, near, far);
    if (near <= far) {
        ray.tmin = std::max(tmin, padded_down(near)), ray.tmax = std::min(tmax, padded_up(far));
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
    if (move) {
        clip_to_box(local, bounds, -kInf, kInf);
        if (!local.enters_box()) return local;
        if (local.tmin > 0 || local.tmax < 0) {
            local.shift = local.tmin;
            local.origin = quantized(local.origin + local.shift * local.dir);
        }
    }
    clip_to_box(local, bounds, local.lower(ray.tmin), local.upper(ray.tmax));
    return local;
}

}  // namespace alidade
