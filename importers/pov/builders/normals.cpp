// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/pigments.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

void read_slope_map(Build& build, const Block& block, std::vector<SlopeEntry>& slopes) {
    const Nested nested(build.p, block.place);
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.any_block()) at.next(), read_slope_map(build, *base, slopes);
        else if (at.peek().kind == Item::Kind::entry) {
            Cursor in(build, at.next().block());
            const double value = in.number("the place of a slope");
            const Vec3 slope = in.vector("a height and a slope");
            slopes.push_back({value, slope.x, slope.y});
        } else at.skip_unmodelled();
    }
}

SignalId flat(Build& build) {
    Signal& signal = build.scene.signals.emplace_back();
    ReliefSignal relief;
    relief.pattern.pattern = "bumps", relief.amount = 0;
    signal.what = relief;
    return {uint32_t(build.scene.signals.size() - 1)};
}

SignalId normal_or_flat(Build& build, const Block& block, size_t skipped) {
    const auto normal = build_normal(build, block, std::nullopt, skipped);
    return normal ? *normal : flat(build);
}

void read_normal_map(Build& build, const Block& block, std::vector<MapEntry>& map) {
    const Nested nested(build.p, block.place);
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.any_block()) at.next(), read_normal_map(build, *base, map);
        else if (at.peek().kind == Item::Kind::entry) {
            const Block& entry = at.next().block();
            const MapPlace place = place_in_map(build, entry);
            map.push_back({place.value, normal_or_flat(build, entry, place.skipped)});
        } else at.skip_unmodelled();
    }
}

/// The normals behind the name of a pattern of blocks, or the depth behind another one's.
void read_behind_pattern(Build& build, Cursor& at, ReliefSignal& r) {
    const size_t length = list_length(r.pattern);
    r.pattern.map.clear();
    while (r.pattern.map.size() < length) {
        const Block* normal = at.block_at("normal"_w);
        if (!normal) break;
        at.next();
        r.pattern.map.push_back({double(r.pattern.map.size()), normal_or_flat(build, *normal, 0)});
    }
    if (at.at_number()) r.amount = at.number("the depth of a normal");
}

void read_normal(Build& build, Cursor& at, ReliefSignal& r) {
    while (!at.done()) {
        if (const Block* base = at.block_at("normal"_w)) {
            at.next();
            if (const auto normal = build_normal(build, *base, std::nullopt)) r = std::get<ReliefSignal>(build.scene.signals[normal->index].what);
        } else if (take_pattern(build, at, r.pattern)) read_behind_pattern(build, at, r);
        else if (const Block* map = at.block_at("normal_map"_w)) at.next(), r.pattern.map.clear(), read_normal_map(build, *map, r.pattern.map);
        else if (const Block* slopes = at.block_at("slope_map"_w)) at.next(), r.slopes.clear(), read_slope_map(build, *slopes, r.slopes);
        else if (at.accept("bump_size"_w)) r.amount = at.number("the depth of a normal");
        else if (at.accept("accuracy"_w)) r.accuracy = at.number("the accuracy of a normal");
        else if (at.accept("no_bump_scale"_w)) r.scaled = !at.flag();
        else if (take_pattern_modifier(build, at, r.pattern)) continue;
        else at.skip_unmodelled();
    }
}

}  // namespace

std::optional<SignalId> build_normal(Build& build, const Block& block, std::optional<SignalId> start, size_t skipped) {
    const Nested nested(build.p, block.place);
    const std::pair key(&block, start);
    const auto known = build.normals.find(key);
    if (known != build.normals.end()) return known->second;
    ReliefSignal relief = start ? std::get<ReliefSignal>(build.scene.signals[start->index].what) : ReliefSignal();
    Cursor at(build, block, skipped);
    read_normal(build, at, relief);
    std::optional<SignalId> id;
    if (!(relief.accuracy > 0)) build.p.fail(block.place, "the accuracy of a normal must be greater than 0");
    if (!relief.pattern.pattern.empty()) {
        Signal& signal = build.scene.signals.emplace_back();
        signal.what = std::move(relief);
        signal.from = build.position(block.place);
        id = SignalId{uint32_t(build.scene.signals.size() - 1)};
    }
    build.normals.emplace(key, id);
    return id;
}

}  // namespace alidade::pov
