// SPDX-License-Identifier: Apache-2.0
#include "scene/validation.h"

#include <set>
#include <tuple>

namespace alidade {

namespace {

/// Vertices that deform() may make in any case, and for each vertex that the meshes have: a small file must not cost gigabytes.
constexpr uint64_t kFreeVertices = uint64_t(1) << 24, kCopies = 16;

/// By mesh with joints: the largest joint that any vertex names.
std::vector<uint32_t> largest_joints(const Scene& scene) {
    std::vector<uint32_t> out;
    for (const ShapeEntry& shape : scene.shapes) {
        uint32_t largest = 0;
        if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) {
            for (const JointSet& set : mesh->joint_sets)
                for (const Joints4& j : set.joints) largest = std::max({largest, uint32_t(j.x), uint32_t(j.y), uint32_t(j.z), uint32_t(j.w)});
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
    if (!std::all_of(node.morph_weights.begin(), node.morph_weights.end(), [](double w) { return std::isfinite(w); }))
        v.error(node.from, who.text() + " has a morph weight that is not finite");
    if (!node.skin || !mesh || mesh->joint_sets.empty()) return;
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

/// By node: does an animation change its morph weights?
std::vector<bool> animated_weights(const Scene& scene) {
    std::vector<bool> out(scene.nodes.size());
    for (const Animation& animation : scene.animations)
        for (const Channel& channel : animation.channels)
            if (channel.path == ChannelPath::weights) out[channel.target.index] = true;
    return out;
}

void check_size(Validation& v) {
    const Scene& s = v.scene;
    uint64_t allowed = kFreeVertices, needed = 0;
    for (const ShapeEntry& shape : s.shapes)
        if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) allowed += kCopies * mesh->positions.size();
    const std::vector<bool> animated = animated_weights(s);
    std::set<std::tuple<ShapeId, std::optional<SkinId>, std::vector<double>, uint32_t>> counted;
    for (uint32_t i = 0; i < s.nodes.size(); ++i) {
        const Node& node = s.nodes[i];
        const ShapeId* shape = std::get_if<ShapeId>(&node.what);
        if (!shape || (!node.skin && node.morph_weights.empty() && !animated[i])) continue;
        if (!counted.emplace(*shape, node.skin, node.morph_weights, animated[i] ? i : 0).second) continue;
        const Mesh* mesh = std::get_if<Mesh>(&s.shapes[shape->index].geometry);
        if (mesh) needed += mesh->positions.size();
        if (needed > allowed)
            return v.error(node.from, fmt::format("skins and morph weights ask for deformed copies of meshes with more than {} vertices in all", allowed));
    }
}

}  // namespace

void check_deformations(Validation& v) {
    check_skins(v);
    const std::vector<uint32_t> largest_joint = largest_joints(v.scene);
    for (size_t i = 0; i < v.scene.nodes.size(); ++i) check_deformation(v, v.scene.nodes[i], label("node", i, v.scene.nodes[i].name), largest_joint);
    check_size(v);
}

}  // namespace alidade
