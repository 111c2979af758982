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

namespace {

/// How far apart the two ways are by which points of `box`, in the space of an instance, come to the world: through the solid, and at once, as rays know it.
Vec3 discrepancy(const Transform& through, const Transform& at_once, const Bounds& box) {
    const Vec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
    Vec3 out = glm::abs(through.translation - at_once.translation);
    for (int column = 0; column < 3; ++column) out += glm::abs(through.linear[column] - at_once.linear[column]) * farthest[column];
    return out;
}

}  // namespace

namespace {

/// Does the plane lie across an axis, but for roundings?
bool is_across_an_axis(const ShapeGeometry& shape, const Transform& to_local) {
    const auto* plane = std::get_if<Plane>(&shape);
    if (!plane) return false;
    const Vec3 n = glm::abs(to_local.transposed(plane->normal));
    const double most = max_abs(n);
    return int(n.x > 1e-12 * most) + int(n.y > 1e-12 * most) + int(n.z > 1e-12 * most) == 1;
}

}  // namespace

CsgOwnSpace own_space(const CompiledScene& scene, const SolidSpace& space) {
    CsgOwnSpace own;
    if (space.endless.empty()) return own;
    own.narrow = [&scene, &space](uint32_t id, bool inverted, const Bounds& box) {
        const auto place = space.endless.find(id);
        const Geometry& geometry = scene.geometries[scene.instances[id].geometry];
        if (place == space.endless.end() || !geometry.ops->narrow) return box;
        const auto to_local = inverse(place->second);
        if (!to_local) return box;
        const Bounds local = geometry.ops->narrow(*geometry.source, inverted, to_local->bounds(box));
        return local.empty() ? Bounds() : intersection(box, place->second.bounds(local));
    };
    own.by_sides = [&scene, &space, narrow = own.narrow](uint32_t id, bool inverted, const Bounds& box) {
        const auto place = space.endless.find(id);
        const auto to_local = place == space.endless.end() ? std::nullopt : inverse(place->second);
        return to_local && is_across_an_axis(*scene.geometries[scene.instances[id].geometry].source, *to_local) ? narrow(id, inverted, box) : box;
    };
    own.placed = [&scene, &space](const Bounds& box) {
        Bounds out = space.to_world.bounds(box);
        Vec3 pad(0);
        for (const auto& [id, to_set] : space.endless)
            if (const auto to_local = inverse(to_set)) pad = glm::max(pad, discrepancy(space.to_world * to_set, scene.instances[id].to_world, to_local->bounds(box)));
        out.min -= pad * 2.0, out.max += pad * 2.0;   // and once more for the roundings of the measure
        return out;
    };
    return own;
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
