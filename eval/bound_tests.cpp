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

/// Is there a disc in it?
bool has_discs(const Scene& scene, NodeId id) {
    const Node& node = scene.nodes[id.index];
    const auto* shape = std::get_if<ShapeId>(&node.what);
    if (shape && std::holds_alternative<Disc>(scene.shapes[shape->index].geometry)) return true;
    return std::ranges::any_of(node.children, [&](NodeId child) { return has_discs(scene, child); });
}

bool meets_box(const Bounds& box, const Ray& ray) {
    if (box.empty()) return false;
    const LineInterval in_box = inside_bounds(ray, box);
    return !in_box.empty() && in_box.exit >= 0;
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
        Bound made{std::move(solid), is_convex(scene_, bound), has_discs(scene_, bound), nullptr, nullptr, {}, {}};
        ask_shape(made, bound);
        at->second.push_back(std::move(made));
    }
    return at->second;
}

void BoundTests::ask_shape(Bound& bound, NodeId node) const {
    const LoneShape lone = lone_shape(scene_, node);
    const auto to_shape = inverse(lone.to_space);
    if (!lone.shape || !to_shape || std::holds_alternative<Mesh>(*lone.shape)) return;
    bound.ops = find_shape(*lone.shape), bound.shape = lone.shape, bound.to_shape = *to_shape;
    bound.own = bound.ops->bounds(*bound.shape);
}

void BoundTests::follow(const std::vector<NodeId>& path, const Transform& placed) {
    size_t common = 0;
    while (common < path.size() && common < trail_.size() && trail_[common].node == path[common]) ++common;
    trail_.erase(trail_.begin() + std::ptrdiff_t(common), trail_.end());
    for (size_t i = common; i < path.size(); ++i) {
        const Node& node = scene_.nodes[path[i].index];
        Step step;
        step.node = path[i];
        step.to_world = i == 0 ? placed : trail_.back().to_world * node.to_parent;
        if (!node.bounds.empty()) step.to_local = inverse(step.to_world);
        trail_.push_back(std::move(step));
    }
}

uint32_t BoundTests::by_shapes(const std::vector<NodeId>& path, const Transform& placed, const Bounds& surface) {
    if (surface.empty()) return kNoId;
    const Bounds box = shrunk(surface);
    follow(path, placed);
    uint32_t last = kNoId;
    for (Step& step : trail_) {
        if (!step.to_local) continue;
        for (const Bound& bound : bounds_of(step.node)) {
            if (bound.convex && box.finite() && holds(bound.solid, *step.to_local, box)) continue;
            const auto [at, added] = step.tests.try_emplace({last, &bound}, uint32_t(tests_.size()));
            if (added) tests_.push_back({&bound, *step.to_local, {}, last});
            last = at->second;
        }
    }
    return last;
}

Bounds BoundTests::kept_box(const std::vector<NodeId>& path, const Transform& placed) {
    follow(path, placed);
    size_t top = path.size() - 1;
    while (top > 0 && lone_part(scene_.nodes[path[top - 1].index])) --top;
    const bool moved = std::any_of(path.begin(), path.begin() + std::ptrdiff_t(top), [&](NodeId id) { return !scene_.nodes[id.index].to_parent.is_identity(); });
    return moved ? boxes_.of_moved(path[top], scene_.nodes[path[top].index].to_parent, trail_[top - 1].to_world) : boxes_.of(path[top], trail_[top].to_world);
}

uint32_t BoundTests::in_box(uint32_t before, const Bounds& kept, const Bounds& surface) {
    const Bounds box = shrunk(surface);
    if (surface.empty() || !kept.finite() || (kept.contains(box.min) && kept.contains(box.max))) return before;
    tests_.push_back({nullptr, {}, kept, before});
    return uint32_t(tests_.size() - 1);
}

bool BoundTests::passes(uint32_t number, const Ray& ray) const {
    for (uint32_t i = number; i != kNoId; i = tests_[i].before)
        if (!tests_[i].passes(ray)) return false;
    return true;
}

bool BoundTests::Test::passes(const Ray& ray) const {
    if (!shape) return meets_box(box, ray);
    Ray local = to_local.ray(ray);
    local.tmin = 0, local.tmax = kInf;
    return meets(*shape, local);
}

bool BoundTests::meets(const Bound& bound, const Ray& ray) {
    if (!bound.ops) return ((!bound.has_discs || meets_box(bound.solid.bounds(), ray)) && bound.solid.inside(ray.origin)) || bound.solid.first(ray);
    const Ray local = bound.to_shape.ray(ray);
    const Crossings met = bound.ops->crossings_wanted(*bound.shape, bound.own, local, Wanted::any);
    for (int i = 0; i < met.count; ++i)
        if (met.at[i].t >= 0) return true;
    return (!bound.has_discs || meets_box(bound.own, local)) && bound.ops->inside(*bound.shape, local.origin);
}

}  // namespace alidade
