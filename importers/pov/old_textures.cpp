// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/old_textures.h"

#include "eval/patterns/registry.h"
#include "importers/pov/words.h"

#include <algorithm>

namespace alidade::pov {

namespace {

constexpr WordId kFinish[] = {"ambient"_w, "diffuse"_w, "brilliance"_w, "phong"_w, "phong_size"_w, "specular"_w, "roughness"_w, "metallic"_w, "crand"_w, "reflection"_w, "ior"_w, "refraction"_w, "caustics"_w, "irid"_w};
/// Patterns that are reliefs there, and what is said of reliefs alone.
constexpr WordId kNormal[] = {"bumps"_w, "dents"_w, "ripples"_w, "waves"_w, "wrinkles"_w, "bump_map"_w, "bump_size"_w, "frequency"_w, "phase"_w};
constexpr WordId kPigment[] = {"color_map"_w, "colour_map"_w, "image_map"_w, "quick_color"_w, "quick_colour"_w, "turbulence"_w, "octaves"_w, "omega"_w, "lambda"_w};

template <size_t N> bool contains(const WordId (&list)[N], WordId word) { return std::find(std::begin(list), std::end(list), word) != std::end(list); }

bool is_block(const OpenItem& item) { return item.value.kind == Kind::block; }
WordId word_of(const OpenItem& item) { return is_block(item) ? item.block().word : item.word; }

WordId home_of(WordId word) {
    if (contains(kFinish, word)) return "finish"_w;
    if (contains(kNormal, word)) return "normal"_w;
    return contains(kPigment, word) || find_pattern(kWords[word]) ? "pigment"_w : WordId(0);
}

/// For each item of a texture: "pigment", "normal" or "finish", where it belongs if it stands in no block of that name; 0 if it is none of theirs.
std::vector<WordId> homes_in_texture(std::span<const OpenItem> items) {
    std::vector<WordId> homes;
    const bool mapped = items.size() > 1 && std::any_of(items.begin() + 1, items.end(), [](const OpenItem& i) { return is_block(i) && (word_of(i) == "texture"_w || word_of(i) == "texture_map"_w); });
    for (const OpenItem& item : items) {
        const bool value = !is_block(item) && item.kind != Item::Kind::word;
        WordId home = homes.empty() ? WordId(0) : homes.back();                   // a value goes with the word before it
        if (!value) home = home_of(word_of(item));
        else if (item.value.kind == Kind::colour) home = "pigment"_w;
        homes.push_back(mapped && home == "pigment"_w ? WordId(0) : home);        // the pattern of textures
    }
    return homes;
}

OpenItem plain_word(WordId word, Place at) {
    OpenItem item;
    item.kind = Item::Kind::word, item.place = at, item.word = word;
    return item;
}

/// Has the word of an item a value behind it? Not the names of most patterns.
bool takes_value(const OpenItem& item) {
    static constexpr WordId kLeading[] = {"gradient"_w, "mandel"_w, "julia"_w, "spiral1"_w, "spiral2"_w};
    return item.kind == Item::Kind::word && (contains(kLeading, item.word) || contains(kNormal, item.word) || !find_pattern(kWords[item.word]));
}

/// A number that nothing before it asks for is that of crand (probed: wherever it stands). Takes what the items hold.
std::vector<OpenItem> with_crand(std::span<OpenItem> items) {
    std::vector<OpenItem> out;
    bool asked = false;
    for (OpenItem& item : items) {
        if (!asked && item.kind == Item::Kind::value && item.value.kind == Kind::number) out.push_back(plain_word("crand"_w, item.place));
        asked = takes_value(item);
        out.push_back(std::move(item));
    }
    return out;
}

/// What stands in the block in place of `run`; takes what they hold.
std::vector<OpenItem> contents(std::span<OpenItem> run) {
    std::vector<OpenItem> out;
    for (OpenItem& item : run) {
        const bool waves = item.kind == Item::Kind::word && (item.word == "marble"_w || item.word == "wood"_w);
        const Place at = item.place;
        out.push_back(std::move(item));
        if (waves) out.push_back(plain_word("ramp_wave"_w, at));     // they get triangles in a pigment alone
    }
    return out;
}

}  // namespace

std::vector<OpenItem> with_blocks_for_old_words(std::span<OpenItem> written, const Ref<Meter>& meter, const BlockStanding& where) {
    std::vector<OpenItem> items = with_crand(written);
    const std::vector<WordId> homes = homes_in_texture(items);
    std::vector<OpenItem> out;
    for (size_t i = 0, end; i < items.size(); i = end) {
        end = i + 1;
        if (!homes[i]) {
            out.push_back(std::move(items[i]));
            continue;
        }
        while (end < items.size() && homes[end] == homes[i]) ++end;
        OpenItem part = plain_word(homes[i], items[i].place);
        std::vector<OpenItem> inside = contents(std::span(items).subspan(i, end - i));
        const Ref<Block> block = Block::of(inside, meter);
        block->word = part.word, block->place = part.place, block->stands(where);
        part.kind = Item::Kind::block, part.value = Value::of(Kind::block, block);
        out.push_back(std::move(part));
    }
    return out;
}

}  // namespace alidade::pov
