// SPDX-License-Identifier: Apache-2.0
/// How sure the mean of a pixel's samples is.
#pragma once

#include "core/vec.h"

namespace alidade {

/// Mean and variance of the samples of one pixel.
/// Source   B. P. Welford, "Note on a Method for Calculating Corrected Sums of Squares and Products", Technometrics 4(3), 1962.
class NoiseEstimate {
  public:
    void add(const Color& sample) {
        ++count_;
        const Color away = sample - mean_;
        mean_ += away / double(count_);
        squares_ += away * (sample - mean_);
    }

    /// The standard error of the mean as it is displayed: of the channel where it is the largest, times the slope of sRGB's curve at the mean (both after
    /// multiplication with `exposure`). 1 is the range from black to white. Above white the curve goes on, so that pictures with a high range are
    /// sampled for what they hold. For independent samples; those that are spread well do better than it says.
    double displayed_error(double exposure) const;
    /// The mean square deviation over the count, of the channel where it is the largest.
    double variance_of_mean() const;

  private:
    int count_ = 0;
    Color mean_{0}, squares_{0};
};

}  // namespace alidade
