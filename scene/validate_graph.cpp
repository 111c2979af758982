// SPDX-License-Identifier: Apache-2.0
#include "scene/graph.h"
#include "scene/validation.h"

namespace alidade {

namespace {

/// By node: is there a shape in its subtree?
std::vector<bool> leads_to_shape(const Scene& scene, const std::vector<uint32_t>& parents_first) {
    std::vector<bool> out(scene.nodes.size());
    for (auto i = parents_first.rbegin(); i != parents_first.rend(); ++i) {
        const Node& node = scene.nodes[*i];
        bool any = std::holds_alternative<ShapeId>(node.what);
        for_each_link(scene, node, [&](NodeId id) { any = any || out[id.index]; });
        out[*i] = any;
    }
    return out;
}

}  // namespace

void check_graph(Validation& v) {
    const Scene& s = v.scene;
    const auto links = [&](uint32_t i, const auto& f) { for_each_link(s, s.nodes[i], [&](NodeId id) { f(id.index); }); };
    const TopologicalOrder order = topological_order(s.nodes.size(), links);
    if (order.on_cycle) {
        const Node& node = s.nodes[*order.on_cycle];
        return v.error(node.from, label("node", *order.on_cycle, node.name).text() + " is a part of itself", "a node may have many parents, but none of its descendants");
    }
    const std::vector<bool> drawn = leads_to_shape(s, order.sequence);
    for (size_t i = 0; i < s.nodes.size(); ++i) {
        const Node& node = s.nodes[i];
        if (drawn[i] && !node.to_parent.is_identity() && !inverse(node.to_parent)) {
            const char* fault = node.to_parent.is_finite() ? "cannot be inverted" : "is not finite";
            v.warning(node.from, fmt::format("{} has a transform that {}: it and all below it are left out", label("node", i, node.name).text(), fault),
                      node.to_parent.is_finite() ? "a scale of 0 along an axis flattens everything" : "");
        }
    }
}

}  // namespace alidade
