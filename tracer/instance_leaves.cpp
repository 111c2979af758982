// SPDX-License-Identifier: Apache-2.0
#include "tracer/instance_leaves.h"

#include "tracer/instance_set.h"
#include "tracer/shade_point.h"

namespace alidade {
namespace {

void add(const Instance& instance, const Ray& ray, const Hit& hit, std::vector<CsgCrossing>& out) {
    out.push_back({hit, world_error(instance, ray, hit, ray.at(hit.t)), 0});
}

}  // namespace

bool InstanceLeaves::crossings(uint32_t id, const Ray& ray, std::vector<CsgCrossing>& out) const {
    const Instance& instance = scene_.instances[id];
    const Geometry& geometry = scene_.geometries[instance.geometry];
    const Ray local = instance.to_local.ray(ray);
    if (geometry.mesh) {
        thread_local std::vector<Hit> hits;
        hits.clear();
        geometry.triangles->all_hits(local, hits, work_, id);
        for (const Hit& hit : hits) add(instance, ray, hit, out);
        return false;
    }
    ++work_.primitives;
    const Crossings crossings = geometry.ops->crossings(*geometry.source, local);
    for (int i = 0; i < crossings.count; ++i) add(instance, ray, hit_of(crossings.at[i], id), out);
    return !geometry.bounds.finite() && begins_inside(*geometry.ops, *geometry.source, local, crossings);
}

bool InstanceLeaves::inside(uint32_t id, const Vec3& point) const {
    const Instance& instance = scene_.instances[id];
    const Geometry& geometry = scene_.geometries[instance.geometry];
    return !geometry.mesh && geometry.ops->inside(*geometry.source, instance.to_local.point(point));
}

double InstanceLeaves::cosine(const Ray& ray, const Hit& hit) const { return std::abs(dot(geometric_normal(scene_, ray, hit), ray.dir)) / length(ray.dir); }

CsgLeaf csg_leaf(const CompiledScene& scene, uint32_t id) {
    const Instance& instance = scene.instances[id];
    const Geometry& geometry = scene.geometries[instance.geometry];
    CsgLeaf leaf;
    leaf.id = id;
    leaf.inside = geometry.mesh ? CsgInside::nowhere : geometry.ops->solid(*geometry.source) ? CsgInside::by_crossings : CsgInside::at_points;
    leaf.bounds = instance.bounds;
    return leaf;
}

}  // namespace alidade
