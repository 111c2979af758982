// SPDX-License-Identifier: Apache-2.0
#include "scene/graph.h"
#include "scene/queries.h"

namespace alidade {

namespace {

/// Of each shape, empty for the unbounded ones.
std::vector<Bounds> shape_bounds(const Scene& scene) {
    std::vector<Bounds> out;
    out.reserve(scene.shapes.size());
    for (const ShapeEntry& shape : scene.shapes) {
        const Bounds b = bounds(shape.geometry);
        out.push_back(b.finite() ? b : Bounds());
    }
    return out;
}

}  // namespace

Bounds world_bounds(const Scene& scene) {
    const std::vector<Bounds> of_shape = shape_bounds(scene);
    const auto children = [&](uint32_t i, const auto& f) {
        for (const NodeId child : scene.nodes[i].children) f(child.index);
    };
    // Children before parents, each node once: paths may be far more than nodes.
    std::vector<Bounds> in_parent(scene.nodes.size());
    const std::vector<uint32_t> order = topological_order(scene.nodes.size(), children).sequence;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Node& node = scene.nodes[*i];
        if (!node.flags.visible) continue;
        Bounds local;
        if (const ShapeId* shape = std::get_if<ShapeId>(&node.what)) local.extend(of_shape[shape->index]);
        for (const NodeId child : node.children) local.extend(in_parent[child.index]);
        const Bounds mapped = node.to_parent.bounds(local);
        if (mapped.finite()) in_parent[*i] = mapped;
    }
    Bounds all;
    for (const NodeId root : scene.roots) all.extend(in_parent[root.index]);
    return all;
}

}  // namespace alidade
