// SPDX-License-Identifier: Apache-2.0
#include "tracer/instance_leaves.h"

#include "eval/bound_tests.h"
#include "eval/mesh_inside.h"
#include "eval/placed.h"
#include "tracer/shade_point.h"

namespace alidade {

bool InstanceLeaves::crossings(uint32_t id, const Ray& ray, std::vector<CsgCrossing>& out) const {
    const Instance& instance = scene_.instances[id];
    const Geometry& geometry = scene_.geometries[instance.geometry];
    const Ray local = instance.local(ray);
    if (geometry.mesh) {
        thread_local std::vector<Hit> hits;
        hits.clear();
        geometry.triangles->all_hits(local, hits, work_, id);
        for (const Hit& hit : hits) out.push_back({hit, 0});
        return false;
    }
    ++work_.primitives;
    const Crossings crossings = geometry.ops->crossings_wanted(*geometry.source, geometry.bounds, local, Wanted::all);
    for (int i = 0; i < crossings.count; ++i) out.push_back({hit_of(crossings.at[i], id), 0});
    if (crossings.begins_inside) return *crossings.begins_inside;
    return !geometry.bounds.finite() && begins_inside(*geometry.ops, *geometry.source, local, crossings);
}

bool InstanceLeaves::inside(uint32_t id, const Vec3& point) const {
    const Instance& instance = scene_.instances[id];
    const Geometry& geometry = scene_.geometries[instance.geometry];
    const Vec3 local = instance.local(point);
    return geometry.mesh ? inside_mesh(*geometry.mesh, *geometry.triangles, local, work_) : geometry.ops->inside(*geometry.source, local);
}

bool InstanceLeaves::sees(uint32_t id, const Ray& ray) const { return scene_.bound_tests->passes(scene_.instances[id].bound_test, ray); }

CsgLeaves::Sharpness InstanceLeaves::sharpness(const Ray& ray, const Hit& hit) const {
    const double cosine = std::abs(dot(geometric_normal(scene_, ray, hit), ray.dir)) / length(ray.dir);
    return {world_error(scene_, ray, hit, ray.at(hit.t)), cosine};
}

Bounds narrowed_leaf(const CompiledScene& scene, uint32_t id, bool inverted, const Bounds& box) {
    const Instance& instance = scene.instances[id];
    const Geometry& geometry = scene.geometries[instance.geometry];
    if (geometry.mesh || !geometry.ops->narrow) return box;
    const Bounds local = geometry.ops->narrow(*geometry.source, inverted, instance.to_local.bounds(box));
    return local.empty() ? Bounds() : intersection(box, instance.to_world.bounds(local));
}

std::optional<HalfSpace> half_space(const CompiledScene& scene, uint32_t id) {
    const Instance& instance = scene.instances[id];
    const auto* plane = std::get_if<Plane>(scene.geometries[instance.geometry].source);
    if (!plane) return std::nullopt;
    const double offset = plane->distance * length(plane->normal);
    return HalfSpace{instance.to_local.transposed(plane->normal), offset - dot(plane->normal, instance.to_local.translation)};
}

CsgLeaf csg_leaf(const CompiledScene& scene, uint32_t id) {
    const Instance& instance = scene.instances[id];
    const Geometry& geometry = scene.geometries[instance.geometry];
    CsgLeaf leaf;
    leaf.id = id;
    leaf.inside = csg_inside(geometry.ops, *geometry.source), leaf.endless = geometry.endless;
    leaf.bounds = instance.bounds;
    leaf.cost = geometry.mesh ? kCsgCostOfMesh : csg_cost(*geometry.ops);
    return leaf;
}

}  // namespace alidade
