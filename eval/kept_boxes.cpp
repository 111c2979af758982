// SPDX-License-Identifier: Apache-2.0
#include "eval/kept_boxes.h"

#include "core/transform.h"
#include "eval/csg.h"
#include "eval/csg_expression.h"
#include "eval/quadric_reach.h"
#include "scene/graph.h"

#include <algorithm>

namespace alidade {
namespace {

const Bounds kEverywhere{Vec3(-kInf), Vec3(kInf)};

double volume(const Bounds& b) {
    const Vec3 e = b.extent();
    return e.x * e.y * e.z;
}

/// Across `axis`, without turning more than it takes: z goes to the axis.
Transform along(const Vec3& from, const Vec3& axis) {
    const Vec3 d = normalized(axis);
    if (d.z < -1 + 1e-12) return {Mat3(1, 0, 0, 0, -1, 0, 0, 0, -1), from};
    const double k = 1 / (1 + d.z);
    return {Mat3(1 - d.x * d.x * k, -d.x * d.y * k, -d.x, -d.x * d.y * k, 1 - d.y * d.y * k, -d.y, d.x, d.y, d.z), from};
}

/// May something of it be outside of the boxes that POV-Ray makes?
bool may_leave_its_box(const ShapeGeometry& shape) {
    const auto* quadric = std::get_if<Quadric>(&shape);
    return quadric ? may_outgrow_reach(*quadric) : csg_endless(shape);
}

FramedBox round_box(const Vec3& from, const Vec3& axis, double radius, double bottom, double top) { return {along(from, axis), {Vec3(-radius, -radius, bottom), Vec3(radius, radius, top)}}; }

/// But for roundings, does it leave all where it is?
bool stays(const Transform& t) {
    double most = max_abs(t.translation);
    for (int i = 0; i < 3; ++i) most = std::max(most, max_abs(t.linear[i] - Mat3(1.0)[i]));
    return most < 1e-9;
}

Bounds box_of_polygon(const Polygon& polygon, const Transform& placed) {
    Bounds box;
    for (const auto& loop : polygon.loops)
        for (const Vec3& p : loop) box.extend(placed.point(p));
    constexpr double kThickness = 0.001;
    for (int i = 0; i < 3; ++i)
        if (box.max[i] - box.min[i] < 1e-9) box.min[i] -= kThickness, box.max[i] += kThickness;
    return box;
}

Bounds box_of_shape(const ShapeGeometry& shape, const Transform& placed) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) {
        const double radius = std::abs(sphere->radius);
        const auto still = turned(*sphere, placed);
        return still ? Bounds{still->scale * (still->sphere.center - radius), still->scale * (still->sphere.center + radius)} : placed.bounds({sphere->center - radius, sphere->center + radius});
    }
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return box_of_polygon(*polygon, placed);
    if (const auto* quadric = std::get_if<Quadric>(&shape)) return moved_box(placed, box_of_ellipsoid(*quadric));
    const FramedBox framed = framed_box(shape);
    return moved_box(placed * framed.frame, framed.box);
}

}  // namespace

FramedBox framed_box(const ShapeGeometry& shape) {
    if (const auto* c = std::get_if<Cylinder>(&shape)) return round_box(c->b, c->a - c->b, std::abs(c->radius), 0, length(c->a - c->b));
    if (const auto* d = std::get_if<Disc>(&shape)) return round_box(d->center, d->normal, std::abs(d->radius), -0.001, 0.001);
    const auto* cone = std::get_if<Cone>(&shape);
    if (!cone) return {{}, bounds(shape)};
    const bool grows = cone->radius_a < cone->radius_b;                  // the axis goes to the end with the larger radius, if that is not negative
    const Vec3 axis = grows ? cone->b - cone->a : cone->a - cone->b;
    return round_box(grows ? cone->a : cone->b, axis, std::abs(std::max(cone->radius_a, cone->radius_b)), 0, length(axis));
}

/// POV-Ray moves the corners.
Bounds moved_box(const Transform& by, const Bounds& box) { return box.finite() ? by.bounds({glm::min(box.min, box.max), glm::max(box.min, box.max)}) : kEverywhere; }

/// Scales behind turns leave the rows of a matrix perpendicular.
std::optional<TurnedSphere> turned(const Sphere& sphere, const Transform& by) {
    const Mat3 rows = glm::transpose(by.linear);
    const Vec3 scale(length(rows[0]), length(rows[1]), length(rows[2]));
    const auto crosses = [&](int i, int j) { return std::abs(dot(rows[i], rows[j])) > 1e-9 * scale[i] * scale[j]; };
    if (crosses(0, 1) || crosses(1, 2) || crosses(2, 0) || !(scale.x > 0 && scale.y > 0 && scale.z > 0)) return std::nullopt;
    return TurnedSphere{{by.point(sphere.center) / scale, sphere.radius}, scale};
}

