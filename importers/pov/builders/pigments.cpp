// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/pigments.h"

#include "importers/pov/builders/default_maps.h"
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/textures.h"
#include "scene/graph.h"

#include <fmt/format.h>
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

/// A pigment that is being read.
struct PigmentDraft {
    Signal pigment;
    PatternSignal loose;                  ///< of a plain colour: what modifiers change, for a pattern that may take its place
    std::optional<ConstantSignal> quick;
    std::optional<PatternSignal> around;  ///< Build::around_uv: what modifiers change instead
};

/// What a pigment begins with that begins as `start` does: not with its colours, if it has those of its pattern.
PigmentDraft pigment_draft(const Build& build, SignalId start) {
    const auto known = [](const auto& table, SignalId id) {
        const auto there = table.find(id);
        return there == table.end() ? std::nullopt : std::optional(there->second);
    };
    PigmentDraft d{build.scene.signals[start.index], known(build.loose_modifiers, start).value_or(PatternSignal()), known(build.quick_colors, start), known(build.around_uv, start)};
    if (build.without_maps.contains(start)) std::get<PatternSignal>(d.pigment.what).map.clear();
    return d;
}

SignalId finish_pigment(Build& build, PigmentDraft&& d, Place at) {
    auto* pattern = d.around ? nullptr : std::get_if<PatternSignal>(&d.pigment.what);
    const bool without_map = pattern && pattern->map.empty() && !list_length(*pattern), plain = std::holds_alternative<ConstantSignal>(d.pigment.what);
    if (pattern && pattern->pattern != kImageMap && (pattern->pattern != "average" || pattern->map.empty())) add_default_map(build, *pattern);
    d.pigment.from = build.position(at);
    const SignalId id = build.add_signal(std::move(d.pigment));
    if (plain) build.loose_modifiers.emplace(id, std::move(d.loose));
    if (without_map) build.without_maps.insert(id);
    if (d.quick) build.quick_colors.emplace(id, *d.quick);
    if (d.around) build.around_uv.emplace(id, std::move(*d.around));
    return id;
}

/// False where what stands there is none of a pattern's, and nothing is read.
bool take_patterned(Build& build, Cursor& at, PigmentDraft& d) {
    auto* pattern = std::get_if<PatternSignal>(&d.pigment.what);
    PatternSignal& s = d.around ? *d.around : pattern ? *pattern : d.loose;
    if (take_pattern(build, at, s)) {
        read_list(build, at, s);
        if (d.around) d.pigment.what = *std::exchange(d.around, {});
        else if (!pattern) d.pigment.what = std::exchange(d.loose, {});
        return true;
    }
    if (!take_maps(build, at, s)) return take_pattern_modifier(build, at, s);
    if (d.around) d.pigment.what = build.scene.signals[s.map.front().signal.index].what;    // the number of POV-Ray's own pattern is 0 (probed)
    return true;
}

void take_colour(Cursor& at, PigmentDraft& d) {
    const std::array<double, 5> c = at.colour("a pigment");
    if (d.around) d.loose = *std::exchange(d.around, {});
    else if (auto* hidden = std::get_if<PatternSignal>(&d.pigment.what)) d.loose = std::move(*hidden);   // all but its name is there for another one
    d.pigment.what = ConstantSignal{Vec4(c[0], c[1], c[2], 1), c[3], c[4]};
}

bool is_quick_color(Cursor& at) { return at.accept("quick_color"_w) || at.accept("quick_colour"_w); }

void read_pigment(Build& build, Cursor& at, PigmentDraft& d);

/// `uv_mapping` and all behind it: a pigment of its own, which begins as the default one does.
void read_uv_mapped(Build& build, Cursor& at, PigmentDraft& d) {
    const Place place = at.place();
    at.next();
    PigmentDraft inside = pigment_draft(build, usual_pigment(build, at.block()));
    read_pigment(build, at, inside);
    const SignalId id = finish_pigment(build, std::move(inside), place);
    d = pigment_draft(build, id);
    d.pigment = build.scene.signals[id.index];   // with the colours that its pattern has
    if (auto* pattern = std::get_if<PatternSignal>(&d.pigment.what)) pattern->uv_mapped = true;
    d.around.emplace().map = {{0, id}};
}

