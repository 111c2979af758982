// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/node_facts.h"

#include "exporters/pov/shapes.h"
#include "scene/graph.h"

namespace alidade::pov_export {

namespace {

/// Blocks in blocks; what lies deeper is declared.
constexpr uint32_t kDeepest = 40;

/// POV-Ray changes a transformation that makes things as flat as that.
bool is_flat(const Transform& t) {
    constexpr double kSmallest = 1e-10;
    for (int i = 0; i < 3; ++i)
        if (!(std::max({std::abs(t.linear[0][i]), std::abs(t.linear[1][i]), std::abs(t.linear[2][i])}) >= kSmallest)) return true;
    return !inverse(t);
}

}  // namespace

NodeFacts::NodeFacts(const Scene& scene, Losses& losses) : scene_(scene), facts_(scene.nodes.size()) {
    for (const ShapeEntry& shape : scene.shapes) seen_shapes_.push_back(can_be_seen(shape.geometry));
    reach();
    for (auto i = order_.rbegin(); i != order_.rend(); ++i) study(*i);
    count_shapes();
    size_t without = 0, flat = 0, hidden = 0;
    for (const uint32_t i : order_) {
        const Node& node = scene.nodes[i];
        if (const auto* shape = std::get_if<ShapeId>(&node.what)) without += !seen_shapes_[shape->index];
        if (!draws_shape(node) && material_counts(node)) defaults_at_shapes_ = false;
        flat += is_flat(node.to_parent), hidden += !node.flags.visible;
    }
    if (std::none_of(scene.roots.begin(), scene.roots.end(), [&](NodeId root) { return is_bare(root); })) defaults_at_shapes_ = false;
    losses.add("shapes without extent", without);
    losses.add("nodes whose transformation is flat, not finite or smaller than 1e-10", flat);
    losses.add("hidden nodes", hidden);
}

void NodeFacts::reach() {
    std::vector<bool> reached(scene_.nodes.size());
    std::vector<NodeId> open;
    const auto refer = [&](NodeId id) {
        ++facts_[id.index].parents;
        if (!reached[id.index]) reached[id.index] = true, open.push_back(id);
    };
    for (const NodeId root : scene_.roots) refer(root);
    while (!open.empty()) {
        const Node& node = scene_.nodes[open.back().index];
        open.pop_back();
        if (node.flags.visible) for_each_link(scene_, node, refer);
    }
    const auto links = [&](uint32_t i, const auto& f) { for_each_link(scene_, scene_.nodes[i], [&](NodeId id) { f(id.index); }); };
    for (const uint32_t i : topological_order(scene_.nodes.size(), links).sequence)
        if (reached[i]) order_.push_back(i);
}

bool NodeFacts::draws_shape(const Node& node) const {
    const auto* shape = std::get_if<ShapeId>(&node.what);
    return shape && seen_shapes_[shape->index];
}

bool NodeFacts::draws_light(const Node& node) const {
    const auto* light = std::get_if<LightId>(&node.what);
    return light && !std::holds_alternative<DirectionalLight>(scene_.lights[light->index].kind);
}

/// An intersection with nothing is nothing, and so is what is left of nothing.
bool NodeFacts::has_nothing(const Node& node) const {
    if (!node.flags.visible || is_flat(node.to_parent)) return true;
    const auto nothing = [&](NodeId id) { return facts_[id.index].empty; };
    const std::vector<NodeId>& parts = node.children;
    if (node.csg == CsgKind::intersection && std::any_of(parts.begin(), parts.end(), nothing)) return true;
    if (node.csg == CsgKind::difference && !parts.empty() && nothing(parts.front())) return true;
    return !draws_shape(node) && !draws_light(node) && std::all_of(parts.begin(), parts.end(), nothing);
}

void NodeFacts::study(uint32_t index) {
    const Node& node = scene_.nodes[index];
    Fact& f = facts_[index];
    f.empty = has_nothing(node);
    f.bare = (node.materials.empty() || !node.materials[0]) && draws_shape(node);
    for (const NodeId child : node.children)
        if (node.materials.empty() || !node.materials[0]) f.bare = f.bare || facts_[child.index].bare;
    f.lays_open = node.cutaway_textures || std::any_of(node.children.begin(), node.children.end(), [&](NodeId id) { return facts_[id.index].lays_open; });
    for_each_link(scene_, node, [&](NodeId id) { f.height = std::max(f.height, facts_[id.index].height); });
    ++f.height;
    f.declared = !f.empty && (f.parents > 1 || f.height >= kDeepest || node.open_light_group);
    if (f.empty) f.bare = false;
    if (f.declared || f.empty) f.height = 0;
}

bool NodeFacts::material_counts(const Node& node) const {
    if (node.materials.empty() || !node.materials[0]) return false;
    return draws_shape(node) || node.inside_material || std::any_of(node.children.begin(), node.children.end(), [&](NodeId id) { return facts_[id.index].bare; });
}

std::vector<NodeId> NodeFacts::roots() const {
    std::vector<NodeId> out;
    std::copy_if(scene_.roots.begin(), scene_.roots.end(), std::back_inserter(out), [&](NodeId id) { return !is_empty(id); });
    return out;
}

std::vector<NodeId> NodeFacts::children(const Node& node) const {
    std::vector<NodeId> out;
    std::copy_if(node.children.begin(), node.children.end(), std::back_inserter(out), [&](NodeId id) { return !is_empty(id); });
    return out;
}

/// A mesh of several slots whose node names no more than one material takes that, or what it inherits, for all.
NodeFacts::ShapeKey NodeFacts::key_of(const Node& node, ShapeId shape) const {
    ShapeKey key{shape.index, node.materials, node.flags.uv_mapping};
    key.slots.resize(node.materials.size() < 2 ? 1 : slot_count(scene_.shapes[shape.index].geometry));
    return key;
}

void NodeFacts::count_shapes() {
    for (const uint32_t i : order_) {
        const Node& node = scene_.nodes[i];
        if (facts_[i].empty || !draws_shape(node)) continue;
        const ShapeId shape = std::get<ShapeId>(node.what);
        if (++uses_[key_of(node, shape)] == 1) ++variants_[shape.index];
    }
}

std::vector<bool> NodeFacts::used_materials() const {
    std::vector<bool> used(scene_.materials.size());
    for (const uint32_t i : order_) {
        const Node& node = scene_.nodes[i];
        if (facts_[i].empty) continue;
        if (material_counts(node)) used[node.materials[0]->index] = true;
        if (node.inside_material) used[node.inside_material->index] = true;
        if (!draws_shape(node)) continue;
        for (const auto& slot : key_of(node, std::get<ShapeId>(node.what)).slots)
            if (slot) used[slot->index] = true;
    }
    return used;
}

bool NodeFacts::needs_default() const {
    for (const NodeId root : scene_.roots)
        if (is_bare(root)) return true;
    for (const auto& [key, count] : uses_)
        for (size_t i = 1; i < key.slots.size(); ++i)
            if (!key.slots[i]) return true;
    return false;
}

}  // namespace alidade::pov_export
