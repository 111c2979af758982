// SPDX-License-Identifier: Apache-2.0
/// Interval arithmetic: every result contains all values that the operation can take on its arguments.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace alidade {

/// The closed interval [low, high]. Each operation widens its rounded ends by one ulp, which costs less than switching the rounding mode.
struct Interval {
    double low = 0, high = 0;

    Interval() = default;
    Interval(double exact) : low(exact), high(exact) {}   // NOLINT: a number is an interval
    Interval(double l, double h) : low(l), high(h) {}
    bool contains(double x) const { return low <= x && x <= high; }
    double width() const { return high - low; }

    static Interval rounded(double l, double h) {
        constexpr double inf = std::numeric_limits<double>::infinity();
        return {std::nextafter(l, -inf), std::nextafter(h, inf)};
    }
};

inline Interval operator+(const Interval& a, const Interval& b) { return Interval::rounded(a.low + b.low, a.high + b.high); }
inline Interval operator-(const Interval& a, const Interval& b) { return Interval::rounded(a.low - b.high, a.high - b.low); }
inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator*(const Interval& a, const Interval& b) {
    const auto product = [](double x, double y) { return x == 0 || y == 0 ? 0.0 : x * y; };   // an unbounded end stands for large numbers
    const double p[] = {product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)};
    const auto [low, high] = std::minmax_element(std::begin(p), std::end(p));
    return Interval::rounded(*low, *high);
}
/// The whole line if `b` contains 0.
inline Interval operator/(const Interval& a, const Interval& b) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    if (b.contains(0)) return {-inf, inf};
    return a * Interval::rounded(1 / b.high, 1 / b.low);
}
/// Of the part that is not negative.
inline Interval sqrt(const Interval& a) {
    const Interval r = Interval::rounded(std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0)));
    return {std::max(r.low, 0.0), r.high};
}

}  // namespace alidade
