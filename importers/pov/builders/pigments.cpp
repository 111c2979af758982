// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/pigments.h"

#include "importers/pov/builders/default_maps.h"
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/textures.h"
#include "scene/graph.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

/// `[V COLOUR]`, or the old `[V1 V2 COLOUR COLOUR]`.
void read_colour_entry(Build& build, const Block& entry, std::vector<MapEntry>& map) {
    Cursor in(build, entry);
    const double first = map_position(in);
    const bool two = in.at_number();
    const double second = two ? map_position(in) : first;
    map.push_back({first, add_colour(build, in.colour("the colour of a map"), entry.place)});
    if (two && !in.done()) map.push_back({second, add_colour(build, in.colour("the colour of a map"), entry.place)});
}

/// The pigment that a new one begins with.
SignalId usual_pigment(Build& build, const Block& block) { return default_texture(build, block.defaults).pigment; }

void read_pigment_entry(Build& build, const Block& entry, std::vector<MapEntry>& map) {
    const MapPlace place = place_in_map(build, entry);
    map.push_back({place.value, build_pigment(build, entry, usual_pigment(build, entry), place.skipped)});
}

/// The colours or pigments behind the name of a pattern of blocks.
void read_list(Build& build, Cursor& at, PatternSignal& s) {
    const size_t length = list_length(s);
    if (!length) return;
    s.map.clear();
    while (s.map.size() < length) {
        const double value = double(s.map.size());
        const Place place = at.place();
        if (const Block* pigment = at.block_at("pigment"_w)) at.next(), s.map.push_back({value, build_pigment(build, *pigment, usual_pigment(build, *pigment))});
        else if (at.at_numeric()) s.map.push_back({value, add_colour(build, at.colour("a colour of a pattern"), place)});
        else break;
    }
}

bool take_maps(Build& build, Cursor& at, PatternSignal& s) {
    const bool colours = at.at_block("color_map"_w) || at.at_block("colour_map"_w);
    if (!colours && !at.at_block("pigment_map"_w)) return false;
    s.map.clear();
    const Block& block = *at.any_block();
    at.next();
    for_each_entry(build, block, [&](const Block& entry) { (colours ? read_colour_entry : read_pigment_entry)(build, entry, s.map); });
    return true;
}

/// False where what stands there is none of a pattern's, and nothing is read.
bool take_patterned(Build& build, Cursor& at, Signal& pigment) {
    const auto* known = std::get_if<PatternSignal>(&pigment.what);
    PatternSignal s = known ? *known : PatternSignal();
    if (take_pattern(build, at, s)) read_list(build, at, s);
    else if (!take_maps(build, at, s) && !take_pattern_modifier(build, at, s)) return false;
    pigment.what = std::move(s);
    return true;
}

bool is_quick_color(Cursor& at) { return at.accept("quick_color"_w) || at.accept("quick_colour"_w); }

void read_pigment(Build& build, Cursor& at, Signal& pigment) {
    while (!at.done()) {
        if (const Block* base = at.block_at("pigment"_w)) {
            at.next();
            pigment = Signal(build.scene.signals[build_pigment(build, *base, usual_pigment(build, *base)).index]);
        } else if (at.at_numeric()) {
            const std::array<double, 5> c = at.colour("a pigment");
            pigment.what = ConstantSignal{Vec4(c[0], c[1], c[2], 1), c[3], c[4]};
        } else if (is_quick_color(at)) {
            if (at.at_numeric()) at.next();
        } else if (!take_patterned(build, at, pigment)) {
            at.refuse_misplaced();
            tally_pattern(build, at.peek(), "pigment");
            pigment.what = ConstantSignal{Vec4(0.5, 0.5, 0.5, 1)};
            return;
        }
    }
}

}  // namespace

void tally_pattern(Build& build, const Item& item, const char* what) {
    const bool block = item.value.kind == Kind::block;
    const std::string_view word = block || item.kind == Item::Kind::word ? kWords[block ? item.block().word : item.word] : "a function";
    build.p.tally(item.place, fmt::format("the pattern {} of a {} is not modelled yet: middle grey stands for it", word, what));
}

std::vector<MapEntry> read_colour_map(Build& build, const Block& block) {
    std::vector<MapEntry> map;
    for_each_entry(build, block, [&](const Block& entry) { read_colour_entry(build, entry, map); });
    return map;
}

SignalId add_colour(Build& build, const std::array<double, 5>& c, Place at) {
    return build.add_signal(ConstantSignal{Vec4(c[0], c[1], c[2], 1), c[3], c[4]}, at);
}

SignalId build_pigment(Build& build, const Block& block, SignalId start, size_t skipped) {
    const Nested nested(build.p, block.place);
    const std::pair key(&block, start);
    const auto known = build.pigments.find(key);
    if (known != build.pigments.end()) return known->second;
    Signal pigment = build.scene.signals[start.index];
    Cursor at(build, block, skipped);
    read_pigment(build, at, pigment);
    // A modifier without a pattern, and a colour instead of one, leave one colour everywhere.
    if (auto* pattern = std::get_if<PatternSignal>(&pigment.what)) {
        if (pattern->pattern.empty()) pigment = Signal(build.scene.signals[start.index]);
        else if (pattern->pattern != kImageMap && (pattern->pattern != "average" || pattern->map.empty())) add_default_map(build, *pattern);
    }
    pigment.from = build.position(block.place);
    const SignalId id = build.add_signal(std::move(pigment));
    build.pigments.emplace(key, id);
    return id;
}

SignalId moved(Build& build, SignalId id, const Transform& transform) {
    Signal signal = build.scene.signals[id.index];
    if (auto* pattern = std::get_if<PatternSignal>(&signal.what)) move(*pattern, transform);
    else if (auto* relief = std::get_if<ReliefSignal>(&signal.what)) move(relief->pattern, transform);
    else return id;
    return build.add_signal(std::move(signal));
}

SignalId moved_in_space(Build& build, SignalId id, const Transform& transform) {
    const PatternSignal* pattern = pattern_of(build.scene.signals[id.index]);
    return pattern && pattern->uv_mapped ? id : moved(build, id, transform);
}

}  // namespace alidade::pov
