// SPDX-License-Identifier: Apache-2.0
#include "eval/bound_tests.h"

#include "core/clamp.h"
#include "eval/csg_expression.h"

#include <algorithm>

namespace alidade {
namespace {

bool is_convex(const ShapeGeometry& shape) {
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return !cylinder->open;
    if (const auto* cone = std::get_if<Cone>(&shape)) return !cone->open && (cone->radius_a < 0) == (cone->radius_b < 0);
    if (const auto* quadric = std::get_if<Quadric>(&shape)) return quadric->products == Vec3(0) && std::min({quadric->squares.x, quadric->squares.y, quadric->squares.z}) >= 0;
    return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Box>(shape) || std::holds_alternative<Plane>(shape);
}

/// Surely? Intersections of what is convex are.
bool is_convex(const Scene& scene, NodeId id) {
    const Node& node = scene.nodes[id.index];
    if (node.inverse || !node.clips.empty()) return false;
    if (const auto* shape = std::get_if<ShapeId>(&node.what)) return node.children.empty() && is_convex(scene.shapes[shape->index].geometry);
    const bool meets = node.csg == CsgKind::intersection || lone_part(node);
    return meets && std::ranges::all_of(node.children, [&](NodeId child) { return is_convex(scene, child); });
}

/// A box that touches what bounds it is held: boxes are padded, and files round their numbers.
Bounds shrunk(const Bounds& box) {
    const Vec3 by = box.extent() * 1e-6;
    return {box.min + by, box.max - by};
}

/// Is all of the box in the convex solid?
bool holds(const SolidQuery& solid, const Transform& to_local, const Bounds& box) {
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y, corner & 4 ? box.max.z : box.min.z);
        if (!solid.inside(to_local.point(p))) return false;
    }
    return true;
}

double volume(const Bounds& box) {
    const Vec3 extent = box.extent();
    return extent.x * extent.y * extent.z;
}

/// A shape that stands alone, neither inverse nor clipped, and where it is.
struct LoneShape {
    const ShapeGeometry* shape = nullptr;      ///< null: there is more
    Transform to_space;
};

LoneShape lone_shape(const Scene& scene, NodeId id, const Transform& placed) {
    Transform to_space = placed;
    for (std::optional<NodeId> at = id; at; at = lone_part(scene.nodes[at->index])) {
        const Node& node = scene.nodes[at->index];
        if (node.inverse || !node.clips.empty() || !node.bounds.empty()) break;
        to_space = to_space * node.to_parent;
        const auto* shape = std::get_if<ShapeId>(&node.what);
        if (shape && node.children.empty()) return {&scene.shapes[shape->index].geometry, to_space};
    }
    return {};
}

/// Of the node in the space that `placed` leads to; of a sphere the smallest, as POV-Ray has it.
Bounds box_around(const Scene& scene, NodeId id, const Transform& placed, MeshAccelerators& meshes) {
    const LoneShape lone = lone_shape(scene, id, placed);
    const auto* sphere = lone.shape ? std::get_if<Sphere>(lone.shape) : nullptr;
    if (!sphere) return SolidQuery(scene, id, meshes, placed * scene.nodes[id.index].to_parent).bounds();
    const Mat3& linear = lone.to_space.linear;
    const Vec3 center = lone.to_space.point(sphere->center);
    Vec3 reach;
    for (int row = 0; row < 3; ++row) reach[row] = std::abs(sphere->radius) * length(Vec3(linear[0][row], linear[1][row], linear[2][row]));
    return {center - reach, center + reach};
}

/// Calls f(node, to_world) for the nodes on the path that something bounds.
template <class F> void for_each_bounded(const Scene& scene, const std::vector<NodeId>& path, const Transform& placed, const F& f) {
    Transform to_world = placed;
    for (size_t i = 0; i < path.size(); ++i) {
        if (i > 0) to_world = to_world * scene.nodes[path[i].index].to_parent;
        if (!scene.nodes[path[i].index].bounds.empty()) f(path[i], to_world);
    }
}

}  // namespace

