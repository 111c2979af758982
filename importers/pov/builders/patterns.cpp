// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/patterns.h"

#include "eval/noise/single.h"
#include "eval/patterns/registry.h"
#include "importers/pov/builders/functions.h"
#include "importers/pov/builders/pictures.h"
#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/warps.h"

#include <algorithm>

namespace alidade::pov {

namespace {

/// Sets a parameter by the name that its row has; false if the pattern has none of that name.
bool set(PatternSignal& s, std::string_view name, double value) {
    const PatternOps* row = find_pattern(s.pattern);
    if (!row) return false;
    for (size_t i = 0; i < row->parameters.size(); ++i) {
        if (name != row->parameters[i].name) continue;
        while (s.parameters.size() <= i) s.parameters.push_back(row->parameters[s.parameters.size()].usual);
        s.parameters[i] = value;
        return true;
    }
    return false;
}

void set(PatternSignal& s, const std::string& name, const Vec3& v) {
    set(s, name + "x", v.x), set(s, name + "y", v.y), set(s, name + "z", v.z);
}

void take_complex(Cursor& at, PatternSignal& s) {
    const Vec3 c = at.vector("the constant of a julia set", 2);
    set(s, "c.re", c.x), set(s, "c.im", c.y);
}

/// `magnet TYPE mandel N`, `magnet TYPE julia <a, b>, N`.
bool take_magnet(Build& build, Cursor& at, PatternSignal& s) {
    const Place place = at.place();
    at.next();
    const double type = at.number("the type of a magnet set");
    const bool julia = at.at_word("julia"_w);
    if (!julia && !at.at_word("mandel"_w)) build.p.fail(place, "mandel or julia is expected behind magnet and its type");
    at.next();
    s.pattern = julia ? "magnet_julia" : "magnet_mandel";
    set(s, "type", type);
    if (julia) take_complex(at, s);
    set(s, "iterations", at.number("the number of iterations"));
    return true;
}

/// The values that stand behind a pattern's name.
void take_leading(Build& build, Cursor& at, WordId word, PatternSignal& s) {
    switch (word) {
        case "gradient"_w: return set(s, "", at.vector("the direction of a gradient"));
        case "spiral1"_w:
        case "spiral2"_w: set(s, "arms", std::trunc(at.number("the number of arms"))); return;   // `4 -.3` is 3.7
        case "julia"_w: take_complex(at, s); [[fallthrough]];
        case "mandel"_w: set(s, "iterations", at.number("the number of iterations")); return;
        case "waves"_w:
        case "ripples"_w: set(s, "number_of_waves", build.number_of_waves); return;
        default: return;
    }
}

struct Parameter {
    WordId word;
    const char* name;
    const char* second;   ///< a second number may follow
};
constexpr Parameter kParameters[] = {
    {"agate_turb"_w, "agate_turb", nullptr}, {"control0"_w, "control0", nullptr}, {"control1"_w, "control1", nullptr}, {"metric"_w, "metric", nullptr},
    {"offset"_w, "offset", nullptr}, {"mortar"_w, "mortar", nullptr}, {"exponent"_w, "exponent", nullptr}, {"exterior"_w, "exterior", "exterior factor"},
    {"interior"_w, "interior", "interior factor"}, {"coords"_w, "coords", nullptr}, {"size"_w, "size", nullptr},
};

/// A parameter that only some patterns have.
bool take_parameter(Cursor& at, PatternSignal& s) {
    if (at.accept("form"_w)) return set(s, "form.", at.vector("the form of crackle")), true;
    if (at.accept("brick_size"_w)) return set(s, "size.", at.vector("the size of a brick")), true;
    if (at.accept("solid"_w)) return set(s, "solid", at.flag() ? 1 : 0), true;
    for (const Parameter& p : kParameters) {
        if (!at.accept(p.word)) continue;
        set(s, p.name, at.number(p.name));
        if (p.second && at.at_number()) set(s, p.second, at.number(p.second));
        return true;
    }
    return false;
}

bool take_wave(Cursor& at, PatternSignal& s) {
    static constexpr std::pair<WordId, Wave> kWaves[] = {{"ramp_wave"_w, Wave::ramp}, {"sine_wave"_w, Wave::sine}, {"triangle_wave"_w, Wave::triangle},
                                                         {"scallop_wave"_w, Wave::scallop}, {"cubic_wave"_w, Wave::cubic}, {"poly_wave"_w, Wave::poly}};
    for (const auto& [word, wave] : kWaves) {
        if (!at.accept(word)) continue;
        s.wave = wave;
        if (wave == Wave::poly && at.at_number()) s.wave_exponent = at.number("the exponent of a wave");
        return true;
    }
    return false;
}

/// A wave that a pattern has of its own (wood, marble) takes the place of the one before, and stays where another pattern takes its place.
void keep_wave(PatternSignal& s, const PatternOps* after) {
    if (after && after->wave != Wave::ramp) return s.wave.reset();
    const PatternOps* before = s.pattern.empty() ? nullptr : find_pattern(s.pattern);
    if (before && before->wave != Wave::ramp && !s.wave) s.wave = before->wave;
}

/// One that takes the place of another keeps what was said of that one's noise.
void choose_noise(const Build& build, PatternSignal& s) {
    if (s.pattern.empty()) s.noise = build.scene.settings.noise;
}

/// Nothing of another pattern's own is there any more.
void begin_pattern(PatternSignal& s, std::string name) {
    keep_wave(s, find_pattern(name));
    s.pattern = std::move(name), s.parameters.clear(), s.source.reset(), s.picture.reset(), s.function.reset();
}

/// `function { }`. False where a part of it is not modelled, which is told here.
bool take_function(Build& build, Cursor& at, PatternSignal& s) {
    const Function& function = at.peek().value().as<Function>();
    check_pattern_function(build.p, function, at.place());
    try {
        const FunctionId id = build_function(build, function);
        choose_noise(build, s);
        begin_pattern(s, kFunctionPattern);
        s.function = id;
    } catch (const Failure& failure) {
        if (!failure.unmodelled) throw;
        build.p.tally(at.place(), failure.diagnostic.message + ": a pattern that calls it is left out, and middle grey stands for its colours");
        return false;
    }
    at.next();
    return true;
}

}  // namespace

bool take_pattern(Build& build, Cursor& at, PatternSignal& s, double* depth) {
    if (at.at_function()) return take_function(build, at, s);
    if (at_picture(at)) {
        const Block& block = *at.any_block();
        at.next();
        choose_noise(build, s);
        begin_pattern(s, std::string(kWords[block.word]));
        s.picture = build_picture(build, block, depth);
        return true;
    }
    if (const Block* pigment = at.block_at("pigment_pattern"_w)) {
        at.next();
        choose_noise(build, s);
        begin_pattern(s, "pigment_pattern");
        s.source = build_pigment(build, *pigment, plain_pigment(build));
        return true;
    }
    if (at.done() || at.peek().kind != Item::Kind::word) return false;
    const WordId word = at.peek().word;
    const PatternOps* row = find_pattern(kWords[word]);
    if (row ? row->source != SourceKind::none : word != "magnet"_w) return false;
    choose_noise(build, s);
    begin_pattern(s, row ? row->name : "");
    if (!row) return take_magnet(build, at, s);
    at.next();
    if (row->frequency == 0) s.frequency = 0;   // it stays so for another pattern, too
    take_leading(build, at, word, s);
    return true;
}

bool take_pattern_modifier(Build& build, Cursor& at, PatternSignal& s) {
    if (at.at_transform()) move(s, at.transform());
    else if (const Block* warp = at.block_at("warp"_w)) at.next(), s.warps.push_back(build_warp(build, *warp));
    else if (at.accept("frequency"_w)) s.frequency = at.number("the frequency");
    else if (at.accept("phase"_w)) s.phase = at.number("the phase");
    else if (at.accept("noise_generator"_w)) s.noise = NoiseGenerator(at.integer("the noise generator", 1, 3));
    else return take_turbulence(at, s.turbulence) || take_wave(at, s) || take_parameter(at, s);
    return true;
}

void move(PatternSignal& s, const Transform& transform) {
    if (!s.warps.empty() && s.warps.back().kind == WarpKind::transform) s.warps.back().transform = transform * s.warps.back().transform;
    else s.warps.push_back({WarpKind::transform, transform, {}});
}

MapPlace place_in_map(Build& build, const Block& entry) {
    Cursor at(build, entry);
    if (!at.at_number()) return {};
    return {map_position(at), 1};
}

double map_position(Cursor& at) { return single(at.number("a place in a map")); }

size_t list_length(const PatternSignal& s) {
    static constexpr std::pair<std::string_view, size_t> kLists[] = {{"checker", 2}, {"brick", 2}, {"hexagon", 3}, {"square", 4}, {"triangular", 6}, {"cubic", 6}};
    for (const auto& [name, length] : kLists)
        if (s.pattern == name) return length;
    return 0;
}

}  // namespace alidade::pov
