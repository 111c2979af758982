// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/polynomial_roots.h"

#include "core/powers_of_two.h"
#include "eval/shapes/bracketed_root.h"

namespace alidade {

namespace {

/// a[0] + a[1] x + ...
struct Univariate {
    double a[kMostRoots + 1];
    int degree;

    std::pair<double, double> operator()(double x) const {
        double value = a[degree], slope = 0;
        for (int i = degree; i-- > 0;) slope = slope * x + value, value = value * x + a[i];
        return {value, slope};
    }
};

/// k such that all roots lie within 2^k, and for x scaled by a power of two, the k changed by its exponent.
int bound_exponent(std::span<const double> a) {
    const int degree = int(a.size()) - 1, leading = exponent_of(a.back());
    int bound = std::numeric_limits<int>::min();
    for (int i = 0; i < degree; ++i) {
        if (a[size_t(i)] == 0) continue;
        const int ratio = exponent_of(a[size_t(i)]) - leading + 1, order = degree - i;
        bound = std::max(bound, ratio >= 0 ? (ratio + order - 1) / order : -(-ratio / order));
    }
    return bound + 1;
}

/// The polynomial as one of x / 2^exponent, its largest coefficient between 1 and 2.
Univariate scaled(std::span<const double> a, int exponent) {
    Univariate f;
    f.degree = int(a.size()) - 1;
    int largest = std::numeric_limits<int>::min();
    for (int i = 0; i <= f.degree; ++i)
        if (a[size_t(i)] != 0) largest = std::max(largest, exponent_of(a[size_t(i)]) + i * exponent);
    for (int i = 0; i <= f.degree; ++i) f.a[i] = scaled_by(a[size_t(i)], i * exponent - largest);
    return f;
}

Univariate derivative(const Univariate& f) {
    Univariate d;
    d.degree = f.degree - 1;
    for (int i = 0; i < f.degree; ++i) d.a[i] = (i + 1) * f.a[i + 1];
    return d;
}

/// f bends back at an extreme: where that is found to 2^-40, f itself is right to 2^-80.
constexpr double kOfExtremes = 0x1p-40, kOfRoots = 0x1p-51;

/// The roots of f within -1 .. 1, from those of its derivative there.
int roots_between(const Univariate& f, const double* extremes, int count, double precision, double* roots) {
    constexpr double kLeastStep = 0x1p-110;   // for a root at 0, which no relative step is small enough for
    int found = 0;
    double low = -1;
    bool positive = f(low).first > 0;
    for (int i = 0; i <= count; ++i) {
        const double high = i < count ? extremes[i] : 1;
        const bool next = f(high).first > 0;
        if (next != positive) roots[found++] = bracketed_root(f, low, high, positive, kLeastStep, precision);
        low = high, positive = next;
    }
    return found;
}

/// Those of a quadratic within -1 .. 1, by the formula that does not cancel.
int quadratic_roots(const Univariate& f, double* roots) {
    const double c = f.a[0], b = f.a[1], a = f.a[2], discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return 0;
    const double sum = -0.5 * (b + std::copysign(std::sqrt(discriminant), b)), one = sum / a, other = sum != 0 ? c / sum : one;
    int found = 0;
    for (const double root : {std::min(one, other), std::max(one, other)})
        if (std::abs(root) <= 1) roots[found++] = root;
    return found;
}

}  // namespace

int real_roots(std::span<const double> coefficients, double* roots) {
    while (!coefficients.empty() && coefficients.back() == 0) coefficients = coefficients.first(coefficients.size() - 1);
    const int degree = int(coefficients.size()) - 1;
    if (degree < 1 || degree > kMostRoots) return 0;
    for (const double a : coefficients)
        if (!std::isfinite(a)) return 0;
    if (std::all_of(coefficients.begin(), coefficients.end() - 1, [](double a) { return a == 0; })) {
        for (int i = 0; i < degree; ++i) roots[i] = 0;
        return degree;
    }
    const int exponent = bound_exponent(coefficients);
    Univariate chain[kMostRoots + 1];
    chain[degree] = scaled(coefficients, exponent);
    for (int i = degree; i > 1; --i) chain[i - 1] = derivative(chain[i]);
    double extremes[kMostRoots];
    int count = degree > 1 ? quadratic_roots(chain[2], roots) : 0;
    std::copy(roots, roots + count, extremes);
    for (int i = degree > 1 ? 3 : 1; i <= degree; ++i) {
        count = roots_between(chain[i], extremes, count, i < degree ? kOfExtremes : kOfRoots, roots);
        std::copy(roots, roots + count, extremes);
    }
    for (int i = 0; i < count; ++i) roots[i] = scaled_by(roots[i], exponent);
    return count;
}

}  // namespace alidade
