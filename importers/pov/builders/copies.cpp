// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/copies.h"

#include "importers/pov/builders/patterns.h"
#include "scene/graph.h"
#include "scene/queries.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace alidade::pov {

namespace {

/// Signals are looked up by functions that call themselves, on the stacks of threads; those of a pattern of pigments by more of them, those of functions by more yet.
constexpr uint32_t kDeepestSignal = 4000, kLevelsOfASource = 4, kLevelsOfAFunction = 8;

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

/// Bounds are asked of each ray, one inside the other, by functions that call one another.
void check_bounds(Build& build) {
    const Scene& scene = build.scene;
    const auto parts = [&](uint32_t i, const auto& f) { for_each_link(scene, scene.nodes[i], [&](NodeId part) { f(part.index); }); };
    const std::vector<uint32_t> order = topological_order(scene.nodes.size(), parts).sequence;
    std::vector<uint32_t> levels(scene.nodes.size(), 0);
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Node& node = scene.nodes[*i];
        parts(*i, [&](uint32_t part) { levels[*i] = std::max(levels[*i], levels[part]); });
        for (const NodeId bound : node.bounds) levels[*i] = std::max(levels[*i], levels[bound.index] + 1);
        constexpr uint32_t kDeepest = 100;
        if (levels[*i] > kDeepest) return build.p.said.error(node.from, fmt::format("what bounds objects is itself bounded, more than {} levels deep", kDeepest));
    }
}

/// How many entries of a map are looked up where the most are, each as often as `looked_up(entry)`: all of an `average`, one of a pattern of blocks, else
/// those on both sides of a place in the map.
template <class F> double most_looked_up(const PatternSignal& pattern, const F& looked_up) {
    std::vector<size_t> order(pattern.map.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return pattern.map[a].value < pattern.map[b].value; });
    const bool all = pattern.pattern == "average", one = list_length(pattern) > 0;
    double most = 0, sum = 0;
    for (size_t i = 0; i < order.size(); ++i) {
        const double here = looked_up(order[i]);
        const bool mixed = !one && i > 0 && pattern.map[order[i - 1]].value < pattern.map[order[i]].value;
        most = std::max(most, mixed ? here + looked_up(order[i - 1]) : here);
        sum += here;
    }
    return all ? sum : most;
}

/// Each point of a surface may ask for all that a pigment or a normal is made of, as often as it is named. What each signal looks up.
std::vector<double> check_signals(Build& build) {
    const Scene& scene = build.scene;
    const auto operands = [&](uint32_t i, const auto& f) { for_each_operand(scene, scene.signals[i], [&](SignalId of) { f(of.index); }); };
    const std::vector<uint32_t> order = topological_order(scene.signals.size(), operands).sequence;
    std::vector<double> looked_up(scene.signals.size(), 1);
    std::vector<uint32_t> levels(scene.signals.size(), 0);
    uint32_t largest = kNoId;
    const auto ask_function = [&](FunctionId function, uint32_t i) {
        const FunctionWork work = function_work(scene, function);
        looked_up[i] += work.steps;
        for (const auto& [of, times] : work.asked) {
            looked_up[i] += times * looked_up[of.index];
            levels[i] = std::max(levels[i], levels[of.index] + kLevelsOfAFunction + work.calls);
        }
    };
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Signal& signal = scene.signals[*i];
        const PatternSignal* pattern = pattern_of(signal);
        if (pattern) looked_up[*i] += most_looked_up(*pattern, [&](size_t entry) { return looked_up[pattern->map[entry].signal.index]; });
        if (pattern && pattern->function) ask_function(*pattern->function, *i);
        if (pattern && pattern->source) looked_up[*i] += looked_up[pattern->source->index];
        if (!pattern) operands(*i, [&](uint32_t of) { looked_up[*i] += looked_up[of]; });
        operands(*i, [&](uint32_t of) { levels[*i] = std::max(levels[*i], levels[of] + (pattern && pattern->source && pattern->source->index == of ? kLevelsOfASource : 1)); });
        if (levels[*i] > kDeepestSignal) return build.p.said.error(signal.from, fmt::format("pigments, normals or patterns of pigments stand more than {} levels deep in one another", kDeepestSignal / kLevelsOfASource)), looked_up;
        if (largest == kNoId || looked_up[*i] > looked_up[largest]) largest = *i;
    }
    if (largest != kNoId && looked_up[largest] > double(build.p.options.limits.copies))
        say_too_many(build, scene.signals[largest].from, looked_up[largest], "pigments or normals that are named in one another make one of which each point looks up {} parts: the limit is {}");
    return looked_up;
}

/// The same of textures.
void check_materials(Build& build, const std::vector<double>& looked_up_of_signals) {
    const Scene& scene = build.scene;
    const auto parts = [&](uint32_t i, const auto& f) { for_each_part(scene.materials[i], [&](MaterialId id) { f(id.index); }); };
    const std::vector<uint32_t> order = topological_order(scene.materials.size(), parts).sequence;
    std::vector<double> looked_up(scene.materials.size(), 0);
    uint32_t largest = kNoId;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const Material& material = scene.materials[*i];
        for_each_signal(material, [&](SignalId of) { looked_up[*i] += looked_up_of_signals[of.index]; });
        for (const auto& layer : material.layers) {
            const auto* map = std::get_if<PovTextureMap>(&layer);
            const PatternSignal* pattern = map ? pattern_of(scene.signals[map->pattern.index]) : nullptr;
            if (pattern && pattern->map.size() == map->textures.size()) looked_up[*i] += most_looked_up(*pattern, [&](size_t entry) { return looked_up[map->textures[entry].index]; });
            else if (map) for (const MaterialId id : map->textures) looked_up[*i] = std::max(looked_up[*i], looked_up[id.index]);
        }
        if (largest == kNoId || looked_up[*i] > looked_up[largest]) largest = *i;
    }
    if (largest != kNoId && looked_up[largest] > double(build.p.options.limits.copies))
        say_too_many(build, scene.materials[largest].from, looked_up[largest], "textures that are named in one another make one of which each point looks up {} parts: the limit is {}");
}

}  // namespace

void check_copies(Build& build) {
    check_objects(build);
    check_bounds(build);
    const std::vector<double> looked_up = check_signals(build);
    if (!build.p.said.has_errors()) check_materials(build, looked_up);
}

}  // namespace alidade::pov
