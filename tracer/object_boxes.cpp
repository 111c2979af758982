// SPDX-License-Identifier: Apache-2.0
#include "tracer/object_boxes.h"

#include "core/clamp.h"
#include "eval/csg_expression.h"
#include "eval/kept_boxes.h"

#include <algorithm>

namespace alidade {
namespace {

/// Of node `n` and of what is behind it.
Bounds surfaces(const CompiledScene& scene, std::span<const CsgNode> nodes, uint32_t n) {
    const CsgNode& node = nodes[n];
    if (node.op == CsgOp::leaf) {
        const Instance* part = node.leaf == kNoId ? nullptr : &scene.instances[node.leaf];
        return part ? part->to_world.bounds(scene.geometries[part->geometry].bounds) : Bounds();
    }
    const bool meets = node.op == CsgOp::intersection, clips = node.op == CsgOp::clip;
    Bounds any, all = {Vec3(-kInf), Vec3(kInf)};
    bool limited = false;
    Bounds clipped;
    for (uint32_t child = n + 1; child < node.end; child = nodes[child].end) {
        const Bounds bounds = surfaces(scene, nodes, child);
        any.extend(bounds);
        if (clips && nodes[child].place == 0) clipped = bounds;
        else if (!nodes[child].far) all = intersection(all, bounds), limited = true;
    }
    if (clips) return smaller_box(clipped, all);
    return meets && limited ? all : any;
}

/// Corners in single precision, and at 0 what is 0 but for roundings: what bounds are padded with must not tell faces in one plane from each other.
Bounds without_pads(const Bounds& box) {
    const double least = 1e-9 * std::max(max_abs(box.min), max_abs(box.max));
    const auto rounded = [least](const Vec3& corner) {
        Vec3 out;
        for (int i = 0; i < 3; ++i) out[i] = std::abs(corner[i]) < least ? 0 : double(float(corner[i]));
        return out;
    };
    return {rounded(box.min), rounded(box.max)};
}

}  // namespace

uint32_t ObjectNumbers::number_of(const std::vector<NodeId>& path) {
    if (!scene_.settings.first_box_shows) return 0;
    const auto one = std::ranges::find_if(path, [&](NodeId id) { return scene_.nodes[id.index].whole || is_solid(scene_.nodes[id.index]); });
    std::vector<NodeId> object(path.begin(), one == path.end() ? one : one + 1);
    if (object != last_) ++number_, last_ = std::move(object);
    return number_;
}

Bounds box_of_surfaces(const CompiledScene& scene, const Solid& solid) { return surfaces(scene, solid.tree.nodes(), 0); }

std::vector<Bounds> object_boxes(const CompiledScene& scene) {
    std::vector<Bounds> boxes;
    const auto extend = [&](uint32_t object, const Bounds& by) {
        if (object >= boxes.size()) boxes.resize(object + 1);
        boxes[object].extend(by.empty() || by.finite() ? by : Bounds{Vec3(-kInf), Vec3(kInf)});
    };
    for (const Instance& instance : scene.instances) extend(instance.object, instance.bounds);     // none of parts of solids
    for (const Solid& solid : scene.solids) {
        const auto nodes = solid.tree.nodes();
        const auto part = std::ranges::find_if(nodes, [](const CsgNode& n) { return n.op == CsgOp::leaf && n.leaf != kNoId; });
        if (part == nodes.end()) continue;
        const Bounds box = box_of_surfaces(scene, solid);
        extend(scene.instances[part->leaf].object, box.finite() ? box : solid.tree.bounds_by_sides());      // planes bound each other
    }
    for (Bounds& box : boxes)
        if (box.finite()) box = without_pads(box);
    return boxes;
}

double entry_of(const Ray& ray, const Bounds& box) { return box.finite() ? inside_bounds(ray, box).entry : -kInf; }

}  // namespace alidade
