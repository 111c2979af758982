// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/textures.h"

#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/pictures.h"
#include "importers/pov/builders/pigments.h"
#include "scene/graph.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

constexpr size_t kMostLayers = 1000;

/// A texture while its block is read.
struct Draft {
    TextureLayers layers;
    PatternSignal pattern;               ///< of the map; without a name as long as there is none
    std::vector<MaterialId> textures;
    bool uv_mapped = false;
};

/// A texture of a map, made once however often maps have it.
MaterialId part(Build& build, const Block& block, size_t skipped) {
    const Block* key = &block;
    if (block.items().size() == skipped + 1)
        if (const Block* only = Cursor(build, block, skipped).block_at("texture"_w)) key = only;
    const auto known = build.parts.find(key);
    if (known != build.parts.end()) return known->second;
    const MaterialId id = add_material(build, build_texture(build, block, skipped), block.place);
    build.parts.emplace(key, id);
    return id;
}

void add_entry(Draft& d, double value, MaterialId texture, SignalId unused) {
    d.pattern.map.push_back({value, unused});
    d.textures.push_back(texture);
}

void read_texture_map(Build& build, const Block& block, Draft& d) {
    d.pattern.map.clear(), d.textures.clear();
    for_each_entry(build, block, [&](const Block& entry) {
        const MapPlace place = place_in_map(build, entry);
        add_entry(d, place.value, part(build, entry, place.skipped), default_texture(build, 0).pigment);
    });
}

/// Until there are `length` of them.
void read_list(Build& build, Cursor& at, Draft& d, size_t length) {
    while (d.textures.size() < length) {
        const Block* texture = at.block_at("texture"_w);
        if (!texture) break;
        at.next();
        add_entry(d, double(d.textures.size()), part(build, *texture, 0), default_texture(build, 0).pigment);
    }
}

/// The textures behind the name of a pattern of blocks. Of those that are missing each is the default one.
void read_blocks(Build& build, Cursor& at, Draft& d) {
    const size_t length = list_length(d.pattern);
    const Block* first = at.block_at("texture"_w);
    read_list(build, at, d, length);
    while (first && d.textures.size() < length) add_entry(d, double(d.textures.size()), default_material(build, first->defaults), default_texture(build, 0).pigment);
}

/// `tiles { texture { } tile2 texture { } }`: an old name for a checker of two textures, the second of which is where a checker has its first.
void read_tiles(Build& build, const Block& block, Draft& d) {
    d.pattern.pattern = "checker", d.pattern.parameters.clear();
    d.pattern.map.clear(), d.textures.clear();
    for (Cursor at(build, block); !at.done();) {
        if (at.accept("tile2"_w)) continue;
        const size_t before = d.textures.size();
        read_list(build, at, d, list_length(d.pattern));
        if (d.textures.size() == before) at.skip_unmodelled();
    }
    std::reverse(d.textures.begin(), d.textures.end());
}

/// The texture of a pixel's number: counted again and again, but the first number that there is no texture for has the last.
size_t numbered(size_t number, size_t textures) { return number == textures ? textures - 1 : number % textures; }

/// `material_map { png "file" texture { } ... }`.
void read_material_map(Build& build, const Block& block, Draft& d) {
    constexpr size_t kNumbers = 256;
    Cursor at(build, block);
    d.pattern.pattern = "image_pattern", d.pattern.parameters.clear();
    d.pattern.picture = take_picture(build, at);
    d.pattern.picture->value = PictureValue::number;
    d.pattern.map.clear(), d.textures.clear();
    std::vector<MaterialId> list;
    while (!at.done()) {
        if (const Block* texture = at.block_at("texture"_w)) at.next(), list.push_back(part(build, *texture, 0));
        else at.skip_unmodelled();
    }
    if (list.empty()) build.p.fail(block.place, "a material_map needs textures");
    for (size_t i = 0; i < kNumbers; ++i) add_entry(d, double(i), list[numbered(i, list.size())], default_texture(build, 0).pigment);
}

