// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/textures.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

constexpr size_t kMostLayers = 1000;

void set_colour(Build& build, const std::array<double, 5>& c, Place at, PovFinish& layer) {
    Signal& signal = build.scene.signals.emplace_back();
    signal.what = ConstantSignal{Vec4(c[0], c[1], c[2], 1), c[3], c[4]};
    signal.from = build.position(at);
    layer.pigment = {uint32_t(build.scene.signals.size() - 1)};
}

/// Until patterns are built: middle grey, opaque.
void stand_in(Build& build, const Item& item, const char* what, PovFinish& layer) {
    const std::string_view word = item.kind == Item::Kind::word || item.value.kind == Kind::block ? kWords[item.value.kind == Kind::block ? item.block().word : item.word] : "a function";
    build.p.tally(item.place, fmt::format("the pattern {} of a {} is not modelled yet: middle grey stands for it", word, what));
    set_colour(build, {0.5, 0.5, 0.5, 0, 0}, item.place, layer);
}

/// The layer of a `texture` block that is not layered: as its parts say.
void apply_texture(Build& build, const Block& block, TextureLayers& layers) {
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("texture"_w)) at.next(), layers = build_texture(build, *base);
        else if (const Block* pigment = at.block_at("pigment"_w)) at.next(), build_pigment(build, *pigment, layers.back());
        else if (const Block* finish = at.block_at("finish"_w)) at.next(), build_finish(build, *finish, layers.back());
        else if (at.at_transform()) at.transform();                  // moves patterns alone
        else if (at.at_block("normal"_w) || at.at_word("uv_mapping"_w) || at.at_word("no_bump_scale"_w)) at.skip_unmodelled();
        else if (at.peek().kind == Item::Kind::word || at.any_block()) {
            stand_in(build, at.peek(), "texture", layers.back());
            return;
        } else at.skip_unmodelled();
    }
}

/// What `#default { ... }` makes of the default texture.
PovFinish changed_default(Build& build, const Block& block, PovFinish layer) {
    for (Cursor at(build, block); !at.done();) {
        if (const Block* texture = at.block_at("texture"_w)) at.next(), layer = build_texture(build, *texture).back();
        else if (const Block* pigment = at.block_at("pigment"_w)) at.next(), build_pigment(build, *pigment, layer);
        else if (const Block* finish = at.block_at("finish"_w)) at.next(), build_finish(build, *finish, layer);
        else at.skip_unmodelled();
    }
    return layer;
}

}  // namespace

PovFinish default_texture(Build& build, uint32_t count) {
    std::vector<PovFinish>& known = build.default_textures;
    if (known.empty()) {
        PovFinish first;
        set_colour(build, {0, 0, 0, 0, 0}, {}, first);
        known.push_back(first);
    }
    count = uint32_t(std::min<size_t>(count, build.defaults.size()));
    while (known.size() <= count) {                                  // in order: each asks for those before it alone
        const PovFinish next = changed_default(build, build.defaults[known.size() - 1].as<Block>(), known.back());
        known.push_back(next);
    }
    return known[count];
}

TextureLayers build_texture(Build& build, const Block& block) {
    const Nested nested(build.p, block.place);
    TextureLayers layers{default_texture(build, block.defaults)};
    apply_texture(build, block, layers);
    for (const Ref<Block>& layer : block.layers) {
        const TextureLayers more = build_texture(build, *layer);
        if (layers.size() + more.size() > kMostLayers) build.p.fail_limit(block.place, fmt::format("the texture has more than {} layers", kMostLayers));
        layers.insert(layers.end(), more.begin(), more.end());
    }
    return layers;
}

void build_pigment(Build& build, const Block& block, PovFinish& layer) {
    const Nested nested(build.p, block.place);
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("pigment"_w)) at.next(), build_pigment(build, *base, layer);
        else if (at.at_numeric()) {
            const Place place = at.place();
            set_colour(build, at.colour("a pigment"), place, layer);
        } else if (at.accept("quick_color"_w) || at.accept("quick_colour"_w)) {
            if (at.at_numeric()) at.next();
        } else if (at.at_transform()) at.transform();                // one colour everywhere: nothing moves
        else return stand_in(build, at.peek(), "pigment", layer);
    }
}

MaterialId add_material(Build& build, TextureLayers layers, Place at) {
    Material material;
    material.from = build.position(at);
    material.name = fmt::format("texture {}", build.scene.materials.size());
    for (PovFinish& layer : layers) material.layers.emplace_back(std::move(layer));
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