void cut_by_plane(Bounds& box, const Plane& plane, const Transform& placed, bool inverse) {
    const auto back = alidade::inverse(placed);
    if (!back) return;
    Vec3 normal = back->transposed(normalized(plane.normal));
    double distance = plane.distance + dot(normal, placed.translation);
    if (inverse) normal = -normal, distance = -distance;
    for (int i = 0; i < 3; ++i) {
        const double rest = std::max(std::abs(normal[(i + 1) % 3]), std::abs(normal[(i + 2) % 3]));
        if (rest > 1e-10 * std::abs(normal[i])) continue;
        if (normal[i] > 0) box.max[i] = std::min(box.max[i], distance / normal[i]);
        else box.min[i] = std::max(box.min[i], distance / normal[i]);
    }
}

Bounds smaller_box(const Bounds& box, const Bounds& limit) {
    constexpr double kSame = 1 - 1e-6;                                   // POV-Ray's boxes are in single precision
    return limit.finite() && (!box.finite() || volume(limit) < kSame * volume(box)) ? limit : box;
}

KeptBoxes::Chain KeptBoxes::chain(NodeId id, Transform to) const {
    Chain out;
    for (std::optional<NodeId> at = id; at; at = lone_part(scene_.nodes[at->index])) {
        const Node& node = scene_.nodes[at->index];
        if (!out.nodes.empty()) to = to * node.to_parent;
        out.nodes.emplace_back(*at, to);
        out.inverse = out.inverse != node.inverse;
        if (!std::holds_alternative<Nothing>(node.what)) break;
    }
    return out;
}

Bounds KeptBoxes::own(const Chain& chain) {
    const auto& [id, to] = chain.nodes.back();
    const Node& node = scene_.nodes[id.index];
    if (!node.children.empty()) return moved_box(to, of_parts(id));
    const auto* shape = std::get_if<ShapeId>(&node.what);
    if (!shape) return std::holds_alternative<LightId>(node.what) ? kEverywhere : Bounds();
    const ShapeGeometry& geometry = scene_.shapes[shape->index].geometry;
    const auto* quadric = std::get_if<Quadric>(&geometry);
    return quadric ? own(chain, *quadric) : box_of_shape(geometry, to);
}

std::optional<std::pair<Plane, Transform>> KeptBoxes::plane_in(const Chain& chain) const {
    const auto& [id, to] = chain.nodes.back();
    const auto* shape = std::get_if<ShapeId>(&scene_.nodes[id.index].what);
    const auto* plane = shape ? std::get_if<Plane>(&scene_.shapes[shape->index].geometry) : nullptr;
    return plane ? std::optional(std::pair(*plane, to)) : std::nullopt;
}

/// Where the object was, in the space of its node, when the clip was written: clips behind transformations are moved back by them.
Transform KeptBoxes::written_at(NodeId clip) const {
    const Node& node = scene_.nodes[clip.index];
    return lone_part(node) ? inverse(node.to_parent).value_or(Transform()) : Transform();
}

/// What clips a quadric finds a box for it, where it is when it is clipped first; that is moved.
Bounds KeptBoxes::own(const Chain& chain, const Quadric& quadric) {
    const Transform& to = chain.nodes.back().second;
    const Bounds whole = moved_box(to, box_of_ellipsoid(quadric));
    const auto clipped = std::ranges::find_if(chain.nodes, [&](const auto& at) { return !scene_.nodes[at.first.index].clips.empty(); });
    if (clipped == chain.nodes.end()) return whole;
    const Transform written = written_at(scene_.nodes[clipped->first.index].clips.front());
    const auto back = inverse(clipped->second), ahead = inverse(written);
    if (!back || !ahead) return whole;
    const Transform to_clip = written * *back;
    const Quadric there = moved(quadric, to_clip * to);
    Bounds box = box_of_ellipsoid(there);
    for (const auto& [id, from] : chain.nodes)
        for (const NodeId clip : scene_.nodes[id.index].clips) {
            if (!may_ask()) return whole;
            const Chain clipping = this->chain(clip, to_clip * from * scene_.nodes[clip.index].to_parent);
            if (const auto plane = plane_in(clipping)) cut_by_plane(box, plane->first, plane->second, clipping.inverse);
            else if (!clipping.inverse) box = intersection(box, of_limit(clip, to_clip * from));
        }
    if (!box.empty()) box = reach(there, box);
    const Transform placed = clipped->second * *ahead;
    if (!box.finite()) return whole;
    return stays(placed) ? box : moved_box(placed, box);
}

/// What bounds can itself be bounded, and by the same object twice, again and again: from a number on that no other scene comes near they bound nothing.
bool KeptBoxes::may_ask() { return ++asked_ < 1'000'000 + 16 * scene_.nodes.size(); }

