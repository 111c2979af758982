// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/commas.h"

#include "importers/pov/builtins/builtins.h"
#include "importers/pov/expressions.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade::pov {

namespace {

bool contains(std::initializer_list<WordId> words, WordId word) { return std::find(words.begin(), words.end(), word) != words.end(); }

/// Blocks that were asked.
bool was_tried(WordId block) {
    return contains({"sphere"_w, "box"_w, "plane"_w, "cylinder"_w, "cone"_w, "torus"_w, "disc"_w, "triangle"_w, "smooth_triangle"_w, "polygon"_w, "quadric"_w, "cubic"_w, "quartic"_w, "poly"_w, "text"_w, "mesh"_w, "mesh2"_w,
                     "union"_w, "merge"_w, "intersection"_w, "difference"_w, "object"_w, "light_group"_w, "light_source"_w, "camera"_w, "background"_w, "fog"_w, "sky_sphere"_w, "rainbow"_w, "global_settings"_w, "finish"_w,
                     "interior"_w, "material"_w, "texture"_w, "pigment"_w, "normal"_w, "transform"_w, "irid"_w, "clipped_by"_w, "color_map"_w, "colour_map"_w, "pigment_map"_w}, block);
}

/// `pigment { checker A, B, scale 2 }`: lists take a comma behind each part.
bool is_list_word(const OpenItem& item) {
    return item.kind == Item::Kind::word && contains({"checker"_w, "hexagon"_w, "brick"_w, "square"_w, "triangular"_w, "cubic"_w}, item.word);
}

/// `normal { gradient x, 0.5 }`: a comma may stand behind the pattern with what belongs to it, whether or not the depth of the bumps follows; none behind the depth.
bool lacks_depth(std::span<const OpenItem> before) {
    constexpr size_t kMostParts = 4;    // magnet 1 mandel 20
    const OpenItem &first = before.front(), &last = before.back();
    if (last.kind == Item::Kind::value && last.value_kind() == Kind::block && last.block().word == "normal"_w) return false;
    if (last.kind == Item::Kind::value && last.value_kind() == Kind::number)
        return before.size() <= kMostParts && first.kind == Item::Kind::word && contains({"spiral1"_w, "spiral2"_w, "mandel"_w, "julia"_w, "magnet"_w}, first.word);
    return before.size() <= 2;
}

/// Where one more value may follow, and is left out.
bool may_end_with_comma(WordId block, std::span<const OpenItem> before) {
    const OpenItem& last = before.back();
    const WordId ahead = before.size() > 1 && before[before.size() - 2].kind == Item::Kind::word ? before[before.size() - 2].word : 0;
    switch (block) {
        case "disc"_w: return before.size() == 3;                                   // its hole
        case "finish"_w: return ahead == "diffuse"_w;                               // of the back
        case "camera"_w: return ahead == "angle"_w || ahead == "blur_samples"_w;
        case "normal"_w: if (lacks_depth(before)) return true; break;
        case "object"_w:                                                            // a pattern in a pigment or a texture
            return last.value_kind() == Kind::colour || (last.value_kind() == Kind::block && contains({"pigment"_w, "normal"_w, "texture"_w}, last.block().word));
        case "pigment"_w: case "pigment_map"_w: case "texture"_w: break;
        default: return false;
    }
    const bool behind_number = block == "normal"_w && last.kind == Item::Kind::value && last.value_kind() == Kind::number;
    return !behind_number && last.kind != Item::Kind::word && ahead != "brick_size"_w && ahead != "mortar"_w && std::any_of(before.begin(), before.end(), is_list_word);
}

bool begins_value(const Token& token) {
    if (token.kind == TokenKind::word) return begins_colour(token) || find_builtin(token.id);
    if (token.kind == TokenKind::mark) return token.is('<') || token.is('(') || token.is('-') || token.is('+') || token.is('!');
    return true;      // names are known by what they hold alone
}

}  // namespace

void check_behind_comma(Parser& p, WordId block, std::span<const OpenItem> before, char close, const Token& comma, const Token& next) {
    if (next.is(',')) p.fail(next.place(), "a value is expected before the ,");
    if (begins_value(next) || !was_tried(block) || may_end_with_comma(block, before)) return;      // the first is what most are: a mesh has millions
    const bool of_entry = close == ']';
    if (of_entry && !next.is(close)) return;
    p.fail(comma.place(), fmt::format("a value is expected behind the , and not {}: POV-Ray refuses it, too", p.describe(next)), "leave the comma out");
}

}  // namespace alidade::pov
