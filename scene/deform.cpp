// SPDX-License-Identifier: Apache-2.0
#include "scene/graph.h"
#include "scene/mesh_deformation.h"
#include "scene/queries.h"

#include <tuple>

namespace alidade {

namespace {

/// By node: does a path of visible nodes lead to it?
std::vector<bool> shown_nodes(const Scene& scene, const std::vector<uint32_t>& parents_first) {
    std::vector<bool> shown(scene.nodes.size());
    for (const NodeId root : scene.roots) shown[root.index] = true;
    for (const uint32_t i : parents_first) {
        shown[i] = shown[i] && scene.nodes[i].flags.visible;
        if (shown[i]) for_each_link(scene, scene.nodes[i], [&](NodeId id) { shown[id.index] = true; });
    }
    return shown;
}

/// By node: its place in the world, by the first of its parents. A joint moves its vertices whether it is shown or not.
std::vector<Transform> places(const Scene& scene, const std::vector<uint32_t>& parents_first) {
    std::vector<Transform> to_world(scene.nodes.size());
    std::vector<bool> has_parent(scene.nodes.size());
    for (const uint32_t i : parents_first) {
        to_world[i] = to_world[i] * scene.nodes[i].to_parent;
        for (const NodeId child : scene.nodes[i].children) {
            if (!has_parent[child.index]) to_world[child.index] = to_world[i];
            has_parent[child.index] = true;
        }
    }
    return to_world;
}

class Deformer {
  public:
    explicit Deformer(Scene& scene) : scene_(scene) {
        const auto links = [&](uint32_t i, const auto& f) { for_each_link(scene, scene.nodes[i], [&](NodeId id) { f(id.index); }); };
        const std::vector<uint32_t> parents_first = topological_order(scene.nodes.size(), links).sequence;
        shown_ = shown_nodes(scene, parents_first);
        to_world_ = places(scene, parents_first);
        for (const Skin& skin : scene.skins) joints_.push_back(matrices(skin));
    }

    void run() {
        for (uint32_t i = 0; i < shown_.size(); ++i)
            if (shown_[i]) deform_node(i);
    }

  private:
    std::vector<Transform> matrices(const Skin& skin) const {
        std::vector<Transform> out;
        for (size_t i = 0; i < skin.joints.size(); ++i) {
            const Transform& world = to_world_[skin.joints[i].index];
            out.push_back(skin.inverse_bind.empty() ? world : world * skin.inverse_bind[i]);
        }
        return out;
    }

    void deform_node(uint32_t index) {
        const ShapeId* shape = std::get_if<ShapeId>(&scene_.nodes[index].what);
        const Mesh* mesh = shape ? std::get_if<Mesh>(&scene_.shapes[shape->index].geometry) : nullptr;
        if (!mesh) return;
        const auto skin = mesh->joint_sets.empty() ? std::nullopt : scene_.nodes[index].skin;
        const std::vector<double> weights = weights_of(scene_.nodes[index], *mesh);
        if (!skin && weights.empty()) return;
        const ShapeId deformed = copy(*shape, skin, weights);
        if (skin) detach(index, deformed);
        else scene_.nodes[index].what = deformed;
    }

    /// The node's own weights over the mesh's; empty if none of them moves anything.
    static std::vector<double> weights_of(const Node& node, const Mesh& mesh) {
        std::vector<double> weights = node.morph_weights.empty() ? mesh.morph_weights : node.morph_weights;
        const bool rest = std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; });
        return rest ? std::vector<double>() : weights;
    }

    /// The deformed `shape`, made once for each way to show it.
    ShapeId copy(ShapeId shape, std::optional<SkinId> skin_id, const std::vector<double>& weights) {
        const auto [known, fresh] = copies_.try_emplace({shape, skin_id, weights}, ShapeId{uint32_t(scene_.shapes.size())});
        if (!fresh) return known->second;
        Mesh& rest = std::get<Mesh>(scene_.shapes[shape.index].geometry);
        // Targets and joints are not copied with the mesh: they may be far larger than it is.
        std::vector<MorphTarget> targets = std::exchange(rest.morphs, {});
        std::vector<JointSet> sets = std::exchange(rest.joint_sets, {});
        ShapeEntry entry = scene_.shapes[shape.index];
        rest.morphs = std::move(targets), rest.joint_sets = std::move(sets);
        Mesh& mesh = std::get<Mesh>(entry.geometry);
        if (!weights.empty()) morph(mesh, rest.morphs, weights);
        if (skin_id) skin(mesh, rest.joint_sets, joints_[skin_id->index]);
        scene_.shapes.push_back(std::move(entry));
        return known->second;
    }

    /// Moves what the node holds into a root of its own, with all that is not the place.
    void detach(uint32_t index, ShapeId shape) {
        Node drawn = scene_.nodes[index];
        drawn.to_parent = Transform();
        drawn.trs.reset();
        drawn.children.clear(), drawn.clips.clear(), drawn.bounds.clear();
        drawn.what = shape;
        scene_.nodes[index].what = Nothing();
        scene_.roots.push_back(NodeId{uint32_t(scene_.nodes.size())});
        scene_.nodes.push_back(std::move(drawn));
    }

    Scene& scene_;
    std::vector<bool> shown_;
    std::vector<Transform> to_world_;
    std::vector<std::vector<Transform>> joints_;   ///< by skin: the matrix of each joint
    std::map<std::tuple<ShapeId, std::optional<SkinId>, std::vector<double>>, ShapeId> copies_;
};

bool has_deformable_mesh(const Scene& scene) {
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const ShapeEntry& shape) {
        const Mesh* mesh = std::get_if<Mesh>(&shape.geometry);
        return mesh && (!mesh->morphs.empty() || !mesh->joint_sets.empty());
    });
}

/// Drops what has been applied.
void make_still(Scene& scene) {
    for (Node& node : scene.nodes) node.skin.reset(), node.morph_weights.clear();
    for (ShapeEntry& shape : scene.shapes)
        if (Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) mesh->morphs.clear(), mesh->morph_weights.clear(), mesh->joint_sets.clear();
    scene.skins.clear();
    scene.animations.clear();
}

}  // namespace

Scene deform(Scene scene) {
    if (has_deformable_mesh(scene)) Deformer(scene).run();
    make_still(scene);
    return scene;
}

}  // namespace alidade
