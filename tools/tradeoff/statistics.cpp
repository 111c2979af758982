// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace alidade::tradeoff {

double median_deviation(const std::vector<double>& values) {
    const double middle = median(values);
    std::vector<double> distances;
    for (const double value : values) distances.push_back(std::abs(value - middle));
    return median(std::move(distances));
}

Cost cost_of(const std::vector<double>& values) { return {median(values), median_deviation(values)}; }

Interval median_interval(const std::vector<double>& values) {
    constexpr size_t kTimes = 1000;
    std::vector<double> medians, drawn(values.size());
    for (size_t time = 0; time < kTimes && !values.empty(); ++time) {
        const RandomKey key(0, 0, time);
        for (size_t i = 0; i < values.size(); ++i) drawn[i] = values[std::min(size_t(key.uniform(i) * double(values.size())), values.size() - 1)];
        medians.push_back(median(drawn));
    }
    std::sort(medians.begin(), medians.end());
    return medians.empty() ? Interval{} : Interval{medians[kTimes / 40], medians[kTimes - 1 - kTimes / 40]};
}

bool differ(const Cost& a, const Cost& b) {
    const double distance = std::abs(a.median - b.median);
    return distance > 0 && distance >= 2 * std::max(a.deviation, b.deviation);
}

std::vector<size_t> shuffled(size_t count, const RandomKey& key) {
    std::vector<size_t> order(count);
    std::iota(order.begin(), order.end(), size_t(0));
    for (size_t i = count; i > 1; --i) std::swap(order[i - 1], order[std::min(size_t(key.uniform(i) * double(i)), i - 1)]);
    return order;
}

}  // namespace alidade::tradeoff