void read_pigment(Build& build, Cursor& at, PigmentDraft& d) {
    bool open = true;       // a colour or a pattern may stand before its modifiers alone
    while (!at.done()) {
        if (const Block* base = at.block_at("pigment"_w)) {
            at.next();
            d = pigment_draft(build, build_pigment(build, *base, usual_pigment(build, *base)));
        } else if (at.at_numeric() && (std::exchange(open, false) || (at.at_colour() && at.block().version < 3))) {
            take_colour(at, d);
        } else if (is_quick_color(at)) {
            open = false;
            if (!at.at_numeric()) continue;
            const std::array<double, 5> c = at.colour("quick_color");
            d.quick = ConstantSignal{Vec4(c[0], c[1], c[2], 1), c[3], c[4]};
        } else if (at.at_word("uv_mapping"_w)) {
            if (!open) build.p.fail(at.place(), "uv_mapping must stand before the colour or the pattern, and what changes it");
            return read_uv_mapped(build, at, d);
        } else if (take_patterned(build, at, d)) {
            open = false;
        } else {
            at.refuse_misplaced();
            if (at.at_numeric()) at.skip_unmodelled();
            tally_pattern(build, at.peek(), "pigment");
            d.pigment.what = ConstantSignal{Vec4(0.5, 0.5, 0.5, 1)}, d.around.reset();
            return;
        }
    }
}

}  // namespace

void tally_pattern(Build& build, const Item& item, const char* what) {
    if (item.value_kind() == Kind::function) return;     // what it calls was told
    constexpr std::string_view kPatterns[] = {"object", "slope", "aoi", "pavement", "tiling", "density_file"};
    const bool block = item.value_kind() == Kind::block;
    const std::string_view word = block || item.kind == Item::Kind::word ? kWords[block ? item.block().word : item.word] : "a value";
    if (std::find(std::begin(kPatterns), std::end(kPatterns), word) == std::end(kPatterns)) build.p.fail(item.place, fmt::format("{} cannot stand in this {}", word, what));
    build.p.tally(item.place, fmt::format("{} as the pattern of a {} is not modelled yet: middle grey stands for it", word, what));
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
    const std::pair key(&block, start);
    const auto known = build.pigments.find(key);
    if (known != build.pigments.end()) return known->second;
    PigmentDraft d = pigment_draft(build, start);
    Cursor at(build, block, skipped);
    read_pigment(build, at, d);
    const SignalId id = finish_pigment(build, std::move(d), block.place);
    build.pigments.emplace(key, id);
    return id;
}

namespace {

/// A plain colour looks the same wherever it is; a pattern that takes its place is where it was.
SignalId moved_plain(Build& build, SignalId id, const Transform& transform) {
    PatternSignal loose = build.loose_modifiers[id];
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
    if (const auto quick = build.quick_colors.find(id); quick != build.quick_colors.end()) build.quick_colors.emplace(there, quick->second);
    if (build.without_maps.contains(id)) build.without_maps.insert(there);
    return there;
}

void show_quick_colors(Build& build) {
    for (const auto& [pigment, quick] : build.quick_colors) build.scene.signals[pigment.index].what = quick;
}

namespace {

/// What says uv_mapping stays; `around` is the pattern that POV-Ray has around it, which was moved.
template <class T> SignalId with_around(Build& build, SignalId id, std::map<SignalId, T>& table, T around) {
    const SignalId same = build.add_signal(Signal(build.scene.signals[id.index]));
    table.emplace(same, std::move(around));
    if (const auto quick = build.quick_colors.find(id); quick != build.quick_colors.end()) build.quick_colors.emplace(same, quick->second);
    return same;
}

}  // namespace

SignalId moved_in_space(Build& build, SignalId id, const Transform& transform) {
    Signal signal = build.scene.signals[id.index];
    PatternSignal* pattern = pattern_of(signal);
    if (const auto there = build.around_uv.find(id); there != build.around_uv.end()) {
        PatternSignal around = there->second;
        move(around, transform);
        return with_around(build, id, build.around_uv, std::move(around));
    }
    if (const auto there = build.around_uv_normals.find(id); there != build.around_uv_normals.end()) {
        ReliefSignal around = there->second;
        move(around.pattern, transform);
        return with_around(build, id, build.around_uv_normals, std::move(around));
    }
    if (!pattern || !pattern->uv_mapped) return moved(build, id, transform);
    if (!pattern->bumps_turn) return id;
    pattern->bumps_turned = transform.linear * pattern->bumps_turned;
    return build.add_signal(std::move(signal));
}

}  // namespace alidade::pov
