// SPDX-License-Identifier: Apache-2.0
#include "eval/patterns/space_pigments.h"

#include "scene/graph.h"
#include "scene/queries.h"

namespace alidade {

namespace {

/// How many signals are looked up at a point, at the most: each as often as paths lead to it.
double lookups(const Scene& scene, SignalId root) {
    std::unordered_map<uint32_t, double> known;
    std::vector<SignalId> todo{root};
    while (!todo.empty()) {
        const SignalId id = todo.back();
        const size_t before = todo.size();
        const PatternSignal* pattern = pattern_of(scene.signals[id.index]);
        const FunctionWork work = pattern && pattern->function ? function_work(scene, *pattern->function) : FunctionWork();
        double sum = 1 + work.steps;
        for_each_operand(scene, scene.signals[id.index], [&](SignalId operand) {
            const auto there = known.find(operand.index);
            if (there == known.end()) todo.push_back(operand);
            else sum += there->second * (work.asked.contains(operand) ? work.asked.at(operand) : 1);
        });
        if (todo.size() > before) continue;
        known[id.index] = sum;
        todo.pop_back();
    }
    return known[root.index];
}

}  // namespace

tl::expected<void, std::string> SpacePigments::prepare(SignalId root) {
    constexpr double kMostLookups = 1e6;
    std::vector<SignalId> read;
    collect_signals(scene_, root, read);
    if (lookups(scene_, root) > kMostLookups) return tl::unexpected(std::string("the maps of this pigment lead to more than a million others"));
    for (const SignalId id : read) {
        const auto& what = scene_.signals[id.index].what;
        if (std::holds_alternative<ConstantSignal>(what) || patterns_.count(id.index)) continue;
        const auto* pattern = std::get_if<PatternSignal>(&what);
        if (!pattern) return tl::unexpected(std::string("only colours and patterns have a value in space"));
        auto made = make(*pattern);
        if (!made) return tl::unexpected(made.error());
        patterns_.emplace(id.index, std::move(*made));
    }
    return {};
}

tl::expected<Pattern, std::string> SpacePigments::make(const PatternSignal& signal) {
    PatternSource source;
    if (signal.source) source.grey = [this, pigment = *signal.source](const Vec3& place) { return pov_grey(color(pigment, place).color); };
    if (signal.function) {
        auto function = runner(*signal.function);
        if (!function) return tl::unexpected(function.error());
        source.grey = pattern_of_function(std::move(*function));
    }
    if (signal.picture) {
        auto picture = pictures_.get(*signal.picture, scene_);
        if (!picture) return tl::unexpected(picture.error());
        source.picture = std::move(*picture);
    }
    return Pattern::make(signal, std::move(source));
}

tl::expected<FunctionRunner, std::string> SpacePigments::runner(FunctionId function) const {
    const auto number_of = [this](SignalId pattern, const Vec3& p) { return number(pattern, p); };
    const auto color_of = [this](SignalId pigment, const Vec3& p) { return components(color(pigment, p)); };
    return FunctionRunner::make(scene_, function, {number_of, color_of, turns});
}

PigmentColor SpacePigments::color(SignalId pigment, const Vec3& p) const {
    const auto& what = scene_.signals[pigment.index].what;
    if (const auto* constant = std::get_if<ConstantSignal>(&what)) return {Color(constant->value), constant->filter, constant->transmit};
    const Pattern& pattern = patterns_.at(pigment.index);
    const std::vector<MapEntry>& map = std::get<PatternSignal>(what).map;
    const Vec3 at = pattern.place(p);
    if (pattern.shown()) return pattern.shown()->color(at);
    if (map.empty()) return {Color(pattern.value_at(at)), 0, 0};
    PigmentColor total;
    for_each_share(map, pattern, at, [&](uint32_t entry, double share) {
        const PigmentColor own = color(map[entry].signal, at);
        total = {total.color + own.color * share, total.filter + own.filter * share, total.transmit + own.transmit * share};
    });
    return total;
}

}  // namespace alidade