bool BoundTests::bounded(const Scene& scene, const std::vector<NodeId>& path) {
    return std::ranges::any_of(path, [&](NodeId id) { return !scene.nodes[id.index].bounds.empty(); });
}

const std::vector<BoundTests::Bound>& BoundTests::bounds_of(NodeId node) {
    const auto [at, added] = bounds_.try_emplace(node.index);
    if (!added) return at->second;
    for (const NodeId bound : scene_.nodes[node.index].bounds) {
        SolidQuery solid(scene_, bound, meshes_);
        if (!solid.complete()) continue;      // what cannot be asked bounds nothing
        Bound made{std::move(solid), is_convex(scene_, bound), nullptr, nullptr, {}, {}};
        ask_shape(made, bound);
        at->second.push_back(std::move(made));
    }
    return at->second;
}

void BoundTests::ask_shape(Bound& bound, NodeId node) const {
    const LoneShape lone = lone_shape(scene_, node, Transform());
    const auto to_shape = inverse(lone.to_space);
    if (!lone.shape || !to_shape || std::holds_alternative<Mesh>(*lone.shape)) return;
    bound.ops = find_shape(*lone.shape), bound.shape = lone.shape, bound.to_shape = *to_shape;
    bound.own = bound.ops->bounds(*bound.shape);
}

uint32_t BoundTests::add(Test test) {
    tests_.push_back(std::move(test));
    return uint32_t(tests_.size() - 1);
}

uint32_t BoundTests::by_shapes(const std::vector<NodeId>& path, const Transform& placed, const Bounds& surface) {
    Test test;
    const Bounds box = shrunk(surface);
    for_each_bounded(scene_, path, placed, [&](NodeId node, const Transform& to_world) {
        const auto to_local = inverse(to_world);
        if (!to_local) return;
        for (const Bound& bound : bounds_of(node))
            if (!(bound.convex && box.finite() && holds(bound.solid, *to_local, box))) test.shapes.push_back({&bound, *to_local});
    });
    return surface.empty() || test.shapes.empty() ? kNoId : add(std::move(test));
}

uint32_t BoundTests::by_boxes(const std::vector<NodeId>& path, const Transform& placed, const Bounds& surface) {
    Test test;
    for_each_bounded(scene_, path, placed, [&](NodeId node, const Transform& to_world) {
        for (const NodeId bound : scene_.nodes[node.index].bounds)
            if (!scene_.nodes[bound.index].inverse) test.box = intersection(test.box, box_around(scene_, bound, to_world, meshes_));
    });
    if (surface.empty() || test.box.empty() || !test.box.finite() || (surface.finite() && volume(test.box) >= volume(surface))) return kNoId;
    const Bounds box = shrunk(surface);
    return test.box.contains(box.min) && test.box.contains(box.max) ? kNoId : add(std::move(test));
}

bool BoundTests::passes(uint32_t number, const Ray& ray) const {
    if (number == kNoId) return true;
    const Test& test = tests_[number];
    const LineInterval in_box = inside_bounds(ray, test.box);
    if (in_box.empty() || in_box.exit < 0) return false;
    return std::ranges::all_of(test.shapes, [&](const Placed& placed) {
        Ray local = placed.to_local.ray(ray);
        local.tmin = 0, local.tmax = kInf;
        return meets(*placed.bound, local);
    });
}

bool BoundTests::meets(const Bound& bound, const Ray& ray) {
    if (!bound.ops) return bound.solid.inside(ray.origin) || bound.solid.first(ray);
    const Ray local = bound.to_shape.ray(ray);
    const Crossings met = bound.ops->crossings_wanted(*bound.shape, bound.own, local, Wanted::any);
    for (int i = 0; i < met.count; ++i)
        if (met.at[i].t >= 0) return true;
    return bound.ops->inside(*bound.shape, local.origin);
}

}  // namespace alidade
