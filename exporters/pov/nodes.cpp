// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/nodes.h"

#include "eval/csg_expression.h"
#include "eval/kept_boxes.h"

#include <fmt/format.h>
#include <utility>

namespace alidade::pov_export {

namespace {

const char* word_of(CsgKind csg) {
    switch (csg) {
        case CsgKind::merge: return "merge";
        case CsgKind::intersection: return "intersection";
        case CsgKind::difference: return "difference";
        case CsgKind::none:
        case CsgKind::union_: break;
    }
    return "union";
}

/// A sphere that is all there is in a node, moved by `to`, if that turns it and does not scale it before.
std::optional<TurnedSphere> turned_sphere(const Scene& scene, NodeId id, const Transform& to) {
    const LoneShape lone = lone_shape(scene, id);
    const auto* sphere = lone.shape ? std::get_if<Sphere>(lone.shape) : nullptr;
    if (!sphere) return std::nullopt;
    const Transform all = to * lone.to_space;
    const bool turns = all.linear != Mat3(all.linear[0].x, 0, 0, 0, all.linear[1].y, 0, 0, 0, all.linear[2].z);
    return turns ? turned(*sphere, all) : std::nullopt;
}

/// What POV-Ray gives an object that has no texture.
bool is_default(const Scene& scene, MaterialId id) {
    const Material& m = scene.materials[id.index];
    const auto* f = m.layers.size() == 1 ? std::get_if<PovFinish>(&m.layers[0]) : nullptr;
    const auto* colour = f ? std::get_if<ConstantSignal>(&scene.signals[f->pigment.index].what) : nullptr;
    if (!colour || f->normal || !is_black(Color(colour->value)) || colour->filter != 0 || colour->transmit != 0) return false;
    Sdl own, usual;
    write_finish(own, *f), write_finish(usual, {});
    return own.text() == usual.text();
}

}  // namespace

std::string NodeWriter::declared_name(NodeId id) const { return fmt::format("Node_{}", id.index); }

void NodeWriter::declare_shape(const Node& node, ShapeId shape) {
    const NodeFacts::ShapeKey key = facts_.key_of(node, shape);
    const ShapeEntry& entry = c_.scene.shapes[shape.index];
    const size_t uses = facts_.uses(key), variants = facts_.variants(shape);
    if (variants > 1 && key.slots.size() == 1 && !geometries_.contains(shape.index)) {
        const std::string name = fmt::format("Geometry_{}", shape.index);
        c_.sdl.comment(entry.name);
        c_.sdl.line("#declare", name, "=");
        begin_shape(entry.geometry, key.slots, c_);
        c_.sdl.end();
        geometries_.emplace(shape.index, name);
    }
    if (uses < 2 || shapes_.contains(key)) return;
    const std::string name = fmt::format("Shape_{}_{}", shape.index, shapes_.size());
    const auto geometry = geometries_.find(shape.index);
    c_.sdl.comment(entry.name);
    c_.sdl.line("#declare", name, "=");
    if (key.slots.size() == 1 && geometry != geometries_.end()) c_.sdl.begin("object"), c_.sdl.line(geometry->second);
    else begin_shape(entry.geometry, key.slots, c_);
    if (has_texture(key)) {
        if (key.uv_mapping) c_.sdl.line("uv_mapping");
        c_.textures.use(key.slots[0]);
    }
    c_.sdl.end();
    shapes_.emplace(key, name);
}

void NodeWriter::declare(NodeId id) {
    const Node& node = c_.scene.nodes[id.index];
    if (facts_.is_empty(id)) return;
    if (facts_.draws_shape(node)) declare_shape(node, std::get<ShapeId>(node.what));
    if (!facts_.is_declared(id)) return;
    c_.sdl.line("#declare", declared_name(id), "=");
    block(id, false);
}

void NodeWriter::object(NodeId id) {
    if (facts_.is_declared(id)) c_.sdl.line("object {", declared_name(id), "}");
    else block(id, false);
}

void NodeWriter::named_or_object(NodeId id) {
    if (facts_.is_declared(id)) c_.sdl.line(declared_name(id));
    else block(id, false);
}

void NodeWriter::block(NodeId id, bool is_root) {
    const Node& node = c_.scene.nodes[id.index];
    c_.sdl.comment(node.name);
    const bool shape = facts_.draws_shape(node), light = facts_.draws_light(node);
    const size_t lights = light ? LightWriter::parts(c_.scene.lights[std::get<LightId>(node.what).index]) : 0, pieces = facts_.children(node).size() + shape + lights;
    const bool lights_alone = !node.light_group.empty() || !node.global_lights;
    if (pieces == 1 && !lights_alone && shape) return lone_shape(node, std::get<ShapeId>(node.what), is_root);
    if (pieces == 1 && !lights_alone && light) return light_part(c_.scene.lights[std::get<LightId>(node.what).index], node.to_parent, 0);
    group(node, is_root);
}

void NodeWriter::group(const Node& node, bool is_root) {
    if (!node.light_group.empty() || !node.global_lights) {
        c_.sdl.begin("light_group");
        pieces(node);
        if (node.global_lights) c_.sdl.line("global_lights on");
    } else if (is_placement(node)) {
        c_.sdl.begin("object");
        named_or_object(facts_.children(node).front());
    } else {
        c_.sdl.begin(word_of(node.csg));
        pieces(node);
    }
    modifiers(node, is_root, true);
    c_.sdl.end();
}

void NodeWriter::lone_shape(const Node& node, ShapeId shape, bool is_root) {
    const NodeFacts::ShapeKey key = facts_.key_of(node, shape);
    const auto named = cuts_ && has_texture(key) ? shapes_.end() : shapes_.find(key);
    const auto geometry = geometries_.find(shape.index);
    if (named != shapes_.end()) {
        c_.sdl.begin("object");
        c_.sdl.line(named->second);
    } else if (key.slots.size() == 1 && geometry != geometries_.end()) {
        c_.sdl.begin("object");
        c_.sdl.line(geometry->second);
    } else {
        begin_shape(c_.scene.shapes[shape.index].geometry, key.slots, c_);
    }
    modifiers(node, is_root, named == shapes_.end() || !has_texture(key));
    c_.sdl.end();
}

void NodeWriter::light_part(const Light& light, const Transform& to_parent, size_t part) {
    lights_.begin(light, to_parent, part);
    const auto follow = [&](const char* word, const std::optional<NodeId>& id) {
        if (!id || facts_.is_empty(*id)) return;
        c_.sdl.begin(word);
        object(*id);
        c_.sdl.end();
    };
    if (part == 0) follow("looks_like", light.looks_like);
    if (light.projected_through && !facts_.is_empty(*light.projected_through)) {
        c_.sdl.begin("projected_through {", "object");
        object(*light.projected_through);
        c_.sdl.line(to_parent);
        c_.sdl.end();
        c_.sdl.line("}");
    }
    c_.sdl.end();
}

void NodeWriter::pieces(const Node& node) {
    if (facts_.draws_shape(node)) {
        const ShapeId shape = std::get<ShapeId>(node.what);
        begin_shape(c_.scene.shapes[shape.index].geometry, facts_.key_of(node, shape).slots, c_);
        c_.sdl.end();
    }
    if (facts_.draws_light(node)) {
        const Light& light = c_.scene.lights[std::get<LightId>(node.what).index];
        for (size_t part = 0; part < LightWriter::parts(light); ++part) light_part(light, Transform(), part);
    }
    for (const NodeId child : facts_.children(node)) object(child);
}

void NodeWriter::texture(const Node& node, bool is_root) {
    if (facts_.material_counts(node)) {
        if (is_root && !node.inside_material && (is_default(c_.scene, *node.materials[0]) || needs_own_default(node))) return;
        c_.textures.use(node.materials[0]);
        c_.losses.add("faces that show what they lay open", node.usual_material && facts_.lays_open(node), "the texture of #default");
    } else if (facts_.defaults_at_shapes() ? facts_.draws_shape(node) : is_root && facts_.is_bare({uint32_t(&node - c_.scene.nodes.data())})) {
        c_.textures.use(std::nullopt);
    }
}

bool NodeWriter::is_placement(const Node& node) const {
    const std::vector<NodeId> parts = facts_.children(node);
    if (node.flags.uv_mapping && !facts_.material_counts(node)) return false;   // POV-Ray does not take the word behind a texture, which the part may have
    return parts.size() == 1 && !facts_.draws_shape(node) && !facts_.draws_light(node) && (node.csg == CsgKind::none || facts_.children(c_.scene.nodes[parts[0].index]).empty());
}

bool NodeWriter::places_union(const Node& node) const {
    const Node* at = &node;
    while (is_placement(*at)) at = &c_.scene.nodes[facts_.children(*at).front().index];
    return at->csg == CsgKind::union_ && !facts_.children(*at).empty();
}

void NodeWriter::flags(const Node& node) {
    const NodeFlags& f = node.flags;
    if (!f.shadow) c_.sdl.line("no_shadow");
    if (!f.image) c_.sdl.line("no_image");
    if (!f.reflection) c_.sdl.line("no_reflection");
    if (f.hollow) c_.sdl.line("hollow");
    if (f.double_illuminate) c_.sdl.line("double_illuminate");
    if (node.inverse) c_.sdl.line("inverse");
    if (node.whole && places_union(node)) c_.sdl.line("split_union", "off");
    if (node.cutaway_textures && facts_.children(node).size() > 1) c_.sdl.line("cutaway_textures");
}

void NodeWriter::cut(const char* word, const std::vector<NodeId>& by) {
    const bool any = std::any_of(by.begin(), by.end(), [&](NodeId id) { return !facts_.is_empty(id); });
    if (!any) return;
    c_.sdl.begin(word);
    const bool before = std::exchange(cuts_, true);
    for (const NodeId id : by)
        if (!facts_.is_empty(id)) object(id);
    cuts_ = before;
    c_.sdl.end();
}

/// Spheres that bound the node, and what it places, are written as they are behind the matrix: POV-Ray keeps a larger box of one that a matrix turns than of one that `rotate` turned, and cuts by that.
/// Each of the nodes that place one another writes them again: from some on they stay as they are, before the matrix.
void NodeWriter::turned_bounds(const Node& node) {
    constexpr int kMostPlacements = 8;
    int placements = 0;
    Transform to = node.to_parent;
    const auto index = [&](const Node* at) { return size_t(at - c_.scene.nodes.data()); };
    for (const Node* at = &node; places_bounds_[index(at)] && placements < kMostPlacements; ++placements, to = to * at->to_parent) {
        for (const NodeId id : at->bounds)
            if (const auto sphere = turned_sphere(c_.scene, id, to)) {
                c_.sdl.begin("bounded_by");
                begin_shape(sphere->sphere, {std::nullopt}, c_);
                c_.sdl.line(Transform::scale(sphere->scale));
                c_.sdl.end();
                c_.sdl.end();
            }
        if (!is_placement(*at)) return;
        at = &c_.scene.nodes[facts_.children(*at).front().index];
    }
}

/// The transformation comes before no more than bounds: all before it lies in the node's own space.
void NodeWriter::modifiers(const Node& node, bool is_root, bool textured) {
    textured = textured && !cuts_;
    if (textured && node.flags.uv_mapping) c_.sdl.line("uv_mapping");   // before the texture, as POV-Ray has it
    if (textured) texture(node, is_root);
    if (node.inside_material && !cuts_) {
        c_.sdl.begin("interior_texture");
        c_.sdl.line(fmt::format("Texture_{}", node.inside_material->index));
        c_.sdl.end();
    }
    c_.textures.interior(facts_.material_counts(node) ? node.materials[0] : std::nullopt, node.interior);
    flags(node);
    cut("clipped_by", node.clips);
    std::vector<NodeId> bounds = node.bounds;
    std::erase_if(bounds, [&](NodeId id) { return turned_sphere(c_.scene, id, node.to_parent).has_value(); });
    cut("bounded_by", bounds);
    if (!node.to_parent.is_identity()) c_.sdl.line(node.to_parent);
    turned_bounds(node);
}

/// A texture would be that of all parts, and faces that show what they lay open have none.
bool NodeWriter::needs_own_default(const Node& root) const {
    return root.usual_material && facts_.lays_open(root) && facts_.material_counts(root) && !is_default(c_.scene, *root.materials[0]);
}

void NodeWriter::write() {
    const std::vector<uint32_t>& order = facts_.order();
    places_bounds_.resize(c_.scene.nodes.size());
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Node& node = c_.scene.nodes[*i];
        places_bounds_[*i] = !node.bounds.empty() || (is_placement(node) && places_bounds_[facts_.children(node).front().index]);
        declare({*i});
    }
    bool keeps_default = false;
    for (const NodeId root : facts_.roots()) {
        const Node& node = c_.scene.nodes[root.index];
        if (facts_.is_declared(root)) {
            c_.sdl.line("object {", declared_name(root), "}");
            continue;
        }
        const bool own = needs_own_default(node);
        if (own) {
            if (!std::exchange(keeps_default, true)) c_.sdl.line("#declare Texture_usual = texture { pigment { color rgb 0 } }");
            c_.sdl.begin("#default");
            c_.textures.use(node.materials[0]);
            c_.sdl.end();
        }
        block(root, true);
        if (own) c_.sdl.line("#default { texture { Texture_usual } }");
    }
}

}  // namespace alidade::pov_export
