// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"

#include "scene/graph.h"

#include <algorithm>

namespace alidade {

namespace {

struct Frame {
    Transform to_world;
    size_t entered = 0;        ///< how many of its children
    bool last_first = false;
};

/// The paths below one root; false if the visitor ended the walk. The stack is explicit: its depth is the file's choice.
bool visit_below(const Scene& scene, NodeId root, const std::function<bool(const Visit&)>& visitor, SiblingOrder order) {
    Visit visit;
    std::vector<Frame> frames;
    auto enter = [&](NodeId id, const Transform& parent_to_world) {
        const Node& node = scene.nodes[id.index];
        if (!node.flags.visible) return true;
        visit.node = id;
        visit.to_world = parent_to_world * node.to_parent;
        visit.path.push_back(id);
        frames.push_back({visit.to_world, 0, order == SiblingOrder::seen_first && (node.whole || (!frames.empty() && frames.back().last_first))});
        return visitor(visit);
    };
    if (!enter(root, Transform())) return false;
    while (!frames.empty()) {
        Frame& frame = frames.back();
        const std::vector<NodeId>& children = scene.nodes[visit.path.back().index].children;
        if (frame.entered == children.size()) {
            frames.pop_back();
            visit.path.pop_back();
            continue;
        }
        const Transform to_world = frame.to_world;   // a copy: entering a child may move the frames
        const size_t i = frame.entered++;
        if (!enter(children[frame.last_first ? children.size() - 1 - i : i], to_world)) return false;
    }
    return true;
}

}  // namespace

void visit_paths(const Scene& scene, const std::function<bool(const Visit&)>& visitor, SiblingOrder order) {
    for (const NodeId root : scene.roots)
        if (!visit_below(scene, root, visitor, order)) return;
}

std::vector<double> path_counts(const Scene& scene) {
    const auto children = [&](uint32_t i, const auto& f) {
        for (const NodeId child : scene.nodes[i].children) f(child.index);
        for (const NodeId clip : scene.nodes[i].clips) f(clip.index);
        for (const NodeId bound : scene.nodes[i].bounds) f(bound.index);
    };
    std::vector<double> below(scene.nodes.size(), 0);   // paths that begin at the node
    const std::vector<uint32_t> order = topological_order(scene.nodes.size(), children).sequence;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        if (!scene.nodes[*i].flags.visible) continue;
        below[*i] = 1;
        children(*i, [&](uint32_t child) { below[*i] += below[child]; });
    }
    return below;
}

double path_count(const Scene& scene) {
    const std::vector<double> below = path_counts(scene);
    double all = 0;
    for (const NodeId root : scene.roots) all += below[root.index];
    return all;
}

void collect_signals(const Scene& scene, SignalId root, std::vector<SignalId>& out) {
    std::vector<SignalId> todo{root};
    std::vector<bool> seen(scene.signals.size());
    while (!todo.empty()) {
        const SignalId id = todo.back();
        todo.pop_back();
        if (seen[id.index]) continue;
        seen[id.index] = true;
        out.push_back(id);
        for_each_operand(scene, scene.signals[id.index], [&](SignalId operand) { todo.push_back(operand); });
    }
}

bool lets_light_through(const Scene& scene, SignalId root) {
    std::vector<SignalId> read;
    collect_signals(scene, root, read);
    return std::any_of(read.begin(), read.end(), [&](SignalId id) {
        const auto& what = scene.signals[id.index].what;
        const auto* constant = std::get_if<ConstantSignal>(&what);
        const auto* pattern = std::get_if<PatternSignal>(&what);
        if (pattern && pattern->picture && pattern->pattern == kImageMap) return true;
        return constant ? constant->filter != 0 || constant->transmit != 0 : std::holds_alternative<ImageSignal>(what);
    });
}

std::optional<CarriedMaterial> carried_material(const Scene& scene, const std::vector<NodeId>& path, uint32_t slot) {
    for (size_t i = path.size(); i-- > 0;) {
        const auto& materials = scene.nodes[path[i].index].materials;
        const size_t at = i + 1 == path.size() ? slot : 0;
        if (at < materials.size() && materials[at]) return CarriedMaterial{*materials[at], i};
    }
    return std::nullopt;
}

std::optional<CarriedMaterial> carried_inside_material(const Scene& scene, const std::vector<NodeId>& path) {
    for (size_t i = path.size(); i-- > 0;)
        if (const auto& inside = scene.nodes[path[i].index].inside_material) return CarriedMaterial{*inside, i};
    return std::nullopt;
}

std::optional<MaterialId> inherited_material(const Scene& scene, const std::vector<NodeId>& path, uint32_t slot) {
    const auto carried = carried_material(scene, path, slot);
    return carried ? std::optional(carried->material) : std::nullopt;
}

}  // namespace alidade
