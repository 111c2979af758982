// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade {

/// The root of `f` between low and high, where f has different signs: Newton steps, and a halving where one would leave the bracket or gains too little.
/// `f(x)` is a pair: the value and the derivative. Ends with a step that is below `least_step`, or below `precision` times the root. Newton's steps shrink
/// faster and faster: one of a few times that length is the last that counts, and where short ones shrink no more they are what the rounding of f leaves,
/// which halvings of the bracket would not better.
/// Source   the safeguard of W. H. Press et al., "Numerical Recipes", 3rd ed. (2007), section 9.4.
template <class F> double bracketed_root(const F& f, double low, double high, bool low_is_positive, double least_step, double precision) {
    constexpr double kFast = 0.125, kFew = 8, kRounding = 0x1p-40;
    const double short_step = kRounding * (high - low);
    double x = 0.5 * (low + high), last_step = high - low;
    int fast = 0;   // how many steps on end have shrunk so: at a root where the slope is 0, too, there are not two
    for (int i = 0; i < 200; ++i) {
        const auto [value, slope] = f(x);
        if (value == 0) return x;
        ((value > 0) == low_is_positive ? low : high) = x;
        double next = x - value / slope, step = std::abs(next - x);
        const double least = std::max(least_step, precision * std::abs(next));
        const bool shrinks = step <= kFast * last_step;
        if (next >= low && next <= high && (shrinks ? fast > 0 && step <= kFew * least : fast > 1 && step <= short_step)) return next;
        fast = shrinks ? fast + 1 : 0;
        if (!(next > low && next < high) || step > 0.5 * last_step) next = 0.5 * (low + high), step = std::abs(next - x), fast = 0;
        last_step = step;
        if (step <= std::max(least_step, precision * std::abs(next))) return next;
        x = next;
    }
    return x;
}

}  // namespace alidade
