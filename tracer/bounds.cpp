// SPDX-License-Identifier: Apache-2.0
#include "tracer/bounds.h"

#include "eval/bound_tests.h"
#include "eval/csg_expression.h"
#include "eval/quadric_reach.h"

#include <algorithm>
#include <set>

namespace alidade {
namespace {

/// How many nodes of the path stand above the set or union that POV-Ray does not take apart.
size_t above_object(const Scene& scene, const std::vector<NodeId>& path) {
    return size_t(std::ranges::find_if(path, [&](NodeId id) { return scene.nodes[id.index].whole || is_solid(scene.nodes[id.index]); }) - path.begin());
}

/// Is the end of the path a part of such a set?
bool is_part(const Scene& scene, const std::vector<NodeId>& path) {
    return std::any_of(path.begin() + std::ptrdiff_t(above_object(scene, path)), path.end(), [&](NodeId id) { return scene.nodes[id.index].csg != CsgKind::none; });
}

/// Quadrics with products of two coordinates, hyperboloids of one sheet and cones: POV-Ray finds no box for them.
bool is_boxless(const Quadric& q) {
    if (q.products != Vec3(0)) return true;
    const double product = q.squares.x * q.squares.y * q.squares.z, sign = product < 0 ? 1 : -1;     // one of them is below 0, or two
    if (product == 0) return false;
    const Vec3 a = sign * q.squares, b = sign * q.linear;
    const bool mixed = std::min({a.x, a.y, a.z}) < 0 && std::max({a.x, a.y, a.z}) > 0;
    return mixed && sign * q.constant <= dot(b, b / (4.0 * a));
}

/// Does what clips something find a box for it? An inverse object does not; a plane is a plane, whichever side it leaves.
bool has_box(const Scene& scene, NodeId clip) {
    bool inverse = false;
    for (std::optional<NodeId> at = clip; at; at = lone_part(scene.nodes[at->index])) {
        const Node& node = scene.nodes[at->index];
        const auto* shape = std::get_if<ShapeId>(&node.what);
        if (shape && std::holds_alternative<Plane>(scene.shapes[shape->index].geometry)) return true;
        inverse = inverse != node.inverse;
    }
    return !inverse;
}

/// Was the quadric at the end of the path clipped before its block ended that bounds it first? Then it has a box, if it had no products where it was clipped: clips that stand behind transformations are moved back by
/// them.
bool is_boxed_by_clips(const Scene& scene, const std::vector<NodeId>& path, const Quadric& quadric) {
    Transform placed;
    for (size_t i = path.size(); i-- > 0;) {
        const Node& node = scene.nodes[path[i].index];
        for (const NodeId clip : node.clips) {
            const Node& clipping = scene.nodes[clip.index];
            const auto before = lone_part(clipping) ? inverse(clipping.to_parent) : Transform();
            if (before && has_box(scene, clip) && !has_products(moved(quadric, *before * placed))) return true;
        }
        if (!node.bounds.empty() || i == 0 || !lone_part(scene.nodes[path[i - 1].index])) return false;
        placed = node.to_parent * placed;
    }
    return false;
}

bool is_bounded_as_it_is(const Scene& scene, const std::vector<NodeId>& path, const ShapeGeometry& shape) {
    const auto* quadric = std::get_if<Quadric>(&shape);
    return std::holds_alternative<Polynomial>(shape) || (quadric && is_boxless(*quadric) && !is_boxed_by_clips(scene, path, *quadric));
}

/// Round shapes and quadrics, whose boxes POV-Ray asks in any case.
bool keeps_its_box(const ShapeGeometry& shape) {
    return std::holds_alternative<Cylinder>(shape) || std::holds_alternative<Cone>(shape) || std::holds_alternative<Torus>(shape) || std::holds_alternative<Quadric>(shape);
}

/// Where instances have surfaces: of parts of solids no more than the solid has.
std::vector<Bounds> surfaces(const CompiledScene& scene) {
    std::vector<Bounds> out;
    for (const Instance& instance : scene.instances) out.push_back(instance.bounds);
    for (const Solid& solid : scene.solids)
        for (const CsgNode& node : solid.tree.nodes())
            if (node.op == CsgOp::leaf && node.leaf != kNoId) out[node.leaf] = intersection(node.box, solid.tree.bounds());
    return out;
}

const Transform& placed(const CompiledScene& scene, const std::vector<NodeId>& path) { return scene.scene.nodes[path.front().index].to_parent; }

/// The boxes of objects, each found once.
class KeptBox {
  public:
    explicit KeptBox(const CompiledScene& scene) : scene_(scene) {}

    /// Of the set or union that the path leads to or into; of the shape at its end where there is none.
    const Bounds& of_object(const std::vector<NodeId>& path) {
        const size_t count = std::min(above_object(scene_.scene, path) + 1, path.size());
        const std::vector<NodeId> object(path.begin(), path.begin() + std::ptrdiff_t(count));
        if (object != object_) box_ = scene_.bound_tests->kept_box(object, placed(scene_, path)), object_ = object;
        return box_;
    }

  private:
    const CompiledScene& scene_;
    std::vector<NodeId> object_;
    Bounds box_;
};

}  // namespace

bool has_hierarchy(const CompiledScene& scene) {
    constexpr size_t kLeastObjects = 3;
    std::set<uint32_t> objects;
    for (const Instance& instance : scene.instances)
        if (objects.insert(instance.object).second && objects.size() + scene.lights.size() >= kLeastObjects) return true;
    return false;
}

void find_bounds(CompiledScene& scene, const BoundedPaths& bounded) {
    if (bounded.empty()) return;
    scene.bound_tests = std::make_unique<BoundTests>(scene.scene);
    const std::vector<Bounds> surface = surfaces(scene);
    const bool hierarchy = has_hierarchy(scene);
    KeptBox kept(scene);
    bounded.for_each([&](uint32_t id, const std::vector<NodeId>& path) {
        Instance& instance = scene.instances[id];
        const ShapeGeometry& shape = *scene.geometries[instance.geometry].source;
        const bool as_it_is = is_part(scene.scene, path) || is_bounded_as_it_is(scene.scene, path, shape);
        if (as_it_is) instance.bound_test = scene.bound_tests->by_shapes(path, placed(scene, path), surface[id]);
        if (as_it_is || hierarchy || keeps_its_box(shape)) instance.bound_test = scene.bound_tests->in_box(instance.bound_test, kept.of_object(path), surface[id]);
    });
    for (Solid& solid : scene.solids) solid.tree.find_bounded([&](uint32_t leaf) { return scene.instances[leaf].bound_test != kNoId; });
}

void bound_object_boxes(CompiledScene& scene, const BoundedPaths& bounded) {
    KeptBox kept(scene);
    bounded.for_each([&](uint32_t id, const std::vector<NodeId>& path) {
        const Bounds box = kept.of_object(path);
        if (box.finite()) scene.object_boxes[scene.instances[id].object] = box;
    });
}

}  // namespace alidade
