// SPDX-License-Identifier: Apache-2.0
#include "stress/instances.h"

#include "accel/cell_boxes.h"
#include "core/clamp.h"

#include <algorithm>

namespace alidade {

StressInstances::StressInstances(std::vector<const Accelerator*> meshes, const StressScene& scene) : meshes_(std::move(meshes)) {
    std::vector<CellBoxes> cells;
    for (const StressMesh& mesh : scene.meshes) cells.emplace_back(mesh.view());
    places_.reserve(scene.places.size());
    for (const StressPlace& place : scene.places) {
        const auto back = inverse(place.to_world);
        places_.push_back({back.value_or(Transform()), back ? cells[place.mesh].placed(place.to_world, meshes_[place.mesh]->bounds()) : Bounds(), place.mesh});
    }
}

bool StressInstances::intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const {
    bool found = false;
    for (const uint32_t id : ids) {
        Ray local = places_[id].to_mesh.ray(ray);
        if (hit.t < ray.tmax) local.tmax = std::min(ray.tmax, hit.t + instance_slack(ray, hit.t));
        Hit candidate;
        if (!mesh(id).intersect(local, candidate, work, id)) continue;
        candidate.t = clamp_to_bounds(candidate.t, ray, places_[id].bounds);
        if (!comes_before(candidate.t, id, candidate.primitive, hit)) continue;
        hit = candidate, found = true;
    }
    return found;
}

bool StressInstances::occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const {
    return std::any_of(ids.begin(), ids.end(), [&](uint32_t id) { return mesh(id).occluded(places_[id].to_mesh.ray(ray), work); });
}

void StressInstances::all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const {
    for (const uint32_t id : ids) {
        const size_t first = hits.size();
        mesh(id).all_hits(places_[id].to_mesh.ray(ray), hits, work, id);
        for (size_t i = first; i < hits.size(); ++i) hits[i].t = clamp_to_bounds(hits[i].t, ray, places_[id].bounds);
    }
}

}  // namespace alidade
