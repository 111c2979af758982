// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/patterns.h"

#include "exporters/pov/warps.h"
#include "scene/graph.h"
#include "scene/queries.h"

#include <fmt/format.h>

namespace alidade::pov_export {

namespace {

constexpr const char* kWaves[] = {"ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", "poly_wave"};

double parameter(const PatternSignal& s, size_t i, double usual) { return i < s.parameters.size() ? s.parameters[i] : usual; }
Vec3 vector_parameter(const PatternSignal& s, size_t i, const Vec3& usual) {
    return {parameter(s, i, usual.x), parameter(s, i + 1, usual.y), parameter(s, i + 2, usual.z)};
}

bool has_waves(const PatternSignal& s) { return s.pattern == "waves" || s.pattern == "ripples"; }

}  // namespace

int number_of_waves(const Scene& scene) {
    for (const Signal& signal : scene.signals)
        if (const PatternSignal* s = pattern_of(signal); s && has_waves(*s)) return int(parameter(*s, 0, 10));
    return 10;
}

size_t PatternWriter::list_length(const PatternSignal& s) {
    static constexpr std::pair<std::string_view, size_t> kLists[] = {{"checker", 2}, {"brick", 2}, {"hexagon", 3}, {"square", 4}, {"triangular", 6}, {"cubic", 6}};
    for (const auto& [name, length] : kLists)
        if (s.pattern == name) return length;
    return 0;
}

void PatternWriter::declare(const std::vector<SignalId>& roots) {
    std::vector<bool> used(scene_.signals.size());
    std::vector<SignalId> all;
    for (const SignalId root : roots)
        if (!used[root.index]) collect_signals(scene_, root, all);
    declare_unit(all);
    for (const SignalId id : all) used[id.index] = true;
    const auto operands = [&](uint32_t i, const auto& f) { for_each_operand(scene_, scene_.signals[i], [&](SignalId id) { f(id.index); }); };
    const std::vector<uint32_t> order = topological_order(scene_.signals.size(), operands).sequence;
    for (auto i = order.rbegin(); i != order.rend(); ++i)
        if (used[*i]) declare_one({*i});
}

void PatternWriter::declare_unit(const std::vector<SignalId>& all) {
    const auto rounds = [&](SignalId id) { return is_colour(id) && !colour(id).value.is_single(); };
    if (std::any_of(all.begin(), all.end(), rounds)) sdl_.line("#declare", kUnit, "= rgbft <1,1,1,1,1>;");
}

void PatternWriter::declare_one(SignalId id) {
    const Signal& signal = scene_.signals[id.index];
    const bool relief_signal = std::holds_alternative<ReliefSignal>(signal.what);
    if (!relief_signal && !std::holds_alternative<PatternSignal>(signal.what)) return;
    if (const PatternSignal* s = pattern_of(signal); s->function) functions_.declare_parts(*s->function);
    sdl_.begin("#declare", item(id, relief_signal ? "Normal" : "Pigment"), "=", relief_signal ? "normal" : "pigment");
    if (relief_signal) relief(std::get<ReliefSignal>(signal.what));
    else pigment_pattern(std::get<PatternSignal>(signal.what));
    sdl_.end();
}

std::string PatternWriter::item(SignalId id, const char* kind) const { return fmt::format("{}_{}", kind, id.index); }

bool PatternWriter::is_colour(SignalId id) const { return std::holds_alternative<ConstantSignal>(scene_.signals[id.index].what); }

ExactColour PatternWriter::colour(SignalId id) const {
    const auto& c = std::get<ConstantSignal>(scene_.signals[id.index].what);
    return {{Color(c.value), c.filter, c.transmit}};
}

void PatternWriter::pigment(SignalId id) {
    const Signal& signal = scene_.signals[id.index];
    if (is_colour(id)) return sdl_.line(colour(id));
    if (std::holds_alternative<PatternSignal>(signal.what)) return sdl_.line(item(id, "Pigment"));
    const Texel found = texel(scene_, id, losses_);
    if (!found.picture || !images_.map(*found.picture)) sdl_.line(Rgbft{Color(found.factor)});
    else losses_.add("factors of pictures in POV-Ray's pigments", !found.is_constant(1) && Vec3(found.factor) != Vec3(1), "the pictures as they are");
}

void PatternWriter::pigment_block(SignalId id) {
    sdl_.begin("pigment");
    pigment(id);
    sdl_.end();
}

void PatternWriter::normal_block(SignalId id) {
    if (std::holds_alternative<ReliefSignal>(scene_.signals[id.index].what)) return sdl_.line("normal {", item(id, "Normal"), "}");
    losses_.add("normals that are no reliefs");
}

void PatternWriter::parameters(const PatternSignal& s) {
    const auto number = [&](const char* word, size_t i) {
        if (i < s.parameters.size()) sdl_.line(word, s.parameters[i]);
    };
    const auto sides = [&](size_t i) {
        if (i < s.parameters.size()) sdl_.line("exterior", parameter(s, i, 1), ",", parameter(s, i + 1, 1));
        if (i + 2 < s.parameters.size()) sdl_.line("interior", parameter(s, i + 2, 0), ",", parameter(s, i + 3, 1));
    };
    if (s.pattern == "agate") number("agate_turb", 0);
    if (s.pattern == "quilted") number("control0", 0), number("control1", 1);
    if (s.pattern == "brick") sdl_.line("brick_size", vector_parameter(s, 0, {8, 3, 4.5})), number("mortar", 3);
    if (s.pattern == "crackle" && !s.parameters.empty()) {
        sdl_.line("form", vector_parameter(s, 0, {-1, 1, 0}));
        number("metric", 3), number("offset", 4);
        if (parameter(s, 5, 0) != 0) sdl_.line("solid");
    }
    if (s.pattern == "facets") {
        if (parameter(s, 0, 0) != 0) number("coords", 0);
        number("size", 1), number("metric", 2);
    }
    if (s.pattern == "mandel") number("exponent", 1), sides(2);
    if (s.pattern == "julia") number("exponent", 3), sides(4);
    if (s.pattern == "magnet_mandel") sides(2);
    if (s.pattern == "magnet_julia") sides(4);
}

/// What stands for a picture that cannot be read.
void PatternWriter::picture(const PatternSignal& s) {
    if (images_.pattern(s.pattern, *s.picture)) return;
    if (s.pattern == kImageMap) sdl_.line("color rgb 1");
    else sdl_.line(s.pattern == "bump_map" ? "bumps 0" : "planar");
}

void PatternWriter::pattern_head(const PatternSignal& s) {
    if (s.uv_mapped) sdl_.line("uv_mapping");
    if (s.picture) return picture(s);
    const Vec2 c(parameter(s, s.pattern == "julia" ? 0 : 1, 0), parameter(s, s.pattern == "julia" ? 1 : 2, 0));
    if (s.pattern == "gradient") sdl_.line("gradient", vector_parameter(s, 0, Vec3(0)));
    else if (s.pattern == "spiral1" || s.pattern == "spiral2") sdl_.line(s.pattern, parameter(s, 0, 1));
    else if (s.pattern == "mandel") sdl_.line("mandel", parameter(s, 0, 1));
    else if (s.pattern == "julia") sdl_.line("julia", c, ",", parameter(s, 2, 1));
    else if (s.pattern == "magnet_mandel") sdl_.line("magnet", parameter(s, 0, 1), "mandel", parameter(s, 1, 1));
    else if (s.pattern == "magnet_julia") sdl_.line("magnet", parameter(s, 0, 1), "julia", c, ",", parameter(s, 3, 1));
    else if (s.pattern == "pigment_pattern" && s.source) {
        sdl_.begin("pigment_pattern");
        pigment(*s.source);
        sdl_.end();
    } else if (s.function) sdl_.line("function {", functions_.formula(*s.function), "}");
    else sdl_.line(s.pattern);
    losses_.add("numbers of waves", has_waves(s) && int(parameter(s, 0, 10)) != number_of_waves(scene_), "that of the first pattern that has one");
}

void PatternWriter::pattern_modifiers(const PatternSignal& s) {
    parameters(s);
    if (s.noise != scene_.settings.noise) sdl_.line("noise_generator", int(s.noise));
    write_turbulence(sdl_, s.turbulence);
    if (s.wave) {
        if (*s.wave == Wave::poly) sdl_.line(kWaves[int(*s.wave)], s.wave_exponent);
        else sdl_.line(kWaves[int(*s.wave)]);
    }
    if (s.frequency) sdl_.line("frequency", *s.frequency);
    if (s.phase != 0) sdl_.line("phase", s.phase);
    for (const Warp& w : s.warps) write_warp(sdl_, w);
}

void PatternWriter::pigment_map(const PatternSignal& s) {
    const bool colours = std::all_of(s.map.begin(), s.map.end(), [&](const MapEntry& e) { return is_colour(e.signal); });
    if (list_length(s)) {
        for (size_t i = 0; i < s.map.size(); ++i) {
            if (!colours) pigment_block(s.map[i].signal);
            else sdl_.line(i ? "," : "", colour(s.map[i].signal));
        }
        return;
    }
    if (s.map.empty()) return;
    const bool average = s.pattern == "average";
    sdl_.begin(colours && !average ? "color_map" : "pigment_map");
    for (const MapEntry& e : s.map) {
        if (is_colour(e.signal)) sdl_.line("[", e.value, colour(e.signal), "]");
        else {
            sdl_.line("[", e.value);
            pigment(e.signal);
            sdl_.line("]");
        }
    }
    sdl_.end();
}

void PatternWriter::asked_by_function(SignalId id, bool number) {
    if (!number) return pigment(id);
    const auto& s = std::get<PatternSignal>(scene_.signals[id.index].what);
    pattern_head(s);
    pattern_modifiers(s);
}

void PatternWriter::pigment_pattern(const PatternSignal& s) {
    pattern_head(s);
    pigment_map(s);
    pattern_modifiers(s);
}

void PatternWriter::relief(const ReliefSignal& r) {
    const PatternSignal& s = r.pattern;
    pattern_head(s);
    if (list_length(s) && !s.map.empty()) {
        for (const MapEntry& e : s.map) normal_block(e.signal);
    } else if (!s.map.empty()) {
        sdl_.begin("normal_map");
        for (const MapEntry& e : s.map)
            if (std::holds_alternative<ReliefSignal>(scene_.signals[e.signal.index].what)) sdl_.line("[", e.value, item(e.signal, "Normal"), "]");
        sdl_.end();
    }
    if (!r.slopes.empty()) {
        sdl_.begin("slope_map");
        for (const SlopeEntry& e : r.slopes) sdl_.line("[", e.value, Vec2(e.height, e.slope), "]");
        sdl_.end();
    }
    sdl_.line("bump_size", r.amount);
    if (r.accuracy != 0.02) sdl_.line("accuracy", r.accuracy);
    if (!r.scaled) sdl_.line("no_bump_scale");
    pattern_modifiers(s);
}

}  // namespace alidade::pov_export
