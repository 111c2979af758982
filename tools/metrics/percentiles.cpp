// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/metric.h"

#include <algorithm>
#include <cmath>

namespace alidade {
namespace {

/// Ascending, NaN-free by contract; sorted whole, because the shares asked for are many and spread.
std::vector<float> sorted(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    return values;
}

}  // namespace

std::vector<double> percentiles(std::vector<float> values, std::span<const double> shares) {
    values = sorted(std::move(values));
    std::vector<double> found;
    for (const double share : shares) {
        const double rank = std::ceil(share * double(values.size()));   // how many values are to be covered, at least one
        const size_t index = rank < 1 ? 0 : std::min(size_t(rank), values.size()) - 1;
        found.push_back(values.empty() ? 0.0 : double(values[index]));
    }
    return found;
}

std::vector<double> weighted_percentiles(std::vector<float> values, std::span<const double> shares) {
    values = sorted(std::move(values));
    double total = 0;
    for (const float value : values) total += double(value);   // in the order of the sums below, so that a share of 1 is reached
    std::vector<double> found;
    double sum = 0;
    size_t next = 0;
    for (const double share : shares) {
        while (next < values.size() && sum < share * total) sum += double(values[next++]);
        found.push_back(values.empty() ? 0.0 : double(values[next ? next - 1 : 0]));
    }
    return found;
}

}  // namespace alidade
