// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/textures.h"

#include <fmt/format.h>
#include <utility>

namespace alidade::pov {

namespace {

void read_slope_map(Build& build, const Block& block, std::vector<SlopeEntry>& slopes) {
    slopes.clear();
    for_each_entry(build, block, [&](const Block& entry) {
        Cursor in(build, entry);
        const double value = map_position(in);
        const Vec3 slope = in.vector("a height and a slope", 2);
        slopes.push_back({value, slope.x, slope.y});
    });
}

SignalId flat_part(Build& build, Place place) {
    ReliefSignal flat;
    flat.pattern.pattern = "bumps", flat.amount = 0;
    return build.add_signal(flat, place);
}

/// One of several normals, which begins with what the default texture has.
SignalId part(Build& build, const Block& block, size_t skipped) {
    const SignalId normal = build_normal(build, block, default_texture(build, block.defaults).normal, skipped);
    return is_flat(build, normal) ? flat_part(build, block.place) : normal;
}

SignalId usual_part(Build& build, const Block& beside) {
    const std::optional<SignalId> usual = default_texture(build, beside.defaults).normal;
    return usual && !is_flat(build, *usual) ? *usual : flat_part(build, beside.place);
}

void read_normal_map(Build& build, const Block& block, std::vector<MapEntry>& map) {
    map.clear();
    for_each_entry(build, block, [&](const Block& entry) {
        const MapPlace place = place_in_map(build, entry);
        map.push_back({place.value, part(build, entry, place.skipped)});
    });
}

/// A normal that is being read.
struct NormalDraft {
    ReliefSignal relief;
    std::optional<ReliefSignal> around;   ///< Build::around_uv_normals: what follows changes that instead
};

NormalDraft normal_draft(const Build& build, std::optional<SignalId> start) {
    if (!start) return {};
    const auto around = build.around_uv_normals.find(*start);
    return {std::get<ReliefSignal>(build.scene.signals[start->index].what), around == build.around_uv_normals.end() ? std::nullopt : std::optional(around->second)};
}

SignalId finish_normal(Build& build, NormalDraft&& d, Place at) {
    if (!(d.relief.accuracy > 0)) build.p.fail(at, "the accuracy of a normal must be greater than 0");
    const SignalId id = build.add_signal(std::move(d.relief), at);
    if (d.around) build.around_uv_normals.emplace(id, std::move(*d.around));
    return id;
}

/// The normals behind the name of a pattern of blocks, or the depth behind another one's. Of normals that are missing each is the default one.
void read_behind_pattern(Build& build, Cursor& at, NormalDraft& d) {
    ReliefSignal& r = d.around ? *d.around : d.relief;
    const size_t length = list_length(r.pattern);
    if (length || !d.around) r.pattern.map.clear();
    const Block* last = nullptr;
    while (r.pattern.map.size() < length) {
        const Block* normal = at.block_at("normal"_w);
        if (!normal) break;
        at.next();
        r.pattern.map.push_back({double(r.pattern.map.size()), part(build, *normal, 0)});
        last = normal;
    }
    while (last && r.pattern.map.size() < length) r.pattern.map.push_back({double(r.pattern.map.size()), usual_part(build, *last)});
    if (at.at_number()) r.amount = at.number("the depth of a normal");
    if (d.around) d.relief = *std::exchange(d.around, {});
}

void read_normal(Build& build, Cursor& at, NormalDraft& d);

/// `uv_mapping` and all behind it: a normal of its own, which begins as the default one does.
void read_uv_mapped_normal(Build& build, Cursor& at, NormalDraft& d) {
    const Place place = at.place();
    at.next();
    NormalDraft inside = normal_draft(build, default_texture(build, at.block().defaults).normal);
    read_normal(build, at, inside);
    const SignalId id = finish_normal(build, std::move(inside), place);
    d = {std::get<ReliefSignal>(build.scene.signals[id.index].what), {}};
    if (d.relief.pattern.pattern.empty()) return;
    d.relief.pattern.uv_mapped = true;
    d.around.emplace().pattern.map = {{0, id}};
}

void read_normal(Build& build, Cursor& at, NormalDraft& d) {
    bool open = true;
    while (!at.done()) {
        ReliefSignal& r = d.around ? *d.around : d.relief;
        if (const Block* base = at.block_at("normal"_w)) {
            at.next();
            d = normal_draft(build, build_normal(build, *base, default_texture(build, base->defaults).normal));
            if (at.at_number()) (d.around ? *d.around : d.relief).amount = at.number("the depth of a normal");
            continue;
        }
        if (at.at_word("uv_mapping"_w)) {
            if (!open) build.p.fail(at.place(), "uv_mapping must stand before the pattern, and what changes it");
            return read_uv_mapped_normal(build, at, d);
        }
        open = false;
        if (take_pattern(build, at, r.pattern, &r.amount)) read_behind_pattern(build, at, d);
        else if (const Block* map = at.block_at("normal_map"_w)) at.next(), read_normal_map(build, *map, r.pattern.map);
        else if (const Block* slopes = at.block_at("slope_map"_w)) at.next(), read_slope_map(build, *slopes, r.slopes);
        else if (at.accept("bump_size"_w)) r.amount = at.number("the depth of a normal");
        else if (at.accept("accuracy"_w)) r.accuracy = at.number("the accuracy of a normal");
        else if (at.accept("no_bump_scale"_w)) r.scaled = !at.flag();
        else if (take_pattern_modifier(build, at, r.pattern)) continue;
        else at.skip_unmodelled_pattern();
    }
}

}  // namespace

bool is_flat(const Build& build, SignalId normal) { return std::get<ReliefSignal>(build.scene.signals[normal.index].what).pattern.pattern.empty(); }

SignalId build_normal(Build& build, const Block& block, std::optional<SignalId> start, size_t skipped) {
    const std::pair key(&block, start);
    const auto known = build.normals.find(key);
    if (known != build.normals.end()) return known->second;
    NormalDraft d = normal_draft(build, start);
    Cursor at(build, block, skipped);
    read_normal(build, at, d);
    const SignalId id = finish_normal(build, std::move(d), block.place);
    build.normals.emplace(key, id);
    return id;
}

}  // namespace alidade::pov