/// The pattern of a map, its entries and modifiers; false where none of them stands.
bool take_map(Build& build, Cursor& at, Draft& d) {
    if (take_pattern(build, at, d.pattern)) {
        d.pattern.map.clear(), d.textures.clear();
        read_blocks(build, at, d);
    } else if (const Block* tiles = at.block_at("tiles"_w)) {
        at.next();
        read_tiles(build, *tiles, d);
    } else if (const Block* numbers = at.block_at("material_map"_w)) {
        at.next();
        read_material_map(build, *numbers, d);
    } else if (const Block* map = at.block_at("texture_map"_w)) {
        at.next();
        read_texture_map(build, *map, d);
    } else {
        return !d.pattern.pattern.empty() && take_pattern_modifier(build, at, d.pattern);
    }
    return true;
}

void stand_in(Build& build, const Item& item, Draft& d) {
    tally_pattern(build, item, "texture");
    PovFinish grey = default_texture(build, 0);
    grey.pigment = add_colour(build, {0.5, 0.5, 0.5, 0, 0}, item.place);
    d.layers = {grey};
}

/// Calls f(signal, bends) for the signals of layers that have a place, and replaces them by what it returns. Those bend normals, or have textures in them that do.
template <class F> void replace_signals(TextureLayers& layers, const F& f) {
    for (auto& layer : layers) {
        if (auto* map = std::get_if<PovTextureMap>(&layer)) map->pattern = f(map->pattern, true);
        auto* finish = std::get_if<PovFinish>(&layer);
        if (!finish) continue;
        finish->pigment = f(finish->pigment, false);
        if (finish->normal) finish->normal = f(*finish->normal, true);
    }
}

/// Of one that is referred to: as declared, where it was declared.
TextureLayers declared_texture(Build& build, const Block& block) {
    TextureLayers layers;
    add_layers(build, layers, build_texture(build, block), block.version);
    return layers;
}

/// The layers of a `texture` block, without the further textures of a declared one.
void read_texture(Build& build, Cursor& at, Draft& d) {
    while (!at.done()) {
        if (const Block* base = at.block_at("texture"_w)) at.next(), d.layers = declared_texture(build, *base);
        else if (take_layer_part(build, at, d.layers) || take_map(build, at, d)) continue;
        else if (at.at_transform()) move_layers(build, d.layers, at.transform());
        else if (at.accept("uv_mapping"_w)) d.uv_mapped = true;
        else if (at.peek().kind == Item::Kind::word || at.any_block() || at.at_function()) return at.refuse_misplaced(), stand_in(build, at.peek(), d);
        else at.skip_unmodelled();
    }
    if (!d.textures.empty()) d.layers = {PovTextureMap{build.add_signal(std::move(d.pattern), at.place()), std::move(d.textures)}};
    if (d.uv_mapped) set_uv_mapped(build, d.layers, Bumps::turn);
}

/// What `#default { ... }` makes of the default texture.
PovFinish changed_default(Build& build, const Block& block, const PovFinish& before) {
    TextureLayers layers{before};
    for (Cursor at(build, block); !at.done();) {
        if (const Block* texture = at.block_at("texture"_w)) at.next(), layers = build_texture(build, *texture);
        else if (!take_layer_part(build, at, layers)) at.skip_unmodelled();
    }
    const auto* top = std::get_if<PovFinish>(&layers.back());
    if (!top) build.p.tally(block.place, "a map of textures as the default texture is not modelled yet: it is left out");
    if (!top) return before;
    PovFinish lowest = *top;
    lowest.uncolored = false;
    return lowest;
}

/// Of their colours POV-Ray's old versions keep what they filter.
bool is_of_pictures(const Scene& scene, SignalId pigment) {
    const auto* pattern = std::get_if<PatternSignal>(&scene.signals[pigment.index].what);
    if (!pattern) return false;
    if (pattern->pattern == kImageMap) return true;
    return !pattern->map.empty() && std::all_of(pattern->map.begin(), pattern->map.end(), [&](const MapEntry& entry) { return is_of_pictures(scene, entry.signal); });
}

}  // namespace

void add_layers(const Build& build, TextureLayers& layers, TextureLayers more, float version) {
    const size_t first = std::max<size_t>(layers.size(), 1);
    layers.insert(layers.end(), more.begin(), more.end());
    if (version > 3.1F) return;
    for (size_t i = first; i < layers.size(); ++i)
        if (auto* finish = std::get_if<PovFinish>(&layers[i]); finish && !is_of_pictures(build.scene, finish->pigment)) finish->uncolored = true;
}

void move_layers(Build& build, TextureLayers& layers, const Transform& t) {
    if (!t.is_identity()) replace_signals(layers, [&](SignalId id, bool) { return moved_in_space(build, id, t); });
}

