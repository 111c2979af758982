// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/pigments.h"

#include "importers/pov/builders/default_maps.h"
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/textures.h"
#include "scene/graph.h"

#include <fmt/format.h>
#include <tuple>
#include <utility>

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
    if (!in.done()) in.skip_unmodelled();
}

/// The pigment that a new one begins with.
SignalId usual_pigment(Build& build, const Block& block) { return default_texture(build, block.defaults).pigment; }

void read_pigment_entry(Build& build, const Block& entry, std::vector<MapEntry>& map) {
    const MapPlace place = place_in_map(build, entry);
    map.push_back({place.value, build_pigment(build, entry, usual_pigment(build, entry), place.skipped)});
}

/// The colours or pigments behind the name of a pattern of blocks. Of pigments that are missing each is the default one.
void read_list(Build& build, Cursor& at, PatternSignal& s) {
    const size_t length = list_length(s);
    if (!length) return;
    s.map.clear();
    std::optional<SignalId> missing;
    while (s.map.size() < length) {
        const double value = double(s.map.size());
        const Place place = at.place();
        if (const Block* pigment = at.block_at("pigment"_w)) at.next(), missing = usual_pigment(build, *pigment), s.map.push_back({value, build_pigment(build, *pigment, *missing)});
        else if (at.at_numeric()) s.map.push_back({value, add_colour(build, at.colour("a colour of a pattern"), place)});
        else break;
    }
    while (missing && s.map.size() < length) s.map.push_back({double(s.map.size()), *missing});
}

/// Patterns of blocks have lists of their own instead, and an average has pigments.
bool take_maps(Build& build, Cursor& at, PatternSignal& s) {
    const bool colours = at.at_block("color_map"_w) || at.at_block("colour_map"_w);
    if (!colours && !at.at_block("pigment_map"_w)) return false;
    const Block& block = *at.any_block();
    if (list_length(s) || (colours && s.pattern == "average")) build.p.fail(at.place(), fmt::format("{} cannot stand behind the pattern {}", kWords[block.word], s.pattern));
    s.map.clear();
    at.next();
    for_each_entry(build, block, [&](const Block& entry) { (colours ? read_colour_entry : read_pigment_entry)(build, entry, s.map); });
    return true;
}

/// What modifiers change: the pattern, or what a plain colour keeps for one that may take its place.
PatternSignal& modified(Signal& pigment, PatternSignal& loose) {
    auto* pattern = std::get_if<PatternSignal>(&pigment.what);
    return pattern ? *pattern : loose;
}

/// False where what stands there is none of a pattern's, and nothing is read.
bool take_patterned(Build& build, Cursor& at, Signal& pigment, PatternSignal& loose) {
    const bool known = std::holds_alternative<PatternSignal>(pigment.what);
    PatternSignal& s = modified(pigment, loose);
    if (!take_pattern(build, at, s)) return take_maps(build, at, s) || take_pattern_modifier(build, at, s);
    read_list(build, at, s);
    if (!known) pigment.what = std::exchange(loose, {});
    return true;
}

/// What a pigment begins with that begins as `start` does: not with its colours, if it has those of its pattern.
Signal copy_of(const Build& build, SignalId start) {
    Signal copy = build.scene.signals[start.index];
    if (build.without_maps.contains(start)) std::get<PatternSignal>(copy.what).map.clear();
    return copy;
}

PatternSignal loose_of(const Build& build, SignalId plain) {
    const auto known = build.loose_modifiers.find(plain);
    return known == build.loose_modifiers.end() ? PatternSignal() : known->second;
}

std::optional<ConstantSignal> quick_color_of(const Build& build, SignalId pigment) {
    const auto known = build.quick_colors.find(pigment);
    return known == build.quick_colors.end() ? std::nullopt : std::optional(known->second);
}

bool is_quick_color(Cursor& at) { return at.accept("quick_color"_w) || at.accept("quick_colour"_w); }

