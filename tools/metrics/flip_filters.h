// SPDX-License-Identifier: Apache-2.0
/// What LDR-FLIP and HDR-FLIP share: the error map of two pictures on a display, and how it is pooled.
///
/// Source   Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020. Section and
///          equation numbers in the source are of that paper. Written from its text.
#pragma once

#include "tools/metrics/metric.h"

#include <cstddef>
#include <span>
#include <vector>

namespace alidade {

/// The paper's observer: 0.7 m from a display 0.7 m wide with 3840 pixels; about 67.02.
inline constexpr double kPixelsPerDegree = 3840 * 3.14159265358979323846 / 180;

/// Weights of a filter that is the same on both sides (or the negative on the other), from the centre outwards.
using HalfKernel = std::vector<float>;

/// The filters, each the 1D factor of a 2D one, at kPixelsPerDegree. None has more than kMaxTaps weights.
struct FlipFilters {
    size_t radius = 0;              ///< of the widest, in pixels
    HalfKernel achromatic;          ///< contrast sensitivity, sum 1
    HalfKernel red_green;
    HalfKernel blue_yellow[2];      ///< two Gaussians: the filter is the sum of their 2D products; together 1
    HalfKernel smooth;              ///< across an edge or point detector, sum 1
    HalfKernel edge;                ///< first derivative: odd, the positive side sums to 1
    HalfKernel point;               ///< second derivative: positive weights sum to 1, negative ones to -1
};
inline constexpr size_t kMaxTaps = 16;
FlipFilters flip_filters();

/// The FLIP error of each pixel, 0 .. 1.
///
/// Units    both pictures are linear Rec. 709, 0 .. 1, interleaved, `width` * `height` * 3 values; the world beyond the border continues its pixels.
/// Method   separable filters over strips of fixed height: no value depends on `threads`. Symmetric in the two pictures, bit for bit; equal ones give 0.
/// Error    float arithmetic: within 1e-4 of double evaluation (measured 2e-5): the square root of features magnifies rounding where they are faint.
std::vector<float> flip_map(int width, int height, std::span<const float> reference, std::span<const float> test, int threads);

/// Mean, weighted quartiles, min and max over the pixels that count, and the map itself with 0 at the others.
Measured pooled_flip(const PicturePair& pair, std::vector<float> map);

}  // namespace alidade
