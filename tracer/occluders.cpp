// SPDX-License-Identifier: Apache-2.0
#include "tracer/occluders.h"

#include "accel/local_ray.h"
#include "accel/query.h"
#include "accel/shaft.h"
#include "tracer/instance_set.h"

#include <algorithm>

namespace alidade {
namespace {

/// More than these are asked faster through the structure.
constexpr size_t kMostOccluders = 16;

/// Rays to the box leave the plane that they start on, and cannot come back (spawn_ray).
bool leaves_plane(const CompiledScene& scene, uint32_t id, const ShadePoint& point, const Bounds& to) {
    if (id != point.instance || !std::holds_alternative<Plane>(*scene.geometries[scene.instances[id].geometry].source)) return false;
    const Vec3 &n = point.geometric_normal, half = to.extent() * 0.5, way = to.center() - point.position;
    const double height = std::abs(dot(n, way)), reach = dot(glm::abs(n), half);
    return height > reach + 1e-9 * (reach + max_abs(to.center()) + max_abs(point.position));
}

/// Is the box on one side of a surface that goes on for ever?
bool on_one_side(const CompiledScene& scene, uint32_t id, const Bounds& box) {
    const Instance& instance = scene.instances[id];
    const Geometry& geometry = scene.geometries[instance.geometry];
    if (geometry.mesh || geometry.bounds.finite() || !geometry.ops->narrow || geometry.ops->costly) return false;   // a costly search, once a point, gains nothing
    const Bounds local = instance.to_local.bounds(box);
    return geometry.ops->narrow(*geometry.source, false, local).empty() || geometry.ops->narrow(*geometry.source, true, local).empty();
}

}  // namespace

bool Occluders::find(const CompiledScene& scene, const ShadePoint& point, const Bounds& to) {
    const Vec3 moved(3 * point.error);   // spawn_ray moves by 2, the end of a ray as its beginning
    if (!is_finite(point.position) || !is_finite(moved) || !to.finite()) return false;
    const Shaft shaft({point.position - moved, point.position + moved}, {to.min - moved, to.max + moved});
    if (!scene.top->candidates(shaft, kMostOccluders, ids_)) return false;
    std::erase_if(ids_, [&](uint32_t id) {
        if (!(scene.set->mask(id) & kMaskShadow)) return true;
        return !scene.set->is_solid(id) && (leaves_plane(scene, id, point, to) || on_one_side(scene, id, shaft.hull()));
    });
    return true;
}

bool Occluders::occluded(const CompiledScene& scene, const Ray& ray, WorkCounters& work) {
    if (!can_hit(ray, kLargestCoordinate<double>)) return false;
    for (size_t i = 0; i < ids_.size(); ++i) {
        ++work.filtered;
        if (!scene.set->occluded(std::span(&ids_[i], 1), ray, work)) continue;
        std::swap(ids_[0], ids_[i]);
        return true;
    }
    return false;
}

void Occluders::all_hits(const CompiledScene& scene, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const {
    if (!can_hit(ray, kLargestCoordinate<double>)) return;
    const size_t first = hits.size();
    work.filtered += ids_.size();
    scene.set->all_hits(ids_, ray, hits, work);
    put_in_order(hits, first);
}

}  // namespace alidade
