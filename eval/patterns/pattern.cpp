// SPDX-License-Identifier: Apache-2.0
#include "eval/patterns/pattern.h"

#include "eval/noise/noise.h"
#include "eval/noise/single.h"
#include "eval/patterns/picture.h"

#include <fmt/format.h>

namespace alidade {

namespace {

double shaped(Wave wave, double exponent, double v) {
    switch (wave) {
        case Wave::ramp: break;
        case Wave::sine: return (1 + cycle(v)) * 0.5;
        case Wave::triangle: return triangle(v);
        case Wave::scallop: return std::abs(cycle(v * 0.5));
        case Wave::cubic: return v * v * (3 - 2 * v);
        case Wave::poly: return std::pow(v, exponent);
    }
    return v;
}

}  // namespace

tl::expected<Pattern, std::string> Pattern::make(const PatternSignal& signal, PatternSource source) {
    Pattern out;
    out.row_ = find_pattern(signal.pattern);
    if (!out.row_) return tl::unexpected(fmt::format("there is no pattern '{}'", signal.pattern));
    const SourceKind needed = out.row_->source, given = signal.picture ? SourceKind::picture : signal.function ? SourceKind::function : signal.source ? SourceKind::pigment : SourceKind::none;
    if (needed != given || (needed != SourceKind::none) != bool(source)) {
        static constexpr const char* kWanted[] = {"takes no pigment, picture or function", "has no pigment", "has no picture", "has no function"};
        return tl::unexpected(fmt::format("the pattern '{}' {}", signal.pattern, kWanted[size_t(needed)]));
    }
    out.source_ = std::move(source);
    const auto names = out.row_->parameters;
    if (signal.parameters.size() > names.size()) return tl::unexpected(fmt::format("the pattern '{}' has {} parameters, more than {}", signal.pattern, signal.parameters.size(), names.size()));
    PatternInput& in = out.input_;
    for (size_t i = 0; i < names.size(); ++i) {
        const double v = i < signal.parameters.size() ? signal.parameters[i] : names[i].usual;
        in.parameters.push_back(names[i].single ? single(v) : v);
    }
    for (size_t i = signal.warps.size(); i-- > 0;) {
        auto warp = prepare(signal.warps[i]);
        if (!warp) return tl::unexpected(warp.error());
        out.warps_.push_back(*warp);
        if (warp->kind != WarpKind::transform) continue;
        out.normal_in_ = glm::transpose(signal.warps[i].transform.linear) * out.normal_in_;
        out.normal_out_ = out.normal_out_ * glm::transpose(warp->inverse.linear);
    }
    in.turbulence = signal.turbulence;
    in.turbulence.octaves = std::clamp(in.turbulence.octaves, 1, 10);
    in.noise = signal.noise;
    in.frequency = single(signal.frequency.value_or(out.row_->frequency));
    in.phase = single(signal.phase);
    out.frequency_ = in.frequency;
    out.wave_ = signal.wave.value_or(out.row_->wave);
    out.wave_exponent_ = single(signal.wave_exponent);
    out.displaced_ = out.row_->displaced && in.turbulence.amount != Vec3(0);
    if (out.row_->prepare) out.row_->prepare(in);
    return out;
}

Vec3 Pattern::place(const Vec3& p) const {
    Vec3 q = p;
    for (const PreparedWarp& warp : warps_) q = warped(warp, q);
    if (displaced_) q += input_.turbulence.amount * vector_turbulence(q, input_.turbulence);
    return glm::clamp(q, Vec3(-1e17), Vec3(1e17));
}

/// A number of the row or the source, after frequency, phase and wave.
double Pattern::finished(double v) const {
    constexpr double kPeriod = 1.00001;   // so that 1 itself does not fall to 0
    if (frequency_ != 0) {
        v = v * frequency_ + input_.phase;
        if (!(std::abs(v) < kPeriod)) v = std::fmod(v, kPeriod);   // which leaves the others as they are
    }
    if (v < 0) v -= std::floor(v);
    return shaped(wave_, wave_exponent_, v);
}

double Pattern::value_at(const Vec3& place) const {
    if (!row_->value && !source_) return 0;
    return finished(source_.picture ? source_.picture->value(place) : source_.grey ? source_.grey(place) : row_->value(place, input_));
}

void Pattern::values_at(const Vec3* places, double* values) const {
    if (!row_->four || source_) {
        for (int i = 0; i < 4; ++i) values[i] = value_at(places[i]);
        return;
    }
    row_->four(places, input_, values);
    for (int i = 0; i < 4; ++i) values[i] = finished(values[i]);
}

}  // namespace alidade