void read_pigment(Build& build, Cursor& at, Signal& pigment, PatternSignal& loose, std::optional<ConstantSignal>& quick) {
    bool open = true;       // a colour or a pattern may stand before its modifiers alone
    std::optional<std::pair<Signal, PatternSignal>> settled;   // a declared pigment that is uv_mapped stays as it is, whatever follows (probed)
    while (!at.done()) {
        if (const Block* base = at.block_at("pigment"_w)) {
            at.next();
            const SignalId id = build_pigment(build, *base, usual_pigment(build, *base));
            const bool uv_mapped = modified(pigment, loose).uv_mapped;
            pigment = copy_of(build, id), loose = loose_of(build, id), quick = quick_color_of(build, id);
            settled = modified(pigment, loose).uv_mapped ? std::optional(std::pair(pigment, loose)) : std::nullopt;
            modified(pigment, loose).uv_mapped |= uv_mapped;   // `uv_mapping P`: stays, as nothing else does
        } else if (at.at_numeric() && (std::exchange(open, false) || (at.at_colour() && at.block().version < 3))) {
            const std::array<double, 5> c = at.colour("a pigment");
            if (auto* hidden = std::get_if<PatternSignal>(&pigment.what)) loose = std::move(*hidden);   // all but its name is there for another one
            pigment.what = ConstantSignal{Vec4(c[0], c[1], c[2], 1), c[3], c[4]};
        } else if (is_quick_color(at)) {
            open = false;
            if (!at.at_numeric()) continue;
            const std::array<double, 5> c = at.colour("quick_color");
            quick = ConstantSignal{Vec4(c[0], c[1], c[2], 1), c[3], c[4]};
        } else if (at.at_word("uv_mapping"_w)) {
            take_patterned(build, at, pigment, loose);
        } else if (take_patterned(build, at, pigment, loose)) {
            open = false;
        } else {
            at.refuse_misplaced();
            if (at.at_numeric()) at.skip_unmodelled();
            tally_pattern(build, at.peek(), "pigment");
            pigment.what = ConstantSignal{Vec4(0.5, 0.5, 0.5, 1)};
            return;
        }
    }
    if (settled) std::tie(pigment, loose) = std::move(*settled);
}

}  // namespace

void tally_pattern(Build& build, const Item& item, const char* what) {
    constexpr std::string_view kPatterns[] = {"a function", "object", "slope", "aoi", "pavement", "tiling", "density_file"};
    const bool block = item.value_kind() == Kind::block;
    const std::string_view word = block || item.kind == Item::Kind::word ? kWords[block ? item.block().word : item.word] : "a function";
    if (std::find(std::begin(kPatterns), std::end(kPatterns), word) == std::end(kPatterns)) build.p.fail(item.place, fmt::format("{} cannot stand in this {}", word, what));
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

SignalId plain_pigment(Build& build) { return default_texture(build, 0).pigment; }

SignalId build_pigment(Build& build, const Block& block, SignalId start, size_t skipped) {
    const Nested nested(build.p, block.place);
    const std::pair key(&block, start);
    const auto known = build.pigments.find(key);
    if (known != build.pigments.end()) return known->second;
    Signal pigment = copy_of(build, start);
    Cursor at(build, block, skipped);
    PatternSignal loose = loose_of(build, start);
    std::optional<ConstantSignal> quick = quick_color_of(build, start);
    read_pigment(build, at, pigment, loose, quick);
    auto* pattern = std::get_if<PatternSignal>(&pigment.what);
    const bool without_map = pattern && pattern->map.empty() && !list_length(*pattern);
    if (pattern && pattern->pattern != kImageMap && (pattern->pattern != "average" || pattern->map.empty())) add_default_map(build, *pattern);
    pigment.from = build.position(block.place);
    const bool plain = !pattern;
    const SignalId id = build.add_signal(std::move(pigment));
    if (plain) build.loose_modifiers.emplace(id, std::move(loose));
    if (without_map) build.without_maps.insert(id);
    if (quick) build.quick_colors.emplace(id, *quick);
    build.pigments.emplace(key, id);
    return id;
}

namespace {

/// A plain colour looks the same wherever it is; a pattern that takes its place is where it was.
SignalId moved_plain(Build& build, SignalId id, const Transform& transform) {
    PatternSignal loose = loose_of(build, id);
    move(loose, transform);
    const SignalId there = build.add_signal(Signal(build.scene.signals[id.index]));
    build.loose_modifiers.emplace(there, std::move(loose));
    return there;
}

SignalId moved_signal(Build& build, SignalId id, const Transform& transform) {
    Signal signal = build.scene.signals[id.index];
    if (auto* pattern = std::get_if<PatternSignal>(&signal.what)) move(*pattern, transform);
    else if (auto* relief = std::get_if<ReliefSignal>(&signal.what)) move(relief->pattern, transform);
    else return moved_plain(build, id, transform);
    return build.add_signal(std::move(signal));
}

}  // namespace

SignalId moved(Build& build, SignalId id, const Transform& transform) {
    const SignalId there = moved_signal(build, id, transform);
    if (const auto quick = quick_color_of(build, id)) build.quick_colors.emplace(there, *quick);
    if (build.without_maps.contains(id)) build.without_maps.insert(there);
    return there;
}

void show_quick_colors(Build& build) {
    for (const auto& [pigment, quick] : build.quick_colors) build.scene.signals[pigment.index].what = quick;
}

SignalId moved_in_space(Build& build, SignalId id, const Transform& transform) {
    Signal signal = build.scene.signals[id.index];
    PatternSignal* pattern = pattern_of(signal);
    if (!pattern || !pattern->uv_mapped) return moved(build, id, transform);
    if (!pattern->bumps_turn) return id;
    pattern->bumps_turned = transform.linear * pattern->bumps_turned;
    return build.add_signal(std::move(signal));
}

}  // namespace alidade::pov
