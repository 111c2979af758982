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

/// By mesh with joints: the largest joint that any vertex names.
std::vector<uint32_t> largest_joints(const Scene& scene) {
    std::vector<uint32_t> out;
    for (const ShapeEntry& shape : scene.shapes) {
        uint32_t largest = 0;
        if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) {
            for (const Joints4& j : mesh->joints.values) largest = std::max({largest, uint32_t(j.x), uint32_t(j.y), uint32_t(j.z), uint32_t(j.w)});
        }
        out.push_back(largest);
    }
    return out;
}

void check_deformation(Validation& v, const Node& node, const Label& who, const std::vector<uint32_t>& largest_joint) {
    const ShapeId* shape = std::get_if<ShapeId>(&node.what);
    const Mesh* mesh = shape ? std::get_if<Mesh>(&v.scene.shapes[shape->index].geometry) : nullptr;
    const size_t targets = mesh ? mesh->morphs.size() : 0;
    if (!node.morph_weights.empty() && node.morph_weights.size() != targets)
        v.error(node.from, fmt::format("{} has {} morph weights for {} morph targets", who.text(), node.morph_weights.size(), targets));
    if (!node.skin || !mesh || !mesh->joints.present()) return;
    const size_t joints = v.scene.skins[node.skin->index].joints.size();
    const uint32_t largest = largest_joint[shape->index];
    if (largest >= joints) v.error(node.from, fmt::format("{} has a mesh that names joint {}, but its skin has {}", who.text(), largest, joints));
}

void check_skins(Validation& v) {
    for (size_t i = 0; i < v.scene.skins.size(); ++i) {
        const Skin& skin = v.scene.skins[i];
        const Label who = label("skin", i, skin.name);
        if (!skin.inverse_bind.empty() && skin.inverse_bind.size() != skin.joints.size())
            v.error({}, fmt::format("{} has {} inverse bind matrices for {} joints", who.text(), skin.inverse_bind.size(), skin.joints.size()));
        for (const Transform& t : skin.inverse_bind)
            if (!t.is_finite()) return v.error({}, who.text() + " has an inverse bind matrix that is not finite");
    }
}

}  // namespace

void check_graph(Validation& v) {
    const Scene& s = v.scene;
    check_skins(v);
    const auto links = [&](uint32_t i, const auto& f) { for_each_link(s, s.nodes[i], [&](NodeId id) { f(id.index); }); };
    const TopologicalOrder order = topological_order(s.nodes.size(), links);
    if (order.on_cycle) {
        const Node& node = s.nodes[*order.on_cycle];
        return v.error(node.from, label("node", *order.on_cycle, node.name).text() + " is a part of itself", "a node may have many parents, but none of its descendants");
    }
    const std::vector<bool> drawn = leads_to_shape(s, order.sequence);
    const std::vector<uint32_t> largest_joint = largest_joints(s);
    for (size_t i = 0; i < s.nodes.size(); ++i) {
        const Node& node = s.nodes[i];
        if (drawn[i] && !inverse(node.to_parent)) {
            const char* fault = node.to_parent.is_finite() ? "cannot be inverted" : "is not finite";
            v.warning(node.from, fmt::format("{} has a transform that {}: it and all below it are left out", label("node", i, node.name).text(), fault),
                      node.to_parent.is_finite() ? "a scale of 0 along an axis flattens everything" : "");
        }
        check_deformation(v, node, label("node", i, node.name), largest_joint);
    }
}

}  // namespace alidade
