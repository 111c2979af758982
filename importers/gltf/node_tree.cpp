// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/node_tree.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace alidade::gltf {

namespace {

constexpr size_t kNone = ~size_t(0);

std::vector<size_t> find_parents(const Json& nodes, Reporter& report) {
    std::vector<size_t> parent(nodes.size(), kNone);
    for (size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes[i].find("children");
        if (children == nodes[i].end()) continue;
        for (size_t k = 0; k < children->size(); ++k) {
            const auto c = (*children)[k].get<size_t>();
            if (parent[c] == kNone) parent[c] = i;
            else if (parent[c] != i)
                report.error(child(child(child("/nodes", i), "children"), k), fmt::format("node {} is already a child of node {}", c, parent[c]));
        }
    }
    return parent;
}

/// With one parent at the most, a cycle is a walk upwards that meets itself. Nodes seen on an earlier walk need no second one.
void check_cycles(const std::vector<size_t>& parent, Reporter& report) {
    std::vector<size_t> seen_on_walk(parent.size(), kNone);
    for (size_t start = 0; start < parent.size(); ++start) {
        size_t node = start;
        while (node != kNone && seen_on_walk[node] == kNone) seen_on_walk[node] = start, node = parent[node];
        if (node != kNone && seen_on_walk[node] == start) report.error(child("/nodes", node), "the node is its own ancestor");
    }
}

void check_scene_roots(const Json& root, const std::vector<size_t>& parent, Reporter& report) {
    const auto scenes = root.find("scenes");
    if (scenes == root.end()) return;
    for (size_t s = 0; s < scenes->size(); ++s) {
        const auto nodes = (*scenes)[s].find("nodes");
        if (nodes == (*scenes)[s].end()) continue;
        for (size_t k = 0; k < nodes->size(); ++k) {
            const auto node = (*nodes)[k].get<size_t>();
            if (parent[node] != kNone)
                report.error(child(child(child("/scenes", s), "nodes"), k),
                             fmt::format("node {} is not a root: it is a child of node {}", node, parent[node]));
        }
    }
}

void check_combinations(const Json& nodes, Reporter& report) {
    for (size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].contains("matrix") && (nodes[i].contains("translation") || nodes[i].contains("rotation") || nodes[i].contains("scale")))
            report.warning(child("/nodes", i), "the node has a matrix: its other transforms are ignored");
        if (nodes[i].contains("mesh")) continue;
        for (const char* dependent : {"skin", "weights"})
            if (nodes[i].contains(dependent))
                report.error(child("/nodes", i), fmt::format("property \"{}\" needs a mesh, and the node has none", dependent));
    }
}

}  // namespace

void check_node_tree(const Json& root, Reporter& report) {
    const auto nodes = root.find("nodes");
    if (nodes == root.end()) return;
    const std::vector<size_t> parent = find_parents(*nodes, report);
    check_cycles(parent, report);
    check_scene_roots(root, parent, report);
    check_combinations(*nodes, report);
}

}  // namespace alidade::gltf
