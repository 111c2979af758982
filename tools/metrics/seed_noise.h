// SPDX-License-Identifier: Apache-2.0
/// Is a difference noise? A test of each pixel, by pictures that differ by their random numbers alone.
#pragma once

#include "tools/metrics/metric.h"

namespace alidade {

/// Mean, variance and range of each value of many pictures of one size.
/// Source   Welford, "Note on a method for calculating corrected sums of squares and products", Technometrics 4 (1962).
class SeedStatistics {
  public:
    void add(const Picture& picture);
    int count() const { return count_; }
    int width() const { return width_; }
    int channels() const { return channels_; }
    size_t values() const { return mean_.size(); }
    double mean(size_t i) const { return mean_[i]; }
    double variance(size_t i) const { return count_ > 1 ? squares_[i] / (count_ - 1) : 0; }   ///< of one picture, not of the mean
    float low(size_t i) const { return low_[i]; }
    float high(size_t i) const { return high_[i]; }

  private:
    int count_ = 0, width_ = 0, channels_ = 0;
    std::vector<double> mean_, squares_;
    std::vector<float> low_, high_;
};

/// What is known of the reference.
enum class ReferenceNoise {
    none,      ///< it is the one true picture
    like_ours, ///< it is one picture whose random numbers spread it as ours are
    measured,  ///< it is several pictures
};

struct SeedNoise {
    size_t tests = 0;              ///< values of pixels that count
    size_t significant = 0;        ///< pixels with a value that noise does not explain
    double largest_z = 0;          ///< of all tests; infinite where a value that never changes is another
    double limit = 0;              ///< what it would exceed in one of a hundred pictures that differ by noise alone
    std::vector<uint8_t> marked;   ///< 1 for each significant pixel
};
constexpr double kSeedAlpha = 0.01;   ///< probability that pictures which differ by noise alone have a significant pixel
constexpr int kFewestSeeds = 9;       ///< for sidak_limit's deviates of Student's t

/// Under the hypothesis that both show the same, a value's mean difference over its standard error has Student's distribution (Welch's degrees of freedom
/// where both are estimated). `counts`: one a pixel. Not significant are differences up to `floor` plus `share` of the value (rounding). Noise is not
/// normal where something is rarely seen: a single random reference may also show what one of our pictures shows in the same or one of the eight pixels
/// around, if there is noise.
SeedNoise test_seeds(const SeedStatistics& ours, const SeedStatistics& reference, ReferenceNoise noise, const std::vector<uint8_t>& counts, double floor, double share);

}  // namespace alidade
