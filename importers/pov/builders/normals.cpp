// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/textures.h"

#include <fmt/format.h>

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

/// The normals behind the name of a pattern of blocks, or the depth behind another one's. Of normals that are missing each is the default one.
void read_behind_pattern(Build& build, Cursor& at, ReliefSignal& r) {
    const size_t length = list_length(r.pattern);
    r.pattern.map.clear();
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
}

void read_normal(Build& build, Cursor& at, ReliefSignal& r) {
    std::optional<ReliefSignal> settled;   // a declared normal that is uv_mapped stays as it is, whatever follows (probed)
    while (!at.done()) {
        if (const Block* base = at.block_at("normal"_w)) {
            at.next();
            const SignalId normal = build_normal(build, *base, default_texture(build, base->defaults).normal);
            const bool uv_mapped = r.pattern.uv_mapped;
            r = std::get<ReliefSignal>(build.scene.signals[normal.index].what);
            settled = r.pattern.uv_mapped ? std::optional(r) : std::nullopt;
            r.pattern.uv_mapped |= uv_mapped;   // `uv_mapping N`: stays, as nothing else does
            if (at.at_number()) r.amount = at.number("the depth of a normal");
        } else if (take_pattern(build, at, r.pattern, &r.amount)) read_behind_pattern(build, at, r);
        else if (const Block* map = at.block_at("normal_map"_w)) at.next(), read_normal_map(build, *map, r.pattern.map);
        else if (const Block* slopes = at.block_at("slope_map"_w)) at.next(), read_slope_map(build, *slopes, r.slopes);
        else if (at.accept("bump_size"_w)) r.amount = at.number("the depth of a normal");
        else if (at.accept("accuracy"_w)) r.accuracy = at.number("the accuracy of a normal");
        else if (at.accept("no_bump_scale"_w)) r.scaled = !at.flag();
        else if (take_pattern_modifier(build, at, r.pattern)) continue;
        else at.skip_unmodelled_pattern();
    }
    if (settled) r = std::move(*settled);
}

}  // namespace

bool is_flat(const Build& build, SignalId normal) { return std::get<ReliefSignal>(build.scene.signals[normal.index].what).pattern.pattern.empty(); }

SignalId build_normal(Build& build, const Block& block, std::optional<SignalId> start, size_t skipped) {
    const Nested nested(build.p, block.place);
    const std::pair key(&block, start);
    const auto known = build.normals.find(key);
    if (known != build.normals.end()) return known->second;
    ReliefSignal relief = start ? std::get<ReliefSignal>(build.scene.signals[start->index].what) : ReliefSignal();
    Cursor at(build, block, skipped);
    read_normal(build, at, relief);
    if (!(relief.accuracy > 0)) build.p.fail(block.place, "the accuracy of a normal must be greater than 0");
    const SignalId id = build.add_signal(std::move(relief), block.place);
    build.normals.emplace(key, id);
    return id;
}

}  // namespace alidade::pov
