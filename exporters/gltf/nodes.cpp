// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/nodes.h"

#include "scene/graph.h"

#include <fmt/format.h>

namespace alidade::gltf_export {

namespace {

/// A chain of nodes with two references each doubles with every link: thirty are a billion.
constexpr size_t kMostNodes = 10'000'000;

Json matrix(const Transform& t) {
    Json out = Json::array();
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) out.push_back(t.linear[column][row]);
        out.push_back(0);
    }
    for (int row = 0; row < 3; ++row) out.push_back(t.translation[row]);
    out.push_back(1);
    return out;
}

/// glTF's matrices must be products of a translation, a rotation and scales: the columns are orthogonal.
bool is_sheared(const Mat3& m) {
    constexpr double kTolerance = 1e-6;
    for (int i = 0; i < 3; ++i) {
        const Vec3 a = m[i], b = m[(i + 1) % 3];
        if (std::abs(dot(a, b)) > kTolerance * length(a) * length(b)) return true;
    }
    return false;
}

void put_transform(const Node& node, Json& json, Losses& losses) {
    if (!node.trs) {
        if (!node.to_parent.is_finite()) return losses.add("transforms that are not finite", 1, "none");
        losses.add("sheared transforms", is_sheared(node.to_parent.linear), "matrices that some programs refuse");
        if (!node.to_parent.is_identity()) json["matrix"] = matrix(node.to_parent);
        return;
    }
    const Trs usual, &trs = *node.trs;
    if (!trs.transform().is_finite()) return losses.add("transforms that are not finite", 1, "none");
    set(json, "translation", trs.translation, usual.translation);
    const double norm = std::sqrt(dot(trs.rotation, trs.rotation));
    if (norm > 0) set(json, "rotation", trs.rotation / norm, usual.rotation);
    set(json, "scale", trs.scale, usual.scale);
}

/// How many nodes there are if each path from `tops` gets its own; more than kMostNodes if there are more.
size_t count_paths(const Scene& scene, const std::vector<NodeId>& tops) {
    const auto children = [&](uint32_t i, const auto& f) {
        for (const NodeId child : scene.nodes[i].children) f(child.index);
    };
    std::vector<size_t> paths(scene.nodes.size());
    for (const NodeId top : tops) ++paths[top.index];
    size_t sum = 0;
    for (const uint32_t i : topological_order(scene.nodes.size(), children).sequence) {
        sum += paths[i];
        if (sum > kMostNodes) break;
        children(i, [&](uint32_t child) { paths[child] += paths[i]; });
    }
    return sum;
}

}  // namespace

/// The roots; and the nodes that nothing refers to, which may be another scene of the file.
std::vector<NodeId> NodeWriter::tops() const {
    std::vector<bool> referred(scene_.nodes.size());
    for (const NodeId root : scene_.roots) referred[root.index] = true;
    for (const Node& node : scene_.nodes) for_each_link(scene_, node, [&](NodeId id) { referred[id.index] = true; });
    std::vector<NodeId> out = scene_.roots;
    for (uint32_t i = 0; i < scene_.nodes.size(); ++i)
        if (!referred[i]) out.push_back({i});
    return out;
}

/// Nodes that children lead to from the tops, in the scene's order.
void NodeWriter::number(const std::vector<NodeId>& tops) {
    std::vector<bool> reached(scene_.nodes.size());
    std::vector<NodeId> open;
    const auto reach = [&](NodeId id) {
        if (!reached[id.index]) reached[id.index] = true, open.push_back(id);
    };
    for (const NodeId top : tops) reach(top);
    for (const Skin& skin : scene_.skins)
        for (const NodeId joint : skin.joints) reach(joint);   // a skin must be able to name them
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        for (const NodeId child : scene_.nodes[id.index].children) reach(child);
    }
    written_.node.resize(reached.size()), written_.carrier.resize(reached.size()), written_.copied.resize(reached.size());
    used_.resize(reached.size());
    size_t count = 0;
    for (size_t i = 0; i < reached.size(); ++i)
        if (reached[i]) written_.node[i] = count++;
    nodes_.resize(count, Json::object());
}

