// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/copies.h"

#include "importers/pov/builders/patterns.h"
#include "scene/graph.h"
#include "scene/queries.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

void say_too_many(Build& build, const SourcePos& at, double copies, const std::string& what) {
    const Limits& limits = build.p.options.limits;
    build.p.said.error(at, fmt::format(fmt::runtime(what), fmt::format("{:.3g}", copies), limits.copies), how_to_raise(limits, &Limits::copies, copies));
}

void check_objects(Build& build) {
    const Scene& scene = build.scene;
    const std::vector<double> below = path_counts(scene);
    double copies = -double(scene.nodes.size());
    for (const NodeId root : scene.roots) copies += below[root.index];
    if (copies <= double(build.p.options.limits.copies)) return;
    const NodeId largest = *std::max_element(scene.roots.begin(), scene.roots.end(), [&](NodeId a, NodeId b) { return below[a.index] < below[b.index]; });
    say_too_many(build, scene.nodes[largest.index].from, copies, "objects that are named more than once make {} copies, most of them in this object: the limit is {}");
}

/// How many signals are looked up where the most are: all of an `average`, one of a pattern of blocks, else those on both sides of a place in the map.
double most_looked_up(const PatternSignal& pattern, const std::vector<double>& looked_up) {
    std::vector<MapEntry> map = pattern.map;
    std::stable_sort(map.begin(), map.end(), [](const MapEntry& a, const MapEntry& b) { return a.value < b.value; });
    const bool all = pattern.pattern == "average", one = list_length(pattern) > 0;
    double most = 0, sum = 0;
    for (size_t i = 0; i < map.size(); ++i) {
        const double here = looked_up[map[i].signal.index];
        const bool mixed = !one && i > 0 && map[i - 1].value < map[i].value;
        most = std::max(most, mixed ? here + looked_up[map[i - 1].signal.index] : here);
        sum += here;
    }
    return (all ? sum : most) + (pattern.source ? looked_up[pattern.source->index] : 0);
}

void check_signals(Build& build) {
    const Scene& scene = build.scene;
    const auto operands = [&](uint32_t i, const auto& f) { for_each_operand(scene.signals[i], [&](SignalId of) { f(of.index); }); };
    const std::vector<uint32_t> order = topological_order(scene.signals.size(), operands).sequence;
    std::vector<double> looked_up(scene.signals.size(), 1);
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Signal& signal = scene.signals[*i];
        if (const PatternSignal* pattern = pattern_of(signal)) looked_up[*i] += most_looked_up(*pattern, looked_up);
        else operands(*i, [&](uint32_t of) { looked_up[*i] += looked_up[of]; });
        if (looked_up[*i] > double(build.p.options.limits.copies))
            return say_too_many(build, signal.from, looked_up[*i], "pigments or normals that are named in one another make one of which each point looks up {} parts: the limit is {}");
    }
}

}  // namespace

void check_copies(Build& build) {
    check_objects(build);
    check_signals(build);
}

}  // namespace alidade::pov
