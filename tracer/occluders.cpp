// SPDX-License-Identifier: Apache-2.0
#include "tracer/occluders.h"

#include "accel/local_ray.h"
#include "accel/query.h"
#include "tracer/instance_set.h"
#include "tracer/shaft_sides.h"

#include <algorithm>

namespace alidade {
namespace {

/// More than these are asked faster through the structure.
constexpr size_t kMostOccluders = 16;

/// Is all that shadow rays from the point meet so far from their start that it cannot be one place with the crossing of what they start on? A place reaches some 32 errors along the ray, 1e4 times as
/// much where that grazes a surface.
bool starts_alone(const CompiledScene& scene, const ShadePoint& point) { return 1e8 * point.error < scene.scene.settings.shadow_clearance; }

}  // namespace

bool Occluders::find(const CompiledScene& scene, const ShadePoint& point, const Bounds& to) {
    const Vec3 moved(3 * point.error);   // spawn_ray moves by 2, the end of a ray as its beginning
    if (!is_finite(point.position) || !is_finite(moved) || !to.finite()) return false;
    const Shaft shaft({point.position - moved, point.position + moved}, {to.min - moved, to.max + moved});
    if (!scene.top->candidates(shaft, kMostOccluders, ids_)) return false;
    const ShaftSides sides(scene, shaft, starts_alone(scene, point) ? point.instance : kNoId);
    all_.clear(), sides_.clear();
    for (const uint32_t id : ids_) {
        if (!(scene.set->mask(id) & kMaskShadow)) continue;
        const bool solid = scene.set->is_solid(id);
        if (!solid && id == point.instance && sides.leaves_plane(id)) continue;
        const One one{id, uint32_t(sides_.size())};
        if ((solid ? scene.set->solid(id).tree.sides(sides, sides_) : sides.side(id)) == CsgSide::varies) all_.push_back(one);
        else sides_.resize(one.sides);
    }
    return true;
}

bool Occluders::hides(const CompiledScene& scene, const One& one, const Ray& ray, WorkCounters& work) const {
    if (!scene.set->is_solid(one.id)) return scene.set->occluded(std::span(&one.id, 1), ray, work);
    Hit unused;
    return scene.set->intersect_solid(one.id, ray, unused, work, std::span(sides_).subspan(one.sides, scene.set->solid(one.id).tree.nodes().size()));
}

bool Occluders::occluded(const CompiledScene& scene, const Ray& ray, WorkCounters& work) {
    if (!can_hit(ray, kLargestCoordinate<double>)) return false;
    for (One& one : all_) {
        ++work.filtered;
        if (!hides(scene, one, ray, work)) continue;
        std::swap(all_[0], one);
        return true;
    }
    return false;
}

void Occluders::all_hits(const CompiledScene& scene, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const {
    if (!can_hit(ray, kLargestCoordinate<double>)) return;
    const size_t first = hits.size();
    work.filtered += all_.size();
    for (const One& one : all_) scene.set->all_hits(std::span(&one.id, 1), ray, hits, work);
    put_in_order(hits, first);
}

}  // namespace alidade
