// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/transfer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alidade {
namespace {

/// Colours of both pictures, of a large one each so many-th pixel.
struct Samples {
    bool hdr;
    std::vector<std::pair<double, double>> values;   ///< reference, test

    explicit Samples(const PicturePair& pair) : hdr(pair.hdr) {
        const size_t channels = size_t(pair.reference.channels), step = pair.pixels() / 100000 | 1;
        for (size_t p = 0; p < pair.pixels(); p += step)
            for (size_t i = p * channels; pair.counts[p] && i < p * channels + size_t(pair.colors()); ++i)
                values.emplace_back(pair.reference.values[i], pair.test.values[i]);
    }
};

/// The share of the squared error that is gone if the reference's colours go through `curve`; display values stay in 0 .. 1, and errors of linear ones
/// are relative, so that the brightest pixels do not decide alone.
template <class Curve>
double explained_by(const Samples& samples, Curve&& curve) {
    double before = 0, after = 0;
    for (const auto& [reference, test] : samples.values) {
        const double there = curve(reference), error = test - (samples.hdr ? there : std::clamp(there, 0.0, 1.0));
        const double weight = samples.hdr ? 1 / (reference * reference + 0.01) : 1;
        before += weight * (test - reference) * (test - reference), after += weight * error * error;
    }
    return before > 0 ? 1 - after / before : 0;
}

/// test = scale x reference ^ gamma.
struct Power {
    double scale = 1, gamma = 1;
};

/// Values near 0 and clipped ones say nothing of the curve. Each logarithm counts as much as a difference at its value does.
Power fit_power(const Samples& samples) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [reference, test] : samples.values) {
        if (reference < 0.02 || test < 0.02 || (!samples.hdr && (reference > 0.98 || test > 0.98))) continue;
        const double weight = reference * test, u = std::log(reference), v = std::log(test);
        n += weight, x += weight * u, y += weight * v, xx += weight * u * u, xy += weight * u * v;
    }
    const double spread = n * xx - x * x;
    if (n == 0) return {};
    if (spread < 1e-9 * n * n) return {std::exp((y - x) / n), 1};
    const double gamma = (n * xy - x * y) / spread;
    if (gamma < 0.2 || gamma > 5) return {};   // no slip: a picture of two or three values fits any power
    return {std::exp((y - gamma * x) / n), gamma};
}

double mean_difference(const Samples& samples) {
    double sum = 0;
    for (const auto& [reference, test] : samples.values) sum += test - reference;
    return sum / double(std::max<size_t>(samples.values.size(), 1));
}

Transfer power(const Samples& samples) {
    const Power fit = fit_power(samples);
    const double explained = explained_by(samples, [&](double value) { return value > 0 ? fit.scale * std::pow(value, fit.gamma) : value; });
    const double scaled = explained_by(samples, [&](double value) { return fit.scale * value; });
    if (std::abs(fit.gamma - 1) < 0.02 && scaled > 0.9 * explained) return {"exposure", fmt::format("the test is {:.4g} times the reference", fit.scale), scaled};
    return {"gamma", fmt::format("the test is about the reference to the power of {:.3f}, times {:.3f}", fit.gamma, fit.scale), explained};
}

}  // namespace

Transfer find_transfer(const PicturePair& pair) {
    const Samples samples(pair);
    const double offset = mean_difference(samples);
    Transfer all[] = {
        {"encoding", "the test is the reference without its sRGB curve: linear values were written as they are", explained_by(samples, srgb_to_linear)},
        {"encoding", "the test is the reference with the sRGB curve put on once more", explained_by(samples, [](double v) { return v > 0 ? linear_to_srgb(v) : v; })},
        {"offset", fmt::format("the test is the reference plus {:.4g}", offset), explained_by(samples, [&](double value) { return value + offset; })},
        power(samples),
    };
    return *std::max_element(std::begin(all), std::end(all), [](const Transfer& a, const Transfer& b) { return a.explained < b.explained; });
}

}  // namespace alidade
