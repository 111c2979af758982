// SPDX-License-Identifier: Apache-2.0
#include "tracer/instance_set.h"

#include "accel/local_ray.h"
#include "core/clamp.h"
#include "eval/bound_tests.h"
#include "eval/placed.h"
#include "tracer/instance_leaves.h"
#include "tracer/object_boxes.h"

#include <numeric>

namespace alidade {

Vec3 Instance::corrected(const Vec3& point) const { return alidade::corrected(to_world.linear, to_local.linear, to_world.translation, point, to_local.point(point)); }

Ray Instance::corrected(const Ray& ray) const {
    Ray local = to_local.ray(ray);
    local.origin = alidade::corrected(to_world.linear, to_local.linear, to_world.translation, ray.origin, local.origin);
    local.dir = alidade::corrected(to_world.linear, to_local.linear, Vec3(0), ray.dir, local.dir);
    return local;
}

namespace {

/// The first crossing of a closed form with the local ray, or any, as a hit.
bool first_crossing(const Geometry& geometry, const Ray& local, Wanted wanted, uint32_t instance, Hit& hit, WorkCounters& work) {
    ++work.primitives;
    const Crossings crossings = geometry.ops->crossings_wanted(*geometry.source, geometry.bounds, local, wanted);
    for (int i = 0; i < crossings.count; ++i) {
        if (!(crossings.at[i].t >= local.tmin)) continue;
        if (!(crossings.at[i].t <= local.tmax)) return false;
        hit = hit_of(crossings.at[i], instance);
        return true;
    }
    return false;
}

/// Is what was crossed there for this ray? Out of line: scenes without bounds that may be missed pay for a comparison alone.
[[gnu::noinline]] bool passes_bounds(const CompiledScene& scene, const Instance& instance, const Ray& ray) { return scene.bound_tests->passes(instance.bound_test, ray); }

/// Does a line that passes by the box of an instance seem to meet it all the same? So it may from so far away that the instance is smaller than the roundings of the local ray. Out of line: lines that are in the box do not ask.
[[gnu::noinline]] bool may_seem_to_meet(const Ray& ray, const Bounds& box) {
    const bool bounded = max_abs(box.min) <= kLargestCoordinate<double> && max_abs(box.max) <= kLargestCoordinate<double>;
    return !bounded || local_ray(ray, box, {false, kFar}).enters_box();
}

/// Do structures look for the instance on this line? Nobody sees it who misses what bounds it. `in_box`: where the line is in the box of the instance, as clamp_to_bounds() has it; all of it where crossings lie there anyway.
bool looked_for(const CompiledScene& scene, const Instance& instance, const Ray& ray, LineInterval& in_box) {
    if (instance.bound_test != kNoId && !passes_bounds(scene, instance, ray)) return false;
    if (instance.in_place) return true;   // crossings in place lie in the bounds of their shape
    in_box = inside_bounds(ray, instance.bounds);
    if (!in_box.empty()) return true;
    in_box = {};
    return may_seem_to_meet(ray, instance.bounds);
}

}  // namespace

InstanceSet::InstanceSet(const CompiledScene& scene, Mask seen_by) : scene_(scene), seen_by_(seen_by) {
    if (scene.solids.empty()) return;
    wholes_.resize(scene.instances.size());
    std::iota(wholes_.begin(), wholes_.end(), 0u);
    for (uint32_t id = uint32_t(wholes_.size()); id < size(); ++id)
        for (const CsgNode& node : solid(id).tree.nodes())
            if (node.op == CsgOp::leaf && node.leaf != kNoId) wholes_[node.leaf] = id;
}

bool InstanceSet::is_seen_before(const Ray& ray, double t, uint32_t instance, uint32_t primitive, const Hit& hit) const {
    const std::vector<Bounds>& boxes = scene_.object_boxes;
    if (t != hit.t || !hit.valid() || !scene_.first_box_shows) return comes_before(t, instance, primitive, hit);
    const double entry = entry_of(ray, boxes[scene_.instances[instance].object]), other = entry_of(ray, boxes[scene_.instances[hit.instance].object]);
    return entry != other ? entry < other : comes_before(t, instance, primitive, hit);
}

/// Out of line: scenes without solids pay for a comparison alone.
[[gnu::noinline]] bool InstanceSet::intersect_solid(uint32_t id, const Ray& ray, Hit& hit, WorkCounters& work, std::span<const CsgSide> known) const {
    const Solid& s = solid(id);
    if (!(s.mask & ray.mask)) return false;
    Ray shortened = ray;
    if (hit.t < ray.tmax) shortened.tmax = std::min(ray.tmax, hit.t + instance_slack(ray, hit.t));
    Hit candidate;
    if (!s.tree.first(shortened, InstanceLeaves(scene_, work), candidate, known)) return false;
    if (!is_seen_before(ray, candidate.t, candidate.instance, candidate.primitive, hit)) return false;
    hit = candidate;
    return true;
}

bool InstanceSet::intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const {
    bool found = false;
    for (const uint32_t id : ids) {
        if (is_solid(id)) {
            found |= intersect_solid(id, ray, hit, work);
            continue;
        }
        const Instance& instance = scene_.instances[id];
        if (!(instance.mask & ray.mask)) continue;
        const Geometry& geometry = scene_.geometries[instance.geometry];
        Ray local = instance.local(ray);
        if (hit.t < ray.tmax) local.tmax = std::min(ray.tmax, hit.t + instance_slack(ray, hit.t));
        Hit candidate;
        const bool crossed = geometry.mesh ? geometry.triangles->intersect(local, candidate, work, id) : first_crossing(geometry, local, Wanted::first, id, candidate, work);
        LineInterval in_box;
        if (!crossed || !looked_for(scene_, instance, ray, in_box)) continue;
        candidate.t = std::clamp(candidate.t, in_box.entry, in_box.exit);
        if (!is_seen_before(ray, candidate.t, id, candidate.primitive, hit)) continue;
        hit = candidate;
        found = true;
    }
    return found;
}

bool InstanceSet::occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const {
    Hit unused;   // written to where something is crossed, and not read
    for (const uint32_t id : ids) {
        if (is_solid(id)) {
            Hit none;
            if (intersect_solid(id, ray, none, work)) return true;
            continue;
        }
        const Instance& instance = scene_.instances[id];
        if (!(instance.mask & ray.mask)) continue;
        const Geometry& geometry = scene_.geometries[instance.geometry];
        const Ray local = instance.local(ray);
        const bool crossed = geometry.mesh ? geometry.triangles->occluded(local, work) : first_crossing(geometry, local, Wanted::any, id, unused, work);
        LineInterval unasked;
        if (crossed && looked_for(scene_, instance, ray, unasked)) return true;
    }
    return false;
}

void InstanceSet::all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const {
    for (const uint32_t id : ids) {
        const size_t first = hits.size();
        if (is_solid(id)) {
            const Solid& s = solid(id);
            if (s.mask & ray.mask) s.tree.all(ray, InstanceLeaves(scene_, work), hits);
            continue;
        }
        const Instance& instance = scene_.instances[id];
        if (!(instance.mask & ray.mask)) continue;
        const Geometry& geometry = scene_.geometries[instance.geometry];
        const Ray local = instance.local(ray);
        if (geometry.mesh) {
            geometry.triangles->all_hits(local, hits, work, id);
        } else {
            ++work.primitives;
            const Crossings crossings = geometry.ops->crossings_wanted(*geometry.source, geometry.bounds, local, Wanted::all);
            for (int i = 0; i < crossings.count; ++i)
                if (crossings.at[i].t >= ray.tmin && crossings.at[i].t <= ray.tmax) hits.push_back(hit_of(crossings.at[i], id));
        }
        if (hits.size() == first) continue;
        LineInterval in_box;
        if (!looked_for(scene_, instance, ray, in_box)) hits.resize(first);
        if (instance.in_place) in_box = inside_bounds(ray, instance.bounds);
        if (in_box.empty()) in_box = {};
        for (size_t i = first; i < hits.size(); ++i) hits[i].t = std::clamp(hits[i].t, in_box.entry, in_box.exit);
    }
}

}  // namespace alidade
