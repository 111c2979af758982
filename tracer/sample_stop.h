// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/noise.h"
#include "tracer/options.h"

#include <vector>

namespace alidade {

/// A pixel that may end early by RenderOptions::adaptive takes so many samples at the least, and is asked after each kSamplesBetweenLooks more.
inline constexpr int kLeastSamples = 16, kSamplesBetweenLooks = 8;

/// When the samples of a pixel are enough, before all are taken. Asked at some numbers of samples only: not by chance, but where they are spread evenly.
///
/// By RenderOptions::adaptive: when the displayed error is below it.
/// By LensNoise: POV-Ray's rule. With q(n) the quantile of the chi-squared distribution with n degrees of freedom, at 1 - confidence, and N all samples,
/// n are enough where the variance of their mean (the mean square deviation over n) is below variance q(n) / q(N - 1) in each channel. n is 7, 13, 19, 23,
/// 27, 31, 35, 37 and each fourth from there; with less than 19 samples each fourth from 7 on, with less than 7 from 4.
/// Source   POV-Ray 3.7 reference, 3.3.1.6 "Focal Blur", for what the words mean; the rule fits its counts of rays in 30 probes (tests/tracer/sample_stop_test.cpp).
class SampleStop {
  public:
    SampleStop(const RenderOptions& options, int samples);
    /// Does it ask the noise of a pixel at all?
    bool asks() const { return adaptive_ > 0 || !limits_.empty(); }
    bool enough(const NoiseEstimate& noise, int samples) const;

  private:
    double adaptive_, exposure_;
    std::vector<double> limits_;   ///< of the variance of the mean, by number of samples; 0 where it is not asked
};

/// The quantile of the chi-squared distribution: x with P(chi^2 <= x) = `probability`, within 1 % from 4 degrees of freedom on.
/// Source   E. B. Wilson and M. M. Hilferty, "The Distribution of Chi-Square", PNAS 17(12), 1931.
double chi_squared_quantile(int degrees, double probability);

}  // namespace alidade
