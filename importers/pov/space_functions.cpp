// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/space_functions.h"

#include "eval/patterns/space_pigments.h"
#include "importers/pov/builders/functions.h"
#include "importers/pov/builders/globals.h"

#include <fmt/format.h>
#include <unordered_map>

namespace alidade::pov {

NoiseGenerator usual_noise(const Parser& p) {
    NoiseGenerator noise = p.version_given && p.version < 3.5 - 1e-9 ? NoiseGenerator::original : NoiseGenerator::range_corrected;
    for (const Value& settings : p.globals) {
        const std::span<const Item> items = settings.as<Block>().items();
        for (size_t i = 0; i + 1 < items.size(); ++i) {
            if (items[i].kind != Item::Kind::word || items[i].word != "noise_generator"_w || items[i + 1].value_kind() != Kind::number) continue;
            const double number = items[i + 1].number();
            noise = NoiseGenerator(number >= 1 ? number <= 3 ? int(number) : 3 : 1);
        }
    }
    return noise;
}

namespace {

/// What the colours of pictures become: as the first assumed_gamma has it.
void set_usual_gamma(const Parser& p, Build& build) {
    for (const Value& settings : p.globals) {
        const std::span<const Item> items = settings.as<Block>().items();
        for (size_t i = 0; i + 1 < items.size(); ++i) {
            if (items[i].kind != Item::Kind::word || items[i].word != "assumed_gamma"_w) continue;
            const Item& what = items[i + 1];
            build.scene.settings.srgb_coded = what.kind == Item::Kind::word;
            if (what.value_kind() == Kind::number && what.number() > 0) build.scene.settings.assumed_gamma = what.number();
            return;
        }
    }
}

}  // namespace

/// What was made of the functions that were asked.
struct SpaceFunctions::Stage {
    explicit Stage(Parser& p) : build(p), pigments(build.scene) {
        build.scene.settings.noise = usual_noise(p);
        set_usual_gamma(p, build);
        settings = p.globals.size();
        pigments.turns = &turns;
    }
    /// Loops make functions without end; when there are many, the next one begins anew.
    bool is_full(const Parser& p) const {
        constexpr size_t kFunctions = 1000, kSignals = 100'000;
        return runners.size() + colours.size() >= kFunctions || build.scene.signals.size() > kSignals || settings != p.globals.size();
    }

    struct Ready {
        FunctionRunner runner;
        uint64_t steps;
    };

    Build build;
    SpacePigments pigments;
    uint64_t turns = 0;              ///< that loops may still make
    size_t settings = 0;             ///< global_settings when it was made
    std::vector<Ref<Shared>> held;   ///< so that nothing else comes to stand where something stood
    std::unordered_map<const Function*, Ready> runners;
    std::unordered_map<const Block*, SignalId> colours;
};

SpaceFunctions::SpaceFunctions(Parser& p) : p_(p) {}
SpaceFunctions::~SpaceFunctions() = default;

SpaceFunctions::Stage& SpaceFunctions::stage() {
    if (!stage_ || stage_->is_full(p_)) stage_ = std::make_unique<Stage>(p_);
    std::vector<Value>& defaults = stage_->build.defaults;
    for (size_t i = defaults.size(); i < p_.defaults.size(); ++i) defaults.push_back(p_.defaults[i].second);
    return *stage_;
}

namespace {

void prepare(Parser& p, SpacePigments& pigments, SignalId pigment, Place at) {
    const auto ready = pigments.prepare(pigment);
    if (!ready) p.fail(at, ready.error());
}

/// What one value costs, among the steps of the scene.
uint64_t price(double steps) {
    constexpr double kStepsOfOne = 8, kMost = 1e18;
    return uint64_t(std::min(steps / kStepsOfOne, kMost));
}

}  // namespace

double SpaceFunctions::number(const Function& function, std::span<const double> arguments, Place at) {
    Stage& s = stage();
    auto known = s.runners.find(&function);
    if (known == s.runners.end()) {
        s.held.emplace_back(const_cast<Function*>(&function));       // also if it fails: the builders keep what they made of its parts
        const FunctionId id = build_function(s.build, function);
        const FunctionWork work = function_work(s.build.scene, id);
        for (const auto& [asked, times] : work.asked) prepare(p_, s.pigments, asked, function.place);
        auto runner = s.pigments.runner(id);
        if (!runner) p_.fail(function.place, runner.error());
        known = s.runners.emplace(&function, Stage::Ready{std::move(*runner), price(work.steps)}).first;
    }
    const Stage::Ready& ready = known->second;
    const size_t parameters = s.build.scene.functions[s.build.functions.at(&function).index].parameters;
    if (parameters != arguments.size()) p_.fail(at, fmt::format("the function takes {} argument{}, and {} are given", parameters, parameters == 1 ? "" : "s", arguments.size()));
    p_.charge(ready.steps, at);
    const uint64_t most = p_.options.limits.loop_turns;
    s.turns = most - std::min(most, p_.loop_turns);
    const uint64_t before = s.turns;
    const double value = ready.runner.value(arguments);
    p_.loop_turns += before - s.turns;
    if (s.turns == 0) p_.fail_limit(function.place, &Limits::loop_turns, fmt::format("the loops of the scene have made more than {} turns: does one never end?", most));
    return value;
}

std::array<double, 5> SpaceFunctions::pigment(const Block& block, const Vec3& at) {
    Stage& s = stage();
    auto known = s.colours.find(&block);
    if (known == s.colours.end()) {
        s.held.emplace_back(const_cast<Block*>(&block));
        const SignalId signal = build_function_pigment(s.build, block);
        prepare(p_, s.pigments, signal, block.place);
        known = s.colours.emplace(&block, signal).first;
    }
    s.turns = p_.options.limits.loop_turns;
    return components(s.pigments.color(known->second, at));
}

}  // namespace alidade::pov
