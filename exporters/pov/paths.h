// SPDX-License-Identifier: Apache-2.0
/// Walks to the few nodes of a graph that hold something rare, however many paths it has.
#pragma once

#include "scene/graph.h"

namespace alidade::pov_export {

/// Calls f(node, to_world) for each path from a root, through visible nodes, to a node that `wanted(node)`, in document order; at most `most` times. Returns
/// whether that was all. Parts of the graph that lead to none are not entered.
template <class Wanted, class F> bool for_each_path(const Scene& scene, const Wanted& wanted, size_t most, const F& f) {
    const auto children = [&](uint32_t i, const auto& g) {
        for (const NodeId child : scene.nodes[i].children) g(child.index);
    };
    std::vector<bool> leads(scene.nodes.size());
    const std::vector<uint32_t> order = topological_order(scene.nodes.size(), children).sequence;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Node& node = scene.nodes[*i];
        bool here = wanted(node);
        children(*i, [&](uint32_t child) { here = here || leads[child]; });
        leads[*i] = here && node.flags.visible;
    }
    std::vector<std::pair<NodeId, Transform>> open;
    for (auto root = scene.roots.rbegin(); root != scene.roots.rend(); ++root)
        if (leads[root->index]) open.push_back({*root, scene.nodes[root->index].to_parent});
    while (!open.empty()) {
        const auto [id, to_world] = open.back();
        open.pop_back();
        const Node& node = scene.nodes[id.index];
        if (wanted(node)) {
            if (most-- == 0) return false;
            f(node, to_world);
        }
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            if (leads[child->index]) open.push_back({*child, to_world * scene.nodes[child->index].to_parent});
    }
    return true;
}

}  // namespace alidade::pov_export
