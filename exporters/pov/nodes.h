// SPDX-License-Identifier: Apache-2.0
/// The graph of nodes -> objects: one block a node, its children in it, its transformation behind them. What has several parents, and what lies deep, is
/// declared once and named where it stands.
#pragma once

#include "exporters/pov/lights.h"
#include "exporters/pov/node_facts.h"
#include "exporters/pov/shapes.h"

namespace alidade::pov_export {

class NodeWriter {
  public:
    NodeWriter(const ShapeContext& context, LightWriter& lights, const NodeFacts& facts) : c_(context), lights_(lights), facts_(facts) {}

    /// All that the roots show. Lights that are infinitely far away are not among it.
    void write();

  private:
    void declare(NodeId id);
    void declare_shape(const Node& node, ShapeId shape);
    /// The node where it stands among others, or alone in `object { }`.
    void object(NodeId id);
    void named_or_object(NodeId id);
    void block(NodeId id, bool is_root);
    void group(const Node& node, bool is_root);
    void lone_shape(const Node& node, ShapeId shape, bool is_root);
    void light_part(const Light& light, const Transform& to_parent, size_t part);
    void pieces(const Node& node);
    void modifiers(const Node& node, bool is_root, bool textured);
    void texture(const Node& node, bool is_root);
    /// Is a shape declared with its texture?
    bool has_texture(const NodeFacts::ShapeKey& key) const { return key.slots[0] || facts_.defaults_at_shapes(); }
    bool needs_own_default(const Node& root) const;
    void flags(const Node& node);
    /// Is it written as an `object`? A set of one set stays one: it decides which of coincident surfaces is seen.
    bool is_placement(const Node& node) const;
    /// Is it written as a union, or as an object that is one?
    bool places_union(const Node& node) const;
    void turned_bounds(const Node& node);
    void cut(const char* word, const std::vector<NodeId>& by);
    std::string declared_name(NodeId id) const;

    const ShapeContext& c_;
    LightWriter& lights_;
    const NodeFacts& facts_;
    std::vector<bool> places_bounds_;   ///< by node: does something bound it, or what it places?
    bool cuts_ = false;        ///< is what clips or bounds an object, which has no texture
    std::map<uint32_t, std::string> geometries_;                ///< shapes that were declared without materials
    std::map<NodeFacts::ShapeKey, std::string> shapes_;          ///< and with them
};

}  // namespace alidade::pov_export
