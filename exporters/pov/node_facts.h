// SPDX-License-Identifier: Apache-2.0
/// What must be known of the nodes before the first of them is written.
#pragma once

#include "exporters/losses.h"

#include <map>

namespace alidade::pov_export {

using SlotMaterials = std::vector<std::optional<MaterialId>>;   ///< by material slot

/// Which of a node's `slots` slots a mesh's triangle is in.
inline uint32_t slot_of(const Mesh& mesh, size_t slots, size_t triangle) { return slots < 2 || mesh.slots.empty() ? 0 : mesh.slots[triangle]; }

class NodeFacts {
  public:
    /// A shape in its materials: declared once if several nodes show it.
    struct ShapeKey {
        uint32_t shape = 0;
        SlotMaterials slots;
        bool uv_mapping = false;   ///< NodeFlags::uv_mapping, which stands before the texture
        friend auto operator<=>(const ShapeKey&, const ShapeKey&) = default;
    };

    NodeFacts(const Scene& scene, Losses& losses);

    /// Nothing of it can be written.
    bool is_empty(NodeId id) const { return facts_[id.index].empty; }
    /// It stands in several places, or so deep that readers would not follow.
    bool is_declared(NodeId id) const { return facts_[id.index].declared; }
    /// It shows a shape to which neither it nor a node below gives a material.
    bool is_bare(NodeId id) const { return facts_[id.index].bare; }
    /// Faces in it may show what they lay open (Node::cutaway_textures).
    bool lays_open(const Node& node) const { return facts_[size_t(&node - scene_.nodes.data())].lays_open; }
    /// Does the node's own material cover anything? (It does not where nodes below have theirs.)
    bool material_counts(const Node& node) const;
    /// What is reached, each before what it refers to.
    const std::vector<uint32_t>& order() const { return order_; }
    std::vector<NodeId> roots() const;
    std::vector<NodeId> children(const Node& node) const;

    bool draws_shape(const Node& node) const;
    /// Lights of the graph; those that are infinitely far away stand outside of it.
    bool draws_light(const Node& node) const;
    ShapeKey key_of(const Node& node, ShapeId shape) const;
    size_t uses(const ShapeKey& key) const { return uses_.at(key); }
    /// In how many sets of materials a shape is shown.
    size_t variants(ShapeId shape) const { return variants_.at(shape.index); }

    std::vector<bool> used_materials() const;
    bool needs_default() const;
    /// Do shapes get the default texture where they stand? If no node passes its material on to others, they can; else it is given to the roots.
    bool defaults_at_shapes() const { return defaults_at_shapes_; }

  private:
    struct Fact {
        bool empty = true, bare = false, declared = false, lays_open = false;
        uint32_t parents = 0, height = 0;
    };
    void reach();
    void study(uint32_t index);
    bool has_nothing(const Node& node) const;
    void count_shapes();

    const Scene& scene_;
    std::vector<Fact> facts_;
    std::vector<bool> seen_shapes_;   ///< by shape: it has a surface
    std::vector<uint32_t> order_;
    bool defaults_at_shapes_ = true;
    std::map<ShapeKey, size_t> uses_;
    std::map<uint32_t, size_t> variants_;
};

}  // namespace alidade::pov_export