void set_uv_mapped(Build& build, TextureLayers& layers, Bumps bumps) {
    replace_signals(layers, [&](SignalId id, bool bends) {
        Signal signal = build.scene.signals[id.index];
        PatternSignal* pattern = pattern_of(signal);
        if (!pattern) return id;
        const bool turn = bends && bumps == Bumps::turn;
        if (pattern->uv_mapped && pattern->bumps_turn == turn) return id;
        pattern->uv_mapped = true, pattern->bumps_turn = turn;
        return build.add_signal(std::move(signal));
    });
}

bool take_layer_part(Build& build, Cursor& at, TextureLayers& layers, const Transform& since) {
    const Block* block = at.any_block();
    if (!block || (block->word != "pigment"_w && block->word != "normal"_w && block->word != "finish"_w)) return false;
    auto* layer = std::get_if<PovFinish>(&layers.back());
    if (!layer) return at.skip_unmodelled(), true;                   // a map of textures has none of these
    const bool declared = at.at_declared();                           // `texture { P }`: instead of what was there
    at.next();
    if (block->word == "finish"_w) return (declared ? take_declared_finish : build_finish)(build, *block, *layer), true;
    const Transform back = inverse(since).value_or(Transform());
    const auto there = [&](SignalId id) { return since.is_identity() ? id : moved_in_space(build, id, since); };
    const auto here = [&](SignalId id) { return since.is_identity() ? id : moved_in_space(build, id, back); };
    const PovFinish start = declared ? default_texture(build, block->defaults) : *layer;
    if (block->word == "pigment"_w) {
        layer->pigment = here(build_pigment(build, *block, there(start.pigment)));
    } else {
        layer->normal = here(build_normal(build, *block, start.normal ? std::optional(there(*start.normal)) : default_texture(build, block->defaults).normal));
    }
    return true;
}

PovFinish default_texture(Build& build, uint32_t count) {
    std::vector<PovFinish>& known = build.default_textures;
    if (known.empty()) {
        PovFinish first;
        first.pigment = add_colour(build, {0, 0, 0, 0, 0}, {});
        known.push_back(first);
    }
    count = uint32_t(std::min<size_t>(count, build.defaults.size()));
    while (known.size() <= count) {                                  // in order: each asks for those before it alone
        const PovFinish next = changed_default(build, build.defaults[known.size() - 1].as<Block>(), known.back());
        known.push_back(next);
    }
    return known[count];
}

TextureLayers build_texture(Build& build, const Block& block, size_t skipped) {
    Draft d;
    d.layers = {default_texture(build, block.defaults)};
    Cursor at(build, block, skipped);
    read_texture(build, at, d);
    if (!block.layers) return std::move(d.layers);
    for (const Ref<Block>& layer : *block.layers) {
        TextureLayers more = build_texture(build, *layer);
        if (d.layers.size() + more.size() > kMostLayers) build.p.fail_limit(block.place, fmt::format("the texture has more than {} layers", kMostLayers));
        add_layers(build, d.layers, std::move(more), block.version);
    }
    return std::move(d.layers);
}

MaterialId add_material(Build& build, TextureLayers layers, Place at) {
    const auto is_map = [](const auto& layer) { return std::holds_alternative<PovTextureMap>(layer); };
    if (layers.size() > 1 && std::any_of(layers.begin(), layers.end(), is_map)) build.p.fail(at, "a texture with a map of textures cannot be one of several layers: POV-Ray refuses it, too");
    for (auto& layer : layers) {
        auto* finish = std::get_if<PovFinish>(&layer);
        if (finish && finish->normal && is_flat(build, *finish->normal)) finish->normal.reset();
    }
    Material material;
    material.from = build.position(at);
    material.name = fmt::format("texture {}", build.scene.materials.size());
    material.layers = std::move(layers);
    build.scene.materials.push_back(std::move(material));
    return {uint32_t(build.scene.materials.size() - 1)};
}

MaterialId default_material(Build& build, uint32_t count) {
    const auto known = build.default_materials.find(count);
    if (known != build.default_materials.end()) return known->second;
    const MaterialId id = add_material(build, {default_texture(build, count)}, {});
    build.default_materials.emplace(count, id);
    return id;
}

}  // namespace alidade::pov
