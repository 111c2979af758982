// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/space_functions.h"

#include "eval/patterns/space_pigments.h"
#include "importers/pov/builders/globals.h"
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/pigments.h"

#include <fmt/format.h>
#include <unordered_map>

namespace alidade::pov {

const Block* block_of(const Function& function) {
    const bool one = function.parts.size() == 1 && function.parts[0].value.kind == Kind::block;
    return one ? &function.parts[0].value.as<Block>() : nullptr;
}

const InternalFunction* internal_of(const Parser& p, const Function& function) {
    const std::vector<Function::Part>& parts = function.parts;
    if (parts.size() != 4 || !parts[0].token.is_word("internal"_w) || !parts[1].token.is('(') || parts[2].token.kind != TokenKind::number || !parts[3].token.is(')')) return nullptr;
    const double number = parts[2].token.number;
    const InternalFunction* row = find_internal_function(number);
    if (row) return row;
    std::string known;
    for (const InternalFunction& other : internal_functions()) known += fmt::format("{}{}", known.empty() ? "" : ", ", other.name);
    p.fail(function.place, fmt::format("internal({}) is not modelled yet", number), "those of functions.inc that are: " + known);
}

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

/// What was made of the blocks that were asked.
struct SpaceFunctions::Stage {
    explicit Stage(Parser& p) : build(p), pigments(build.scene) {
        build.scene.settings.noise = usual_noise(p);
        set_usual_gamma(p, build);
        settings = p.globals.size();
    }
    /// Loops make functions without end; when there are many, the next one begins anew.
    bool is_full(const Parser& p) const {
        constexpr size_t kFunctions = 1000, kSignals = 100'000;
        return patterns.size() + colours.size() >= kFunctions || build.scene.signals.size() > kSignals || settings != p.globals.size();
    }

    Build build;
    SpacePigments pigments;
    size_t settings = 0;             ///< global_settings when it was made
    std::vector<Ref<Block>> held;    ///< so that no other block comes to stand where one stood
    std::unordered_map<const Block*, Pattern> patterns;
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

Pattern build_pattern(Build& build, SpacePigments& pigments, const Block& block) {
    const Nested nested(build.p, block.place);
    PatternSignal signal;
    for (Cursor at(build, block); !at.done();) {
        if (take_pattern(build, at, signal) || (!signal.pattern.empty() && take_pattern_modifier(build, at, signal))) continue;
        const Item& item = at.peek();
        const bool named = item.kind == Item::Kind::word || at.any_block();
        build.p.fail(item.place, fmt::format("{} in the pattern of a function is not modelled", named ? kWords[at.any_block() ? at.any_block()->word : item.word] : "a value"));
    }
    if (signal.pattern.empty()) build.p.fail(block.place, "the name of a pattern is expected in pattern { }");
    if (signal.source) prepare(build.p, pigments, *signal.source, block.place);
    auto made = pigments.make(signal);
    if (!made) build.p.fail(block.place, made.error());
    if (!made->row().value && !signal.source && signal.pattern != "image_pattern") build.p.fail(block.place, fmt::format("the pattern {} has no number", signal.pattern));
    return std::move(*made);
}

}  // namespace

double SpaceFunctions::pattern(const Block& block, const Vec3& at) {
    Stage& s = stage();
    auto known = s.patterns.find(&block);
    if (known == s.patterns.end()) {
        s.held.emplace_back(const_cast<Block*>(&block));             // also if it fails: the builders keep what they made of its parts
        Pattern made = build_pattern(s.build, s.pigments, block);
        known = s.patterns.emplace(&block, std::move(made)).first;
    }
    return known->second.value(at);
}

std::array<double, 5> SpaceFunctions::pigment(const Block& block, const Vec3& at) {
    Stage& s = stage();
    auto known = s.colours.find(&block);
    if (known == s.colours.end()) {
        s.held.emplace_back(const_cast<Block*>(&block));
        const SignalId signal = build_pigment(s.build, block, plain_pigment(s.build));
        prepare(p_, s.pigments, signal, block.place);
        known = s.colours.emplace(&block, signal).first;
    }
    const PigmentColor c = s.pigments.color(known->second, at);
    return {c.color.x, c.color.y, c.color.z, c.filter, c.transmit};
}

}  // namespace alidade::pov
