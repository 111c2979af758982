// SPDX-License-Identifier: Apache-2.0
#include "stress/instances.h"

namespace alidade {

namespace {

/// A hit's t must lie where the ray is in the bounds, as computed in double (accel/accelerator.h).
double clamped(double t, const Ray& ray, const Bounds& box) {
    double enter = -kInf, leave = kInf;
    for (int a = 0; a < 3; ++a) {
        if (ray.dir[a] == 0) continue;
        const double t0 = (box.min[a] - ray.origin[a]) / ray.dir[a], t1 = (box.max[a] - ray.origin[a]) / ray.dir[a];
        enter = std::max(enter, std::min(t0, t1)), leave = std::min(leave, std::max(t0, t1));
    }
    return std::min(std::max(t, enter), leave);
}

}  // namespace

StressInstances::StressInstances(const Accelerator& mesh, std::span<const Transform> places) : mesh_(mesh) {
    for (const Transform& to_world : places) {
        const auto back = inverse(to_world);
        places_.push_back({to_world, back.value_or(Transform()), back ? to_world.bounds(mesh.bounds()) : Bounds()});
    }
}

bool StressInstances::intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const {
    bool found = false;
    for (const uint32_t id : ids) {
        Ray local = places_[id].to_mesh.ray(ray);
        local.tmax = std::min(ray.tmax, hit.t + 1e-9 * (std::abs(hit.t) + max_abs(ray.origin) / max_abs(ray.dir)));   // more than rounding and the clamp move a t by
        Hit candidate;
        if (!mesh_.intersect(local, candidate, work, id)) continue;
        candidate.t = clamped(candidate.t, ray, places_[id].bounds);
        if (!comes_before(candidate.t, id, candidate.primitive, hit)) continue;
        hit = candidate, found = true;
    }
    return found;
}

bool StressInstances::occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const {
    return std::any_of(ids.begin(), ids.end(), [&](uint32_t id) { return mesh_.occluded(places_[id].to_mesh.ray(ray), work); });
}

void StressInstances::all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const {
    for (const uint32_t id : ids) {
        const size_t first = hits.size();
        mesh_.all_hits(places_[id].to_mesh.ray(ray), hits, work, id);
        for (size_t i = first; i < hits.size(); ++i) hits[i].t = clamped(hits[i].t, ray, places_[id].bounds);
    }
}

}  // namespace alidade
