// SPDX-License-Identifier: Apache-2.0
#include "eval/patterns/pattern.h"

#include "eval/noise/noise.h"
#include "eval/noise/single.h"

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

MapBlend look_up(std::span<const MapEntry> map, double value) {
    if (map.empty()) return {};
    const uint32_t last = uint32_t(map.size() - 1);
    if (value >= single(map[last].value)) return {last, last, 0};
    for (uint32_t i = 0; i <= last; ++i) {
        const double position = single(map[i].value);
        if (!(position >= value)) continue;
        if (i == 0 || position == value) return {i, i, 0};
        const double before = single(map[i - 1].value);
        return {i - 1, i, (value - before) / (position - before)};
    }
    return {last, last, 0};   // a NaN
}

tl::expected<Pattern, std::string> Pattern::make(const PatternSignal& signal) {
    Pattern out;
    out.row_ = find_pattern(signal.pattern);
    if (!out.row_) return tl::unexpected(fmt::format("there is no pattern '{}'", signal.pattern));
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
    }
    in.turbulence = signal.turbulence;
    in.turbulence.octaves = std::clamp(in.turbulence.octaves, 1, 10);
    in.noise = signal.noise;
    in.frequency = single(signal.frequency.value_or(out.row_->frequency));
    in.phase = single(signal.phase);
    out.frequency_ = out.row_->frequency == 0 ? 0 : in.frequency;
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

double Pattern::value_at(const Vec3& place) const {
    if (!row_->value) return 0;
    double v = row_->value(place, input_);
    constexpr double kPeriod = 1.00001;   // so that 1 itself does not fall to 0
    if (frequency_ != 0) v = std::fmod(v * frequency_ + input_.phase, kPeriod);
    if (v < 0) v -= std::floor(v);
    return shaped(wave_, wave_exponent_, v);
}

}  // namespace alidade
