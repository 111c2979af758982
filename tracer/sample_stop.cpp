// SPDX-License-Identifier: Apache-2.0
#include "tracer/sample_stop.h"

namespace alidade {
namespace {

/// The number of samples at which a lens with `all` is looked at next.
int next_look(int taken, int all) {
    constexpr int kLooks[] = {7, 13, 19, 23, 27, 31, 35, 37};
    const int regular = all >= 19 ? 37 : all >= 7 ? 7 : 4;   // samples of the pattern that the lens begins with
    for (const int look : kLooks)
        if (look > taken && look <= regular) return look;
    return taken + 4;
}

/// The quantile of the normal distribution.
double normal_quantile(double probability) {
    double low = -40, high = 40;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle / std::sqrt(2.0)) < probability ? low : high) = middle;
    }
    return low;
}

}  // namespace

double chi_squared_quantile(int degrees, double probability) {
    const double spread = 2 / (9.0 * degrees), root = 1 - spread + normal_quantile(probability) * std::sqrt(spread);
    return root > 0 ? degrees * root * root * root : 0;
}

SampleStop::SampleStop(const RenderOptions& options, int samples) : adaptive_(options.adaptive), exposure_(std::exp2(options.exposure)) {
    if (!options.lens_noise || samples < 2) return;
    const LensNoise& lens = *options.lens_noise;
    limits_.resize(size_t(samples));
    const double of_all = chi_squared_quantile(samples - 1, 1 - lens.confidence);
    for (int n = next_look(0, samples); n < samples; n = next_look(n, samples))
        if (n >= lens.fewest) limits_[size_t(n)] = lens.variance * chi_squared_quantile(n, 1 - lens.confidence) / of_all;
}

bool SampleStop::enough(const NoiseEstimate& noise, int samples) const {
    if (!limits_.empty()) return size_t(samples) < limits_.size() && limits_[size_t(samples)] > 0 && noise.variance_of_mean() < limits_[size_t(samples)];
    return samples >= kLeastSamples && samples % kSamplesBetweenLooks == 0 && noise.displayed_error(exposure_) < adaptive_;
}

}  // namespace alidade
