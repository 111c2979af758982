// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/nodes.h"

#include "importers/gltf/instancing.h"
#include "importers/gltf/values.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

/// Quaternions that are farther than this from unit length are worth a warning: float rounding leaves less.
constexpr double kUnitTolerance = 5e-4;

Transform from_matrix(const std::vector<double>& m, const std::string& at, Reporter& report) {
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) report.warning(child(at, "matrix"), "the last row is not 0, 0, 0, 1: it is ignored");
    return {Mat3(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]), Vec3(m[12], m[13], m[14])};
}

Vec4 unit_rotation(const std::vector<double>& q, const std::string& at, Reporter& report) {
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(norm > 0) || !std::isfinite(norm)) {
        report.warning(child(at, "rotation"), "the quaternion has no direction: no rotation is used");
        return {0, 0, 0, 1};
    }
    if (std::abs(norm - 1) > kUnitTolerance)
        report.warning(child(at, "rotation"), fmt::format("the quaternion has length {:.4g}: it is normalised", norm));
    return Vec4(q[0], q[1], q[2], q[3]) / norm;
}

Trs read_trs(const tinygltf::Node& from, const std::string& at, Reporter& report) {
    Trs trs;
    const auto &t = from.translation, &s = from.scale;
    if (t.size() == 3) trs.translation = Vec3(t[0], t[1], t[2]);
    if (s.size() == 3) trs.scale = Vec3(s[0], s[1], s[2]);
    if (from.rotation.size() == 4) trs.rotation = unit_rotation(from.rotation, at, report);
    return trs;
}

/// One thing that a glTF node holds, as a node of ours holds it.
struct Held {
    decltype(Node::what) what;
    std::vector<std::optional<MaterialId>> materials;
};

class NodeConverter {
  public:
    NodeConverter(const Model& model, const std::vector<std::vector<MeshPart>>& meshes, const std::vector<std::optional<LightId>>& lights,
                  Scene& scene, Reporter& report)
        : model_(model), meshes_(meshes), lights_(lights), scene_(scene), report_(report) {}

    ShapeNodes convert() {
        for (size_t i = 0; i < model_.nodes.size(); ++i) scene_.nodes.push_back(convert_node(model_.nodes[i], child("/nodes", i)));
        ShapeNodes shape_nodes;
        for (size_t i = 0; i < model_.nodes.size(); ++i) shape_nodes.push_back(attach(i));
        return shape_nodes;
    }

  private:
    Node convert_node(const tinygltf::Node& from, const std::string& at) {
        Node node;
        node.name = from.name;
        node.from = report_.at(at);
        if (from.matrix.size() == 16) {
            node.to_parent = from_matrix(from.matrix, at, report_);
        } else {
            node.trs = read_trs(from, at, report_);
            node.to_parent = node.trs->transform();
        }
        for (const int c : from.children) node.children.push_back(NodeId{uint32_t(c)});
        if (const auto* e = extension_of(from, "KHR_node_visibility"); e && e->Has("visible")) node.flags.visible = e->Get("visible").Get<bool>();
        return node;
    }

    std::vector<Held> held_by(const tinygltf::Node& from) {
        std::vector<Held> held;
        if (from.mesh >= 0)
            for (const MeshPart& part : meshes_[size_t(from.mesh)]) held.push_back({part.shape, part.materials});
        if (const auto* e = extension_of(from, "KHR_lights_punctual"))
            if (const auto light = lights_[size_t(number_in(*e, "light", 0))]) held.push_back({*light, {}});
        if (from.camera >= 0) held.push_back({CameraId{uint32_t(from.camera)}, {}});
        return held;
    }

    void put(const Held& held, const tinygltf::Node& from, Node& node) {
        node.what = held.what;
        node.materials = held.materials;
        if (auto* camera = std::get_if<CameraId>(&node.what); camera && scene_.cameras[camera->index].name.empty())
            scene_.cameras[camera->index].name = from.name;
        if (!std::holds_alternative<ShapeId>(node.what)) return;
        if (from.skin >= 0) node.skin = SkinId{uint32_t(from.skin)};
        node.morph_weights = from.weights;
        const auto& mesh = std::get<Mesh>(scene_.shapes[std::get<ShapeId>(node.what).index].geometry);
        if (node.morph_weights.empty() || node.morph_weights.size() == mesh.morphs.size()) return;
        report_.warning(child(node.from.pointer, "weights"),
                        fmt::format("{} weights for {} morph targets", node.morph_weights.size(), mesh.morphs.size()));
        node.morph_weights.resize(mesh.morphs.size());
    }

    /// A node that the file does not have, made for the one at `index`.
    NodeId add_node(size_t index, const std::string& name) {
        Node extra;
        extra.name = name;
        extra.from = scene_.nodes[index].from;
        scene_.nodes.push_back(std::move(extra));
        return NodeId{uint32_t(scene_.nodes.size() - 1)};
    }

