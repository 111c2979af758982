// SPDX-License-Identifier: Apache-2.0
/// Medians, and what is a difference.
#pragma once

#include "core/random.h"
#include "stress/measure.h"

#include <cstddef>
#include <vector>

namespace alidade::tradeoff {

using alidade::median;
/// The median distance from the median: how far repeated measurements lie apart, whatever one of them does.
double median_deviation(const std::vector<double>& values);

/// A cost that was measured several times, or, where it is counted, once.
struct Cost {
    double median = 0, deviation = 0;
};
Cost cost_of(const std::vector<double>& values);
/// Where the median lies with a probability of 95 %, by 1000 resamplings of `values`, the same ones every time.
/// Source   Efron, "Bootstrap Methods: Another Look at the Jackknife", Annals of Statistics 7 (1979), the percentile method.
struct Interval {
    double low = 0, high = 0;
};
Interval median_interval(const std::vector<double>& values);
/// Apart by 2 of the larger deviation, or more: less is no difference.
bool differ(const Cost& a, const Cost& b);

/// 0 .. count - 1 in random order, by Fisher and Yates' method.
std::vector<size_t> shuffled(size_t count, const RandomKey& key);

}  // namespace alidade::tradeoff
