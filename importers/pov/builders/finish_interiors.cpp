// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/finish_interiors.h"

#include <algorithm>
#include <map>
#include <set>

namespace alidade::pov {

namespace {

/// Of an interior, what finishes have said so far.
struct SaidOfInterior {
    std::optional<double> ior, caustics, refraction;

    auto operator<=>(const SaidOfInterior&) const = default;
    void add(const SaidOfInterior& later) {
        if (later.ior) ior = later.ior;
        if (later.caustics) caustics = later.caustics;
        if (later.refraction) refraction = later.refraction;
    }
};

const PovFinish* finish_on_top(const Material& material) { return material.layers.empty() ? nullptr : std::get_if<PovFinish>(&material.layers.back()); }

bool says_something(const Material& material) {
    const PovFinish* finish = finish_on_top(material);
    return finish && (finish->ior || finish->caustics || finish->refraction != 1);
}

class InteriorFiller {
  public:
    explicit InteriorFiller(Scene& scene) : scene_(scene) {}

    void fill_object(NodeId root) { fill(root, visit(root, {})); }

  private:
    /// The texture that a node has, or one above it. The default one is given to shapes alone, not to sets.
    struct Texture {
        uint32_t material = kNoId;
        bool usual = false;
        auto operator<=>(const Texture&) const = default;
    };

    SaidOfInterior said_by(const Texture& texture) const {
        const PovFinish* finish = texture.material == kNoId ? nullptr : finish_on_top(scene_.materials[texture.material]);
        return finish ? SaidOfInterior{finish->ior, finish->caustics, finish->refraction} : SaidOfInterior();
    }

    /// All triangles have textures of their own: POV-Ray gives the mesh none then.
    bool shows_slots_alone(const Node& node) const {
        const auto* mesh = std::get_if<Mesh>(&scene_.shapes[std::get<ShapeId>(node.what).index].geometry);
        return mesh && !mesh->slots.empty() && std::find(mesh->slots.begin(), mesh->slots.end(), 0u) == mesh->slots.end();
    }

    bool writes(const Node& node, const Texture& texture) const {
        if (!std::holds_alternative<ShapeId>(node.what)) return node.csg != CsgKind::none && !texture.usual;
        return !texture.usual || !shows_slots_alone(node);
    }

    /// What a node and those below it say of the interior of those above it. Nodes that are shared are asked once.
    SaidOfInterior visit(NodeId id, Texture texture) {
        const auto [known, added] = known_.try_emplace({id.index, texture});
        if (!added) return known->second;
        const Node& node = scene_.nodes[id.index];
        if (!node.materials.empty() && node.materials[0]) texture = {node.materials[0]->index, node.usual_material};
        if (node.cutaway_textures && texture.usual) texture = {};
        SaidOfInterior said;
        if (writes(node, texture)) said = said_by(texture);
        for (const NodeId child : node.children) said.add(visit(child, texture));
        if (node.interior) fill(id, said), said = {};
        return known->second = said;
    }

    /// A node that is shared below several textures keeps what the first of them says.
    void fill(NodeId id, const SaidOfInterior& said) {
        Node& node = scene_.nodes[id.index];
        if (!(said.ior || said.caustics || said.refraction.value_or(1) != 1) || !filled_.insert(id.index).second) return;
        const auto [made, is_new] = made_.try_emplace({node.interior ? node.interior->index : kNoId, said});
        if (is_new) made->second = add(node, said);
        node.interior = made->second;
    }

    InteriorId add(const Node& node, const SaidOfInterior& said) {
        Interior in;
        if (node.interior) in = scene_.interiors[node.interior->index];
        else in.from = node.from;
        in.ior = said.ior.value_or(in.ior), in.caustics = said.caustics.value_or(in.caustics), in.refraction = said.refraction.value_or(in.refraction);
        scene_.interiors.push_back(std::move(in));
        return InteriorId{uint32_t(scene_.interiors.size() - 1)};
    }

    Scene& scene_;
    std::map<std::pair<uint32_t, SaidOfInterior>, InteriorId> made_;   ///< of an interior, or none, and what is said of it
    std::map<std::pair<uint32_t, Texture>, SaidOfInterior> known_;
    std::set<uint32_t> filled_;
};

}  // namespace

void fill_interiors_by_finishes(Scene& scene) {
    if (std::none_of(scene.materials.begin(), scene.materials.end(), says_something)) return;
    InteriorFiller filler(scene);
    for (const NodeId root : scene.roots) filler.fill_object(root);
}

}  // namespace alidade::pov
