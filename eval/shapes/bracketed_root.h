// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade {

/// The root of `f` between low and high, where f has different signs: Newton steps, and a halving where one would leave the bracket or gains too little.
/// `f(x)` is a pair: the value and the derivative. Ends with a step that is below `least_step`, or below `precision` times the root.
/// Source   the safeguard of W. H. Press et al., "Numerical Recipes", 3rd ed. (2007), section 9.4.
template <class F> double bracketed_root(const F& f, double low, double high, bool low_is_positive, double least_step, double precision) {
    double x = 0.5 * (low + high), last_step = high - low;
    for (int i = 0; i < 200; ++i) {
        const auto [value, slope] = f(x);
        if (value == 0) return x;
        ((value > 0) == low_is_positive ? low : high) = x;
        double next = x - value / slope;
        if (!(next > low && next < high) || std::abs(next - x) > 0.5 * last_step) next = 0.5 * (low + high);
        last_step = std::abs(next - x);
        if (last_step <= std::max(least_step, precision * std::abs(next))) return next;
        x = next;
    }
    return x;
}

}  // namespace alidade
