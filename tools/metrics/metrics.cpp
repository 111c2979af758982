// SPDX-License-Identifier: Apache-2.0
/// The registry.
#include "tools/metrics/metric.h"

namespace alidade {
namespace {

constexpr auto kAll = Metric::For::all, kHdr = Metric::For::hdr;

constexpr Metric kMetrics[] = {
    {"max_abs", "value", "largest |test - reference|, its place and both values", kAll, true, measure_max_abs},
    {"mae", "value", "mean |test - reference|", kAll, true, measure_mae},
    {"rmse", "value", "root of the mean squared error", kAll, true, measure_rmse},
    {"psnr", "dB", "-10 log10 of the mean squared error; a peak of 1", kAll, true, measure_psnr},
    {"rel_mse", "1", "mean of squared error / (squared reference + 0.01); Rousselle et al. 2011", kAll, false, measure_rel_mse},
    {"ssim", "1", "structural similarity of display values, 1 if equal; Wang et al. 2004", kAll, true, measure_ssim},
    {"flip", "1", "perceived difference of display values at 67.02 pixels a degree; Andersson et al. 2020", kAll, true, measure_flip},
    {"hdr_flip", "1", "the same for linear values, the largest over exposures; Andersson et al. 2021", kHdr, false, measure_hdr_flip},
    {"over1", "share of pixels", "differ by more than 1/255 in a channel", kAll, true, measure_over1},
    {"over2", "share of pixels", "differ by more than 2/255 in a channel", kAll, true, measure_over2},
    {"over4", "share of pixels", "differ by more than 4/255 in a channel", kAll, true, measure_over4},
    {"over8", "share of pixels", "differ by more than 8/255 in a channel", kAll, true, measure_over8},
    {"percentiles", "value", "the difference that 50, 95, 99 and 99.9 % of the pixels do not exceed", kAll, true, measure_percentiles},
    {"bias", "value", "signed mean of test - reference, the channel's that is largest, and each channel's", kAll, false, measure_bias},
    {"envelope", "share of pixels", "lie more than 8/255 outside the reference's range in the 3x3 pixels around", kAll, false, measure_envelope},
    {"region", "pixels", "of the largest connected set that differs by more than 8/255, and its box", kAll, true, measure_region},
};

}  // namespace

std::span<const Metric> metrics() { return kMetrics; }

}  // namespace alidade