Bounds KeptBoxes::limited(const Chain& chain, Bounds box, std::vector<NodeId> Node::*limits) {
    Bounds common = kEverywhere;
    for (const auto& [id, to] : chain.nodes)
        for (const NodeId limit : scene_.nodes[id.index].*limits)
            if (may_ask() && !this->chain(limit, to).inverse) common = intersection(common, of_limit(limit, to));
    return smaller_box(box, common);
}

Bounds KeptBoxes::of_limit(NodeId id, const Transform& to) {
    const Transform all = to * scene_.nodes[id.index].to_parent;
    return stays(to) || stays(all) ? of(id, all) : of_moved(id, Transform(), all);
}

/// Sets, meshes and quadrics move the box that they had; another shape makes its box anew, without what limits it, but for what clips one that has no end.
Bounds KeptBoxes::of_moved(NodeId id, const Transform& to, const Transform& by) {
    const Chain all = chain(id, by * to);
    const Bounds anew = own(all);
    const auto* shape = std::get_if<ShapeId>(&scene_.nodes[all.nodes.back().first.index].what);
    const ShapeGeometry* geometry = shape ? &scene_.shapes[shape->index].geometry : nullptr;
    if (!geometry || std::holds_alternative<Quadric>(*geometry) || std::holds_alternative<Mesh>(*geometry)) return moved_box(by, of(id, to));
    return anew.finite() ? anew : limited(all, anew, &Node::clips);
}

Bounds KeptBoxes::of(NodeId id, const Transform& to) {
    const Chain all = chain(id, to);
    const Bounds box = own(all);
    return box.empty() && !box.finite() ? box : limited(all, limited(all, box, &Node::bounds), &Node::clips);
}

const Bounds& KeptBoxes::of_parts(NodeId id) {
    const auto known = sets_.find(id.index);
    if (known != sets_.end()) return known->second;
    const Node& set = scene_.nodes[id.index];
    const Bounds box = set.csg == CsgKind::intersection || set.csg == CsgKind::difference ? common(set) : joined(set);
    return sets_.emplace(id.index, box.finite() && !box.empty() ? box : kEverywhere).first->second;
}

Bounds KeptBoxes::joined(const Node& set) {
    Bounds box;
    for (const NodeId part : set.children) box.extend(of(part, scene_.nodes[part.index].to_parent));
    if (const auto* shape = std::get_if<ShapeId>(&set.what)) box.extend(box_of_shape(scene_.shapes[shape->index].geometry, Transform()));
    return box;
}

/// Of the parts that are not turned inside out, cut by planes along the axes and by the reach of quadrics.
Bounds KeptBoxes::common(const Node& set) {
    Bounds box = kEverywhere;
    std::vector<std::pair<const Quadric*, Transform>> quadrics;
    for (size_t i = 0; i < set.children.size(); ++i) {
        const Transform& placed = scene_.nodes[set.children[i].index].to_parent;
        const Chain part = chain(set.children[i], placed);
        const bool inverse = part.inverse != (i > 0 && set.csg == CsgKind::difference);
        const auto& [id, to] = part.nodes.back();
        const auto* shape = std::get_if<ShapeId>(&scene_.nodes[id.index].what);
        const ShapeGeometry* geometry = shape ? &scene_.shapes[shape->index].geometry : nullptr;
        if (const auto plane = plane_in(part)) cut_by_plane(box, plane->first, plane->second, inverse);               // what limits the plane itself does not count
        else if (!inverse) box = intersection(box, of(set.children[i], placed));
        if (const auto* quadric = geometry ? std::get_if<Quadric>(geometry) : nullptr; quadric && !inverse) quadrics.emplace_back(quadric, to);
    }
    for (const auto& [quadric, to] : quadrics)
        if (!box.empty()) box = intersection(box, reach(moved(*quadric, to), box));
    return box;
}

std::vector<bool> nodes_beyond_their_boxes(const Scene& scene) {
    const auto below = [&](uint32_t i, const auto& f) {
        const Node& node = scene.nodes[i];
        for (const auto* list : {&node.children, &node.clips, &node.bounds})
            for (const NodeId id : *list) f(id.index);
    };
    std::vector<bool> reaches(scene.nodes.size()), out(scene.nodes.size());     // reaches: beyond its box, as part of a set
    const std::vector<uint32_t> order = topological_order(scene.nodes.size(), below).sequence;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Node& node = scene.nodes[*i];
        const auto* shape = std::get_if<ShapeId>(&node.what);
        bool any = !node.bounds.empty() || (shape && may_leave_its_box(scene.shapes[shape->index].geometry));
        below(*i, [&](uint32_t j) { any = any || reaches[j]; });
        reaches[*i] = any;
        out[*i] = !node.bounds.empty() || (any && is_solid(node));
    }
    return out;
}

}  // namespace alidade
