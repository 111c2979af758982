// SPDX-License-Identifier: Apache-2.0
#include "tracer/noise.h"

namespace alidade {

namespace {

/// Of the curve that linear_to_srgb() follows (IEC 61966-2-1).
double srgb_slope(double linear) {
    constexpr double kEndOfLine = 0.0031308;
    return linear <= kEndOfLine ? 12.92 : 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1);
}

}  // namespace

double NoiseEstimate::displayed_error(double exposure) const {
    if (count_ < 2) return kInf;
    double largest = 0;
    for (int c = 0; c < 3; ++c) {
        const double error = std::sqrt(squares_[c] / (double(count_) * (count_ - 1))) * exposure * srgb_slope(mean_[c] * exposure);
        if (!(error <= largest)) largest = error;   // a NaN stays: it is never below a limit
        if (std::isnan(largest)) break;
    }
    return largest;
}

double NoiseEstimate::variance_of_mean() const {
    double largest = 0;
    for (int c = 0; c < 3; ++c) {
        const double variance = squares_[c] / (double(count_) * count_);
        if (!(variance <= largest)) largest = variance;   // a NaN stays: it is never below a limit
        if (std::isnan(largest)) break;
    }
    return largest;
}

}  // namespace alidade
