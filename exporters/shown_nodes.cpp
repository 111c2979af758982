// SPDX-License-Identifier: Apache-2.0
#include "exporters/shown_nodes.h"

namespace alidade {

void visit_shown_nodes(const Scene& scene, const std::function<bool(NodeId, const Transform&)>& f) {
    std::vector<bool> seen(scene.nodes.size());
    std::vector<std::pair<NodeId, Transform>> open;
    for (auto root = scene.roots.rbegin(); root != scene.roots.rend(); ++root) open.emplace_back(*root, Transform());
    while (!open.empty()) {
        const auto [id, above] = open.back();
        open.pop_back();
        const Node& node = scene.nodes[id.index];
        if (seen[id.index] || !node.flags.visible) continue;
        seen[id.index] = true;
        const Transform to_world = above * node.to_parent;
        if (!f(id, to_world)) continue;
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) open.emplace_back(*child, to_world);
    }
}

}  // namespace alidade
