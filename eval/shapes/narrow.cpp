// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/narrow.h"

#include <algorithm>
#include <cmath>

namespace alidade {

namespace {

/// What everything is widened by, in parts of the terms: far more than their roundings.
constexpr double kSlack = 1e-12;

struct Interval {
    double low = 0, high = 0;
    double magnitude = 0;   ///< of the finite terms: what roundings are relative to

    void add(double low_term, double high_term) {
        low += low_term, high += high_term;
        for (const double term : {low_term, high_term})
            if (std::isfinite(term)) magnitude += std::abs(term);
    }
    /// Adds k [a, b]; 0 times infinity is 0.
    void add(double k, double a, double b) {
        if (k != 0) add(std::min(k * a, k * b), std::max(k * a, k * b));
    }
    double lowest() const { return low - kSlack * magnitude; }
    double highest() const { return high + kSlack * magnitude; }
};

double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

/// Adds the least value of s x^2 + l x over [a, b].
void add_least(double s, double l, double a, double b, Interval& sum) {
    const auto at = [&](double x) { return std::isfinite(x) ? s * x * x + l * x : s != 0 ? s * kInf : product(l, x); };
    double least = std::min(at(a), at(b));
    if (const double turn = -0.5 * l / s; s > 0 && turn > a && turn < b) least = std::min(least, at(turn));
    sum.low += least;
    for (const double x : {a, b})
        if (std::isfinite(x)) sum.magnitude += std::abs(s) * x * x + std::abs(l * x);
    if (s > 0) sum.magnitude += l * l / s;
}

struct Range {
    double low = kInf, high = -kInf;   ///< empty like this
    void extend(const Range& r) { low = std::min(low, r.low), high = std::max(high, r.high); }
};

/// All x >= 0 with a x^2 + b x + c <= 0 lie in it.
Range positive_solutions(double a, double b, double c) {
    if (a == 0 && b < 0) return {std::max(0.0, c / -b * (1 - kSlack)), kInf};
    if (a == 0) return c > 0 ? Range() : Range{0, b > 0 ? -c / b * (1 + kSlack) : kInf};
    const double discriminant = b * b - 4 * a * c;
    if (!std::isfinite(discriminant) || a <= 0) return {0, kInf};
    if (discriminant < 0) return {};
    const double sum = -0.5 * (b + std::copysign(std::sqrt(discriminant), b)), one = sum / a, other = sum != 0 ? c / sum : 0;
    if (std::max(one, other) < 0) return {};
    return {std::max(0.0, std::min(one, other) * (1 - kSlack)), std::max(one, other) * (1 + kSlack)};
}

/// Along axis i: a x^2 + b x + c with the interval b over the box, and the least c.
Range solutions(const Quadric& f, double sign, const Bounds& box, int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto products = [&](int m, int n) { return sign * f.products[m + n - 1]; };
    Interval b, c;
    b.add(sign * f.linear[i], sign * f.linear[i]);
    b.add(products(i, j), box.min[j], box.max[j]);
    b.add(products(i, k), box.min[k], box.max[k]);
    c.add(sign * f.constant, sign * f.constant);
    for (const int m : {j, k}) {
        add_least(sign * f.squares[m], sign * f.linear[m], box.min[m], box.max[m], c);
    }
    const double corners[] = {product(box.min[j], box.min[k]), product(box.min[j], box.max[k]), product(box.max[j], box.min[k]), product(box.max[j], box.max[k])};
    c.add(products(j, k), *std::min_element(corners, corners + 4), *std::max_element(corners, corners + 4));
    Range out = positive_solutions(sign * f.squares[i], b.lowest(), c.lowest());
    const Range mirrored = positive_solutions(sign * f.squares[i], -b.highest(), c.lowest());
    if (mirrored.low <= mirrored.high) out.extend({-mirrored.high, -mirrored.low});
    return out;
}

}  // namespace

Bounds narrowed(const Quadric& f, bool outside, const Bounds& box) {
    Bounds out = box;
    for (int i = 0; i < 3 && !out.empty(); ++i) {
        const Range x = solutions(f, outside ? -1 : 1, out, i);
        out.min[i] = std::max(out.min[i], x.low), out.max[i] = std::min(out.max[i], x.high);
    }
    return out;
}

}  // namespace alidade
