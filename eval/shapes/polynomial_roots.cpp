// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/polynomial_roots.h"

#include "core/powers_of_two.h"
#include "eval/shapes/bracketed_root.h"

#include <algorithm>

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

/// A Univariate whose degree the compiler knows: of the loops over so few coefficients, counting is half.
template <int kDegree> struct UnivariateOf {
    const double* a;

    std::pair<double, double> operator()(double x) const {
        double value = a[kDegree], slope = 0;
        for (int i = kDegree; i-- > 0;) slope = slope * x + value, value = value * x + a[i];
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

/// roots_between(), of a Univariate or a UnivariateOf.
template <class F> int roots_between_in_steps(const F& f, const double* extremes, int count, double precision, double* roots, double from, double to) {
    constexpr double kLeastStep = 0x1p-110;   // for a root at 0, which no relative step is small enough for
    int found = 0;
    double low = -1;
    bool positive = f(low).first > 0;
    for (int i = 0; i <= count; ++i) {
        const double high = i < count ? extremes[i] : 1;
        const bool next = f(high).first > 0;
        if (next != positive) roots[found++] = high < from ? high : low > to ? low : bracketed_root(f, low, high, positive, kLeastStep, precision);
        low = high, positive = next;
    }
    return found;
}

/// The roots of f within -1 .. 1, from those of its derivative there. Those outside of from .. to are not found exactly.
int roots_between(const Univariate& f, const double* extremes, int count, double precision, double* roots, double from = -1, double to = 1) {
    switch (f.degree) {
        case 3: return roots_between_in_steps(UnivariateOf<3>{f.a}, extremes, count, precision, roots, from, to);
        case 4: return roots_between_in_steps(UnivariateOf<4>{f.a}, extremes, count, precision, roots, from, to);
        default: return roots_between_in_steps(f, extremes, count, precision, roots, from, to);
    }
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

/// Bernstein coefficients of polynomials up to this degree are looked at, and of parts halved this often.
constexpr int kMostCertified = 6, kRootHalvings = 3;

/// A polynomial of a part of the line, as its Bernstein coefficients.
template <int kDegree> struct Part {
    double b[kDegree + 1];

    /// Of f from `low` to `high`; `slack`: more than all roundings.
    Part(const Univariate& f, double low, double high, double& slack) {
        const double reach = 3 * std::max(std::abs(low), std::abs(high)), width = high - low;
        slack = 0;
        for (int i = kDegree; i >= 0; --i) b[i] = f.a[i], slack = slack * reach + std::abs(f.a[i]);
        slack *= 1e-13;
        for (int k = 0; k < kDegree; ++k)
            for (int i = kDegree - 1; i >= k; --i) b[i] += low * b[i + 1];
        double scale = 1;   // width^i over the binomial coefficient of i
        for (int i = 1; i <= kDegree; ++i) scale *= width * i / (kDegree - i + 1), b[i] *= scale;
        for (int k = 0; k < kDegree; ++k)
            for (int i = kDegree; i > k; --i) b[i] += b[i - 1];
    }

    /// 1 or -1 if f has that sign all along; 0 if that is not seen.
    int sign(double slack, int halvings) {
        double least = b[0], most = b[0];
        for (int i = 1; i <= kDegree; ++i) least = std::min(least, b[i]), most = std::max(most, b[i]);
        if (least > slack) return 1;
        if (most < -slack) return -1;
        const int here = b[0] > slack ? 1 : b[0] < -slack ? -1 : 0;
        if (halvings == 0 || here == 0 || !(here * b[kDegree] > slack)) return 0;
        Part front = *this;
        for (int k = 1; k <= kDegree; ++k) {   // de Casteljau: the halves are the sides of the triangle
            for (int i = 0; i <= kDegree - k; ++i) b[i] = 0.5 * (b[i] + b[i + 1]);
            front.b[k] = b[0];
        }
        return front.sign(slack, halvings - 1) == here ? sign(slack, halvings - 1) : 0;
    }
};

/// The sign of f between `from` and `to`; 0 if it may change. For each degree up to kDegree its own, as of UnivariateOf.
template <int kDegree> int certain_sign_between(const Univariate& f, double from, double to) {
    if constexpr (kDegree > 1)
        if (f.degree < kDegree) return certain_sign_between<kDegree - 1>(f, from, to);
    double slack;
    Part<kDegree> part(f, from, to, slack);
    return part.sign(slack, kRootHalvings);
}

/// The sign of f within -1 .. 1 and the range; 0 if it may change.
int certain_sign(const Univariate& f, double from, double to) {
    from = std::max(from, -1.0), to = std::min(to, 1.0);
    if (f.degree > kMostCertified || !(from < to)) return 0;
    return certain_sign_between<kMostCertified>(f, from, to);
}

/// f = x^zeros g: near 0, powers of x are lost below the least number, and no bracket could tell where f is 0 from where it only vanishes. So g is asked, and 0 is put in:
/// once where f changes its sign there, twice where it is positive on both sides.
int with_roots_at_zero(std::span<const double> g, int zeros, RootRange& range, double* roots) {
    RootRange all;
    int count = real_roots_in(g, all, roots);
    const bool odd = zeros % 2 != 0;
    range.sign = odd ? -all.sign : all.sign;
    const int more = odd ? 1 : g.front() > 0 ? 2 : 0;
    double* const at = std::lower_bound(roots, roots + count, 0.0);
    std::copy_backward(at, roots + count, roots + count + more);
    std::fill_n(at, more, 0.0);
    return count + more;
}

}  // namespace

int real_roots(std::span<const double> coefficients, double* roots) {
    RootRange all;
    return real_roots_in(coefficients, all, roots);
}

int real_roots_in(std::span<const double> coefficients, RootRange& range, double* roots) {
    while (!coefficients.empty() && coefficients.back() == 0) coefficients = coefficients.first(coefficients.size() - 1);
    const int degree = int(coefficients.size()) - 1;
    if (degree < 1 || degree > kMostRoots) return 0;
    for (const double a : coefficients)
        if (!std::isfinite(a)) return 0;
    if (std::all_of(coefficients.begin(), coefficients.end() - 1, [](double a) { return a == 0; })) {
        for (int i = 0; i < degree; ++i) roots[i] = 0;
        return degree;
    }
    if (coefficients.front() == 0) {
        const auto zeros = std::find_if(coefficients.begin(), coefficients.end(), [](double a) { return a != 0; }) - coefficients.begin();
        return with_roots_at_zero(coefficients.subspan(size_t(zeros)), int(zeros), range, roots);
    }
    const int exponent = bound_exponent(coefficients);
    Univariate chain[kMostRoots + 1];
    chain[degree] = scaled(coefficients, exponent);
    const double from = scaled_by(range.from, -exponent), to = scaled_by(range.to, -exponent);
    if ((range.sign = certain_sign(chain[degree], from, to)) != 0) return 0;
    range.sign = chain[degree](-1).first > 0 ? 1 : -1;
    for (int i = degree; i > 1; --i) chain[i - 1] = derivative(chain[i]);
    double extremes[kMostRoots];
    int count = degree > 1 ? quadratic_roots(chain[2], roots) : 0;
    std::copy(roots, roots + count, extremes);
    for (int i = degree > 1 ? 3 : 1; i <= degree; ++i) {
        count = i < degree ? roots_between(chain[i], extremes, count, kOfExtremes, roots) : roots_between(chain[i], extremes, count, kOfRoots, roots, from, to);
        std::copy(roots, roots + count, extremes);
    }
    for (int i = 0; i < count; ++i) roots[i] = scaled_by(roots[i], exponent);
    return count;
}

}  // namespace alidade