size_t NodeWriter::place(NodeId id, std::optional<MaterialId> inherited) {
    size_t index = *written_.node[id.index];
    if (used_[id.index]) {
        losses_.add("nodes with several parents", !written_.copied[id.index], "copies that share their meshes");
        written_.copied[id.index] = true;
        index = nodes_.size();
        nodes_.push_back(Json::object());
    }
    used_[id.index] = true;
    tasks_.push_back({id, index, inherited});
    return index;
}

size_t NodeWriter::add_child(Json& parent, Json child) {
    nodes_.push_back(std::move(child));
    parent["children"].push_back(nodes_.size() - 1);
    return nodes_.size() - 1;
}

SlotMaterials NodeWriter::materials(const Node& node, ShapeId shape, std::optional<MaterialId> inherited) const {
    SlotMaterials out = node.materials;
    out.resize(slot_count(scene_.shapes[shape.index].geometry));
    for (auto& slot : out)
        if (!slot) slot = inherited;
    return out;
}

void NodeWriter::put_shape(const Task& task, ShapeId shape, Json& json) {
    const Node& node = scene_.nodes[task.id.index];
    const auto* geometry = std::get_if<Mesh>(&scene_.shapes[shape.index].geometry);
    const bool skinned = node.skin && geometry && !geometry->joint_sets.empty();
    const auto mesh = meshes_.add(shape, materials(node, shape, task.inherited), skinned);
    if (!mesh) return;
    Json own = {{"mesh", *mesh}};
    if (skinned) own["skin"] = node.skin->index;
    if (!node.morph_weights.empty()) own["weights"] = node.morph_weights;
    size_t carrier = task.index;
    if (geometry->origin != Vec3(0) && !skinned) {
        own["translation"] = array(geometry->origin);
        carrier = add_child(json, std::move(own));
    } else {
        json.update(own);
    }
    if (!written_.carrier[task.id.index]) written_.carrier[task.id.index] = carrier;
}

void NodeWriter::write_node(const Task& task) {
    const Node& node = scene_.nodes[task.id.index];
    Json json = Json::object();
    set(json, "name", node.name, std::string());
    put_transform(node, json, losses_);
    std::optional<MaterialId> inherited = task.inherited;
    if (!node.materials.empty() && node.materials[0]) inherited = node.materials[0];
    for (const NodeId child : node.children) json["children"].push_back(place(child, inherited));
    if (const auto* shape = std::get_if<ShapeId>(&node.what)) put_shape(task, *shape, json);
    if (const auto* light = std::get_if<LightId>(&node.what))
        if (const auto index = lights_.add(*light)) document_.use(json, "KHR_lights_punctual")["light"] = *index;
    if (const auto* camera = std::get_if<CameraId>(&node.what)) {
        const auto written = cameras_.add(*camera);
        if (written && written->to_node.is_identity()) json["camera"] = written->index;
        else if (written) add_child(json, {{"matrix", matrix(written->to_node)}, {"camera", written->index}});
    }
    if (!node.flags.visible) document_.use(json, "KHR_node_visibility")["visible"] = false;
    nodes_[task.index] = std::move(json);
}

tl::expected<WrittenNodes, std::string> NodeWriter::write() {
    const std::vector<NodeId> all = tops();
    if (count_paths(scene_, all) > kMostNodes)
        return tl::unexpected(fmt::format("the scene leads to its nodes by more than {} paths, and glTF needs a node for each", kMostNodes));
    number(all);
    // In the scene's order, whatever the order of the nodes.
    for (uint32_t i = 0; i < scene_.lights.size(); ++i) lights_.add({i});
    for (uint32_t i = 0; i < scene_.cameras.size(); ++i) cameras_.add({i});
    Json roots = Json::array();
    for (size_t i = 0; i < all.size(); ++i) {
        const size_t index = place(all[i], std::nullopt);
        if (i < scene_.roots.size()) roots.push_back(index);
    }
    while (!tasks_.empty()) {
        const Task task = tasks_.back();
        tasks_.pop_back();
        write_node(task);
    }
    if (!nodes_.empty()) document_.root["nodes"] = std::move(nodes_);
    document_.root["scene"] = 0;
    Json only = Json::object();
    if (!roots.empty()) only["nodes"] = std::move(roots);
    document_.root["scenes"] = Json::array({std::move(only)});
    return std::move(written_);
}

}  // namespace alidade::gltf_export
