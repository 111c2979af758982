// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/objects.h"

#include "eval/csg_expression.h"

#include "core/transform.h"
#include "importers/pov/builders/clips.h"
#include "importers/pov/builders/interiors.h"
#include "importers/pov/builders/lights.h"
#include "importers/pov/builders/materials.h"
#include "importers/pov/builders/misplaced.h"
#include "importers/pov/builders/shapes.h"
#include "importers/pov/builders/texts.h"
#include "importers/pov/builders/textures.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace alidade::pov {

namespace {

/// An object while its modifiers are read. A texture lies in the space that the object has where the texture stands: transformations before it move the
/// object alone, those behind it both.
struct Draft {
    Node node;                            ///< the shape, or the children
    Transform placed;                     ///< of what is wrapped
    Transform before;                     ///< of the object alone
    Transform transform;                  ///< behind the texture; of all, if there is none
    TextureLayers layers, inside;         ///< of the inside: those of interior_texture
    Place texture_place;
    bool uv_mapped = false;               ///< of the texture that follows
    bool limits = true;                   ///< as BuiltObject::limits, of its parts
    bool shows_cuts = false;              ///< cutaway_textures stands around it, which is said of the operation itself
    bool changed = false;                 ///< a texture or interior stands around it, which takes the place of its own
    std::vector<Bound> bounds;            ///< those that clipped_by has not named
    bool is_group = false, is_lit = false;   ///< a light group; global lights shine on it, since they do around it
    bool bounded = false, split = true;   ///< bounded_by and split_union, which say if a union is one object
};

CsgKind csg_of(WordId word) {
    switch (word) {
        case "union"_w: return CsgKind::union_;
        case "merge"_w: return CsgKind::merge;
        case "intersection"_w: return CsgKind::intersection;
        case "difference"_w: return CsgKind::difference;
        default: return CsgKind::none;
    }
}

bool changes_surface(const Item& item) {
    return item.value_kind() == Kind::block ? belongs_to_objects(item.block().word) : item.kind == Item::Kind::word && item.word == "uv_mapping"_w;
}

/// `no_image off` takes back what the declared object says.
bool undoes_flags(std::span<const Item> items) {
    for (size_t i = 0; i + 1 < items.size(); ++i) {
        const bool is_flag = items[i].kind == Item::Kind::word && (items[i].word == "no_image"_w || items[i].word == "no_reflection"_w);
        if (is_flag && items[i + 1].value_kind() == Kind::number && items[i + 1].number() == 0) return true;
    }
    return false;
}

bool shows_cuts(const Item& item) { return item.kind == Item::Kind::word && item.word == "cutaway_textures"_w; }

void begin_texture(Draft& d, Place at) {
    if (!d.layers.empty() || !d.inside.empty()) return;
    d.before = d.transform * d.before, d.transform = Transform();
    d.texture_place = at;
}

/// `pigment`, `normal` or `finish` beside the object changes the layer on top: the default texture if there is none.
bool take_layer(Build& build, Draft& d, Cursor& at) {
    const Block* block = at.any_block();
    if (!block || (block->word != "pigment"_w && block->word != "normal"_w && block->word != "finish"_w)) return false;
    begin_texture(d, block->place);
    if (d.layers.empty()) d.layers.push_back(default_texture(build, block->defaults));
    const bool taken = take_layer_part(build, at, d.layers, d.transform);
    if (d.uv_mapped) set_uv_mapped(build, d.layers, Bumps::stay);
    return taken;
}

/// `more` over what `layers`, which are the draft's, has: of the texture or material `block`.
void add_textures(Build& build, Draft& d, TextureLayers& layers, TextureLayers more, const Block& block) {
    if (more.empty()) return;
    begin_texture(d, block.place);
    if (d.uv_mapped) set_uv_mapped(build, more, Bumps::stay);
    move_layers(build, more, inverse(d.transform).value_or(Transform()));   // what stood between the layers moves those before it alone
    add_layers(build, layers, std::move(more), block.version);
}

void add_material(Build& build, Draft& d, const Block& block) {
    MaterialParts parts = read_material(build, block, d.node.interior);
    d.node.interior = parts.interior;
    add_textures(build, d, d.layers, std::move(parts.layers), block);
    add_textures(build, d, d.inside, std::move(parts.inside), block);
}

bool take_surface(Build& build, Draft& d, Cursor& at) {
    if (build.shapes_alone && !at.done() && changes_surface(at.peek())) return at.next(), true;
    if (take_layer(build, d, at)) return true;
    if (at.at_word("uv_mapping"_w)) {
        if (!d.layers.empty()) build.p.fail(at.place(), "uv_mapping must stand before the texture");
        d.uv_mapped = d.node.flags.uv_mapping = true;
        map_triangles(build, d.node, d.transform);
    } else if (const Block* texture = at.block_at("texture"_w)) add_textures(build, d, d.layers, build_texture(build, *texture), *texture);
    else if (const Block* inside = at.block_at("interior_texture"_w)) add_textures(build, d, d.inside, build_texture(build, *inside), *inside);
    else if (const Block* material = at.block_at("material"_w)) add_material(build, d, *material);
    else if (const Block* interior = at.block_at("interior"_w)) d.node.interior = add_interior(build, *interior, d.node.interior);
    else return false;
    at.next();
    return true;
}

bool take_flag(Draft& d, Cursor& at) {
    NodeFlags& f = d.node.flags;
    if (at.accept("no_shadow"_w)) f.shadow = false;
    else if (at.accept("no_image"_w)) f.image = !at.flag();
    else if (at.accept("no_reflection"_w)) f.reflection = !at.flag();
    else if (at.accept("hollow"_w)) f.hollow = at.flag();
    else if (at.accept("double_illuminate"_w)) f.double_illuminate = at.flag();
    else if (d.is_group && at.accept("global_lights"_w)) d.node.global_lights = at.flag() || d.is_lit;
    else if (at.accept("inverse"_w)) d.node.inverse = !d.node.inverse;
    else return false;
    return true;
}

/// Words that change how POV-Ray finds a surface, and not where it is.
bool is_hint(const Cursor& at) {
    const Item& item = at.peek();
    if (at.at_block("photons"_w)) return true;
    if (item.kind != Item::Kind::word) return false;
    return item.word == "sturm"_w || item.word == "hierarchy"_w || item.word == "no_radiosity"_w;
}

/// The lights of `light_group` shine on what stands in it, but not in a group in it that has lights; others do not, unless `global_lights` says so. Lights of sets
/// in it are not its own: they shine on the whole scene (probed).
void gather_lights(const Scene& scene, NodeId id, std::vector<LightId>& out) {
    const Node& node = scene.nodes[id.index];
    if (!node.light_group.empty() || !node.global_lights || node.csg != CsgKind::none) return;
    if (const auto* light = std::get_if<LightId>(&node.what)) out.push_back(*light);
    for (const NodeId child : node.children) gather_lights(scene, child, out);
}

/// What bounds an object may clip it as well; `bounded_by { clipped_by }` says nothing new.
void take_bound(Build& build, Draft& d, const Block& block) {
    d.bounded = true;
    if (!names_other_limits(build, block)) d.bounds.push_back({&block, d.transform * d.before});
}

/// As POV-Ray has it, only what cuts can show what it cuts.
void take_cutaway(Build& build, Draft& d, Place place) {
    if (d.node.csg != CsgKind::intersection && d.node.csg != CsgKind::difference) build.p.fail(place, "cutaway_textures stands in an intersection or a difference alone");
    d.node.cutaway_textures = true;
}

void refuse_object(const Build& build, const Cursor& at) {
    const WordId word = at.block().word;
    const Item& first = at.block().items().front();
    if (csg_of(word) != CsgKind::none && first.kind == Item::Kind::value)      // POV-Ray: the set is what is named, and has no parts
        build.p.fail(first.place, fmt::format("the name of an object that begins a {} stands alone there", kWords[word]), "write object { NAME } for a part");
    build.p.fail(at.place(), fmt::format("{} cannot stand here in {}", kWords[at.any_block()->word], kWords[word]), csg_of(word) != CsgKind::none ? "the parts of a set stand before what modifies it" : "a } is missing before it, or a union around both");
}

void take_modifiers(Build& build, Draft& d, Cursor& at) {
    while (!at.done()) {
        if (at.at_transform()) d.transform = at.transform() * d.transform;
        else if (take_surface(build, d, at) || take_flag(d, at)) continue;
        else if (const Block* clip = at.block_at("clipped_by"_w)) at.next(), take_limits(build, d.bounds, d.node.clips, *clip, d.transform * d.before);
        else if (const Block* bound = at.block_at("bounded_by"_w)) at.next(), take_bound(build, d, *bound);
        else if (at.at_word("cutaway_textures"_w)) take_cutaway(build, d, at.place()), at.next();
        else if (at.accept("split_union"_w)) d.split = at.flag();
        else if (is_hint(at)) at.skip();
        else if (at.at_colour() && !d.is_group) at.skip_quick_colour();
        else if (at.any_block() && is_object(at.any_block()->word)) refuse_object(build, at);
        else at.skip_unmodelled();
    }
}

/// A union that is bounded, not split or clipped is one object. It throws no shadow if none of its parts does.
void settle_union(const Build& build, Draft& d) {
    const Node* of = &d.node;
    bool inverse = of->inverse;
    for (auto below = lone_part(*of); below; below = lone_part(*of)) of = &build.scene.nodes[below->index], inverse = inverse != of->inverse;
    if (of->csg != CsgKind::union_) return;
    d.node.whole = d.bounded || !d.split;
    if (inverse || (!d.node.whole && d.node.clips.empty())) return;
    const auto is_light = [&](NodeId id) { return std::holds_alternative<LightId>(build.scene.nodes[id.index].what); };
    const auto throws_shadow = [&](NodeId id) {
        for (std::optional<NodeId> at = id; at; at = lone_part(build.scene.nodes[at->index]))
            if (!build.scene.nodes[at->index].flags.shadow) return false;
        return !is_light(id);
    };
    const bool none = std::none_of(of->children.begin(), of->children.end(), throws_shadow);
    if (none && !std::all_of(of->children.begin(), of->children.end(), is_light)) d.node.flags.shadow = false;
}

bool draft(Build& build, const Block& block, Draft& d);

/// The declared object as a child, stored once however often it is referred to.
bool reference(Build& build, const Block& object, Draft& d) {
    auto known = build.declared.find(&object);
    if (known == build.declared.end()) {
        const auto built = build_object(build, object);
        if (!built) return false;
        known = build.declared.emplace(&object, *built).first;
    }
    d.node.children.push_back(known->second.node);
    d.limits = known->second.limits;
    return true;
}

/// Counts the calls that one stands in.
struct Within {
    Within(int& calls, bool counts) : depth(calls), by(counts ? 1 : 0) { depth += by; }
    Within(const Within&) = delete;
    ~Within() { depth -= by; }
    int& depth;
    int by;
};

/// `object { NAME ... }`: the thing itself where its texture or interior is changed, a child that it shares with other references where not.
bool object(Build& build, Cursor& at, Draft& d) {
    const Block* inner = at.any_block();
    const Within named(build.by_name, inner && at.at_declared());
    if (!inner || !is_object(inner->word)) build.p.fail(at.place(), fmt::format("an object is expected in {} {{ }}", kWords[at.block().word]));
    at.next();
    const std::span<const Item> items = at.block().items();
    d.shows_cuts = d.shows_cuts || std::any_of(items.begin(), items.end(), shows_cuts);
    d.changed = d.changed || std::any_of(items.begin(), items.end(), changes_surface) || undoes_flags(items) || at.block().word == "light_group"_w || (inner->word == "light_group"_w && build.lit_globally > 0);
    if (build.shapes_alone || !(d.shows_cuts || d.changed)) return reference(build, *inner, d);
    constexpr size_t kMostCopies = 50'000;
    if (build.copying && ++build.copies_of_copies > kMostCopies) build.p.fail_limit(at.block().place, fmt::format("more than {} objects are copied in copies, because their textures or interiors change", kMostCopies));
    const Within copying(build.copying, true);
    return draft(build, *inner, d);
}

/// How many there are, those that are left out among them.
size_t take_children(Build& build, Draft& d, Cursor& at) {
    for (size_t parts = 0;; ++parts) {
        const Block* child = at.any_block();
        if (!child || !is_object(child->word)) return parts;
        const Within named(build.by_name, at.at_declared());
        at.next();
        if (const auto built = build_object(build, *child)) d.node.children.push_back(built->node), d.limits = d.limits && built->limits;
        else if (d.node.csg == CsgKind::difference && d.node.children.empty()) d.node.children.push_back(build.add_node({}));   // what is left out has no parts
    }
}

bool shape(Build& build, const Block& block, Cursor& at, Draft& d) {
    auto built = build_shape(build, block.word, at);
    if (!built) {
        build.p.tally(block.place, fmt::format("{} is not modelled yet: it is left out", kWords[block.word]));
        return false;
    }
    const auto* mesh = std::get_if<Mesh>(&built->geometry);
    d.limits = !mesh || mesh->inside_vector;
    ShapeEntry entry;
    entry.geometry = std::move(built->geometry);
    entry.from = build.position(block.place);
    append(build.scene.shapes, std::move(entry));
    d.node.what = ShapeId{uint32_t(build.scene.shapes.size() - 1)};
    d.node.materials = std::move(built->slots);
    return true;
}

/// `light_group { ... global_lights on }`: holds for all groups in it, whatever they say.
bool takes_global_lights(const Block& group) {
    bool on = false;
    for (size_t i = 0; i < group.items().size(); ++i)
        if (group.items()[i].kind == Item::Kind::word && group.items()[i].word == "global_lights"_w) on = i + 1 == group.items().size() || group.items()[i + 1].value_kind() != Kind::number || group.items()[i + 1].number() != 0;
    return on;
}

bool is_object_at(const Block& block, size_t i) { return i < block.items().size() && block.items()[i].value_kind() == Kind::block && is_object(block.items()[i].block().word); }

/// `sphere { Ball ... }` is Ball. POV-Ray does not ask of what kind that is: `quadric { Ellipsoid }`, `union { Ball }`. Where it stands behind other parts of a set it is one.
bool names_an_object(const Block& block, const Cursor& at) {
    if (!is_object_at(block, 0)) return false;
    if (block.word == "light_group"_w) return at.at_declared() && block.items()[0].block().word == block.word;
    if (csg_of(block.word) != CsgKind::none) return at.at_declared();
    return at.at_declared() || block.items()[0].block().word == block.word;
}

/// Reads an object into `d`, which is as it was made; false if it is not modelled.
bool draft(Build& build, const Block& block, Draft& d) {
    Cursor at(build, block);
    const bool wraps = block.word == "object"_w || block.word == "looks_like"_w || block.word == "projected_through"_w;
    const Transform placed = std::exchange(d.placed, Transform());
    if (wraps || names_an_object(block, at)) {
        if (!object(build, at, d)) return false;
        d.transform = placed * d.transform;
        if (block.word == "light_group"_w) d.node.global_lights = build.lit_globally > 0;   // what the named group says of itself is not kept
    } else if (const CsgKind csg = csg_of(block.word); csg != CsgKind::none) {
        d.node.csg = csg;
        const size_t parts = take_children(build, d, at);
        if (parts < 2) build.p.warn(block.place, fmt::format("{} has fewer than two parts", kWords[block.word]));
        if (parts > 0 && d.node.children.empty()) d.node.children.push_back(build.add_node({}));      // what is left out does not make it a set of nothing
    } else if (block.word == "text"_w) {
        d.node.csg = CsgKind::union_;
        d.node.children = build_text(build, at).letters;
    } else if (block.word == "light_group"_w) {
        d.is_group = true, d.node.open_light_group = build.by_name > 0, d.is_lit = d.node.global_lights = build.lit_globally > 0;
        const Within lit(build.lit_globally, takes_global_lights(block));
        take_children(build, d, at), d.limits = true;     // POV-Ray does not look into it
        for (const NodeId child : d.node.children) gather_lights(build.scene, child, d.node.light_group);
    } else if (!shape(build, block, at, d)) {
        return false;
    }
    d.node.from = build.position(block.place);
    take_modifiers(build, d, at);
    settle_union(build, d);
    return true;
}

/// One node, or two where transformations stand on both sides of the texture.
BuiltObject finish(Build& build, Draft& d) {
    while (!d.bounds.empty()) take_last_bound(build, d.bounds, d.node.bounds);
    if (d.layers.empty() && !d.inside.empty()) build.p.fail(d.texture_place, "an interior_texture needs a texture beside it, for the outside");
    if (d.layers.empty()) {
        d.node.to_parent = d.transform;
        return {build.add_node(std::move(d.node)), d.limits};
    }
    const MaterialId material = add_material(build, std::move(d.layers), d.texture_place);
    const bool moved = !d.before.is_identity();
    Node* carrier = &d.node;
    Node outer;
    if (moved) {
        outer.from = d.node.from;
        outer.flags.uv_mapping = std::exchange(d.node.flags.uv_mapping, false);
        d.node.to_parent = d.before;
        carrier = &outer;
    }
    if (carrier->materials.empty()) carrier->materials.resize(1);
    carrier->materials[0] = material;
    if (!d.inside.empty()) carrier->inside_material = add_material(build, std::move(d.inside), d.texture_place);
    if (moved) {
        const NodeId inner = build.add_node(std::move(d.node));
        outer.children.push_back(inner);
    }
    carrier->to_parent = d.transform;
    return {build.add_node(std::move(*carrier)), false};
}

}  // namespace

std::optional<BuiltObject> build_object(Build& build, const Block& block, const Transform& placed) {
    if (block.word == "light_source"_w) return BuiltObject{build_light(build, block), false};
    Draft d;
    d.placed = placed;
    return draft(build, block, d) ? std::optional(finish(build, d)) : std::nullopt;
}

}  // namespace alidade::pov