    /// Gives the node what it holds; returns the nodes that hold its shapes. Instances are children that share these.
    std::vector<NodeId> attach(size_t index) {
        const tinygltf::Node& from = model_.nodes[index];
        const std::vector<Held> held = held_by(from);
        const auto instances = from.mesh >= 0 ? read_instances(model_, from, child("/nodes", index), report_) : std::nullopt;
        // In the scene graph materials are inherited; in glTF a mesh keeps its own for itself.
        const bool apart = held.size() > 1 || (from.mesh >= 0 && !from.children.empty());
        std::vector<NodeId> with_shapes;
        for (const Held& h : held) {
            const bool is_shape = std::holds_alternative<ShapeId>(h.what), instanced = instances && is_shape;
            NodeId id{uint32_t(index)};
            if (apart || instanced) id = add_node(index, from.name);
            if (apart && !instanced) scene_.nodes[index].children.push_back(id);
            put(h, from, scene_.nodes[id.index]);
            if (is_shape) with_shapes.push_back(id);
        }
        if (!instances || with_shapes.empty()) return with_shapes;
        for (const Transform& transform : *instances) {
            const NodeId id = add_node(index, "");
            scene_.nodes[id.index].to_parent = transform;
            scene_.nodes[id.index].children = with_shapes;
            scene_.nodes[index].children.push_back(id);
        }
        return with_shapes;
    }

    const Model& model_;
    const std::vector<std::vector<MeshPart>>& meshes_;
    const std::vector<std::optional<LightId>>& lights_;
    Scene& scene_;
    Reporter& report_;
};

/// The nodes of the file's scene; of its first one if it names none; without scenes, all that are nobody's child.
std::vector<NodeId> find_roots(const Model& model, Reporter& report) {
    std::vector<NodeId> roots;
    if (!model.scenes.empty()) {
        const size_t chosen = model.defaultScene >= 0 ? size_t(model.defaultScene) : 0;
        if (model.defaultScene < 0 && model.scenes.size() > 1)
            report.note("/scenes", fmt::format("the file does not say which of its {} scenes to show: the first is used", model.scenes.size()));
        for (const int n : model.scenes[chosen].nodes) roots.push_back(NodeId{uint32_t(n)});
        return roots;
    }
    std::vector<bool> is_child(model.nodes.size());
    for (const tinygltf::Node& n : model.nodes)
        for (const int c : n.children) is_child[size_t(c)] = true;
    for (size_t i = 0; i < model.nodes.size(); ++i)
        if (!is_child[i]) roots.push_back(NodeId{uint32_t(i)});
    if (!roots.empty()) report.note("", "the file has no scenes: all nodes are shown");
    return roots;
}

bool read_inverse_bind(const Model& model, const tinygltf::Skin& from, const std::string& at, Skin& skin, Reporter& report) {
    if (from.inverseBindMatrices < 0) return true;
    const tinygltf::Accessor& accessor = model.accessors[size_t(from.inverseBindMatrices)];
    const std::string where = child(at, "inverseBindMatrices");
    if (accessor.type != TINYGLTF_TYPE_MAT4 || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT || accessor.count < from.joints.size()) {
        report.error(where, fmt::format("must be a MAT4 accessor of floats with an element for each of the {} joints", from.joints.size()));
        return false;
    }
    const std::vector<float> flat = read_floats(model, from.inverseBindMatrices);
    for (size_t i = 0; i < from.joints.size(); ++i) {
        const std::vector<double> m(flat.begin() + std::ptrdiff_t(16 * i), flat.begin() + std::ptrdiff_t(16 * i + 16));
        skin.inverse_bind.push_back({Mat3(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]), Vec3(m[12], m[13], m[14])});
    }
    return true;
}

void check_joints(Scene& scene, Reporter& report) {
    for (Node& node : scene.nodes) {
        if (!node.skin) continue;
        const Mesh& mesh = std::get<Mesh>(scene.shapes[std::get<ShapeId>(node.what).index].geometry);
        if (mesh.joint_sets.empty()) {
            report.warning(node.from.pointer, "the node has a skin, but its mesh names no joints: the skin is left out");
            node.skin.reset();
            continue;
        }
        const size_t joints = scene.skins[node.skin->index].joints.size();
        const bool good = std::all_of(mesh.joint_sets.begin(), mesh.joint_sets.end(), [&](const JointSet& set) {
            return std::all_of(set.joints.begin(), set.joints.end(), [&](const Joints4& j) { return std::max({j.x, j.y, j.z, j.w}) < joints; });
        });
        if (!good) report.error(node.from.pointer, fmt::format("vertices of the mesh name joints that the skin does not have: it has {}", joints));
    }
}

}  // namespace

ShapeNodes convert_nodes(const Model& model, const std::vector<std::vector<MeshPart>>& meshes, const std::vector<std::optional<LightId>>& lights,
                         Scene& scene, Reporter& report) {
    ShapeNodes shape_nodes = NodeConverter(model, meshes, lights, scene, report).convert();
    scene.roots = find_roots(model, report);
    return shape_nodes;
}

void convert_skins(const Model& model, Scene& scene, Reporter& report) {
    for (size_t i = 0; i < model.skins.size(); ++i) {
        Skin skin;
        skin.name = model.skins[i].name;
        for (const int j : model.skins[i].joints) skin.joints.push_back(NodeId{uint32_t(j)});
        if (!read_inverse_bind(model, model.skins[i], child("/skins", i), skin, report)) return;
        scene.skins.push_back(std::move(skin));
    }
    check_joints(scene, report);
}

}  // namespace alidade::gltf
