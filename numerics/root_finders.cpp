// SPDX-License-Identifier: Apache-2.0
/// The roots of polynomials, on which all surfaces of polynomials and the sides of outlines rest. (There are no isosurfaces yet; they will rest on brackets of the same kind.)
#include "core/draws.h"
#include "core/error_bound.h"
#include "eval/shapes/polynomial_roots.h"
#include "numerics/polynomial.h"
#include "numerics/rows.h"
#include "numerics/sturm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace alidade::numerics {

namespace {

using Coefficients = std::vector<double>;

ExactPolynomial exactly(const Coefficients& c) {
    ExactPolynomial p;
    for (const double x : c) p.push_back(exact(x));
    return p;
}

/// With these roots, and others that are not real, as nearly as doubles can say it.
Coefficients with_roots(const std::vector<double>& roots, int degree, Draws& draws) {
    ExactPolynomial p{exact(1)};
    for (const double r : roots) p = p * ExactPolynomial{exact(-r), exact(1)};
    while (int(p.size()) + 1 <= degree) {
        const Exact a = exact(draws.uniform(-1, 1)), b = exact(draws.uniform(0.1, 1));
        p = p * ExactPolynomial{a * a + b * b, -2 * a, exact(1)};
    }
    Coefficients c;
    for (const Exact& x : p) c.push_back(to_double(x));
    return c;
}

/// Some roots anywhere in -1 .. 1.
std::vector<double> any_roots(int count, Draws& draws) {
    std::vector<double> roots;
    for (int i = 0; i < count; ++i) roots.push_back(draws.uniform(-1, 1));
    return roots;
}

Coefficients random_coefficients(int degree, Draws& draws, NumericsTally&) {
    Coefficients c;
    for (int i = 0; i <= degree; ++i) c.push_back(draws.uniform(-1, 1));
    return c;
}

Coefficients of_any_magnitude(int degree, Draws& draws, NumericsTally&) {
    Coefficients c;
    for (int i = 0; i <= degree; ++i) {
        const double sign = draws.sign();
        c.push_back(draws.below(6) == 0 ? 0 : sign * std::pow(10, draws.uniform(-8, 8)));
    }
    return c;
}

Coefficients random_roots(int degree, Draws& draws, NumericsTally&) { return with_roots(any_roots(1 + int(draws.below(size_t(degree))), draws), degree, draws); }

/// Two to four roots close to each other.
Coefficients clustered(int degree, Draws& draws, NumericsTally& tally) {
    const double middle = draws.uniform(-1, 1), size = std::pow(10, draws.uniform(-5, -1));
    tally.at(NumericsScale::gap, size);
    std::vector<double> roots = any_roots(int(draws.below(3)), draws);
    for (int i = std::min(2 + int(draws.below(3)), degree); i > 0; --i) roots.push_back(middle + size * draws.uniform(-1, 1));
    return with_roots(roots, degree, draws);
}

/// Two roots 1e-12 to 0.1 apart, or none, where they nearly are.
Coefficients nearly_double(int degree, Draws& draws, NumericsTally& tally) {
    const double at = draws.uniform(-1, 1), gap = std::pow(10, draws.uniform(-12, -1));
    tally.at(NumericsScale::gap, gap);
    std::vector<double> roots = any_roots(int(draws.below(size_t(degree) - 1)), draws);
    roots.push_back(at), roots.push_back(at + gap);
    return with_roots(roots, degree, draws);
}

/// Quarters, of which one is there twice or more: the coefficients are exact, and so is the double root.
Coefficients doubled(int degree, Draws& draws, NumericsTally&) {
    std::vector<double> roots;
    for (int i = 0; i < degree; ++i) roots.push_back((double(draws.below(17)) - 8) / 4);
    roots[0] = roots[1];
    return with_roots(roots, degree, draws);
}

/// Powers of two, at which brackets end, 0 among them.
Coefficients at_ends(int degree, Draws& draws, NumericsTally&) {
    std::vector<double> roots = any_roots(int(draws.below(2)), draws);
    while (int(roots.size()) < degree - int(draws.below(2))) {
        const double sign = draws.sign();
        roots.push_back(draws.below(4) == 0 ? 0 : sign * std::exp2(int(draws.below(6)) - 3));
    }
    return with_roots(roots, degree, draws);
}

/// 1, 2, 3, ... divided by their number: the roots move by far more than the coefficients (Wilkinson 1959).
Coefficients evenly_spaced(int degree, Draws& draws, NumericsTally&) {
    std::vector<double> roots;
    for (int i = 1; i <= degree; ++i) roots.push_back(double(i) / degree);
    return with_roots(roots, degree, draws);
}

struct PolynomialClass {
    const char* name;
    Coefficients (*make)(int degree, Draws& draws, NumericsTally& tally);
};

constexpr PolynomialClass kClasses[] = {
    {"random coefficients", random_coefficients}, {"coefficients of any magnitude", of_any_magnitude}, {"random roots", random_roots}, {"clustered", clustered},
    {"nearly double", nearly_double}, {"double", doubled}, {"at the ends", at_ends}, {"evenly spaced", evenly_spaced},
};

Coefficients polynomial(uint64_t number, Draws& draws, NumericsTally& tally) {
    const int degree = 3 + int(draws.below(13)), scale = int(draws.below(41)) - 20;   // x becomes x / 2^scale
    Coefficients c = kClasses[number % std::size(kClasses)].make(degree, draws, tally);
    for (size_t i = 0; i < c.size(); ++i) c[i] = std::ldexp(c[i], -scale * int(i));
    return c;
}

/// What the value of the polynomial at x may be off, by Horner's rule in double.
double rounding(const Coefficients& c, double x) {
    double sum = 0;
    for (size_t i = c.size(); i-- > 0;) sum = sum * std::abs(x) + std::abs(c[i]);
    return gamma_bound(2 * int(c.size())) * sum;
}

/// A power of two beyond all roots (Fujiwara).
double bound_of(const Coefficients& c) {
    double bound = 0;
    for (size_t i = 0; i + 1 < c.size(); ++i) bound = std::max(bound, 2 * std::pow(std::abs(c[i] / c.back()), 1.0 / double(c.size() - 1 - i)));
    return std::exp2(std::ceil(std::log2(std::max(bound, 1e-300))));
}

/// The value of the polynomial near x, in units of its rounding; 0 if there is a root. Near: 2^-51 of x, or 2^-100 of the bound of all roots.
double value_near(const Coefficients& c, const ExactPolynomial& p, const std::vector<Exact>& roots, double x) {
    const Exact aside = exact(0x1p-51 * std::abs(x) + 0x1p-100 * bound_of(c)), low = exact(x) - aside, high = exact(x) + aside;
    if (std::any_of(roots.begin(), roots.end(), [&](const Exact& r) { return r >= low && r <= high; })) return 0;
    return std::min({to_double(abs(value(p, exact(x)))) / rounding(c, x), to_double(abs(value(p, low))) / rounding(c, to_double(low)), to_double(abs(value(p, high))) / rounding(c, to_double(high))});
}

/// A place where the sign of the polynomial is beyond doubt.
struct Sure {
    Exact x;
    int sign;
};

/// One outside of all roots on either side; and one between two, where there is any of 15: the value is more than 4 times its rounding.
std::vector<Sure> sure_places(const Coefficients& c, const ExactPolynomial& p, const std::vector<Exact>& roots) {
    Exact bound = exact(1);   // Cauchy's
    for (size_t i = 0; i + 1 < p.size(); ++i) bound = std::max(bound, Exact(2 + 2 * abs(p[i] / p.back())));
    const auto place = [&](const Exact& x) { return Sure{x, sgn(value(p, x))}; };
    std::vector<Sure> places{place(-bound)};
    for (size_t i = 0; i + 1 < roots.size(); ++i) {
        for (const int k : {8, 4, 12, 6, 10, 2, 14, 7, 9, 5, 11, 3, 13, 1, 15}) {
            const Exact x = roots[i] + (roots[i + 1] - roots[i]) * k / 16;
            if (!(to_double(abs(value(p, x))) > 4 * rounding(c, to_double(x)))) continue;
            places.push_back(place(x));
            break;
        }
    }
    places.push_back(place(bound));
    return places;
}

}  // namespace

Check roots() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(11, 0, number));
        Coefficients c = polynomial(number, draws, tally);
        while (!c.empty() && c.back() == 0) c.pop_back();
        if (c.size() < 2) return;
        const ExactPolynomial p = exactly(c);
        const std::vector<Exact> want = sturm_roots(c);
        std::array<double, kMostRoots> got{};
        const auto count = size_t(alidade::real_roots(c, got.data()));
        const auto what = [&] {
            return fmt::format("{}: {:a}; {} roots of {}: {}", kClasses[number % std::size(kClasses)].name, fmt::join(c, ", "), count, want.size(), fmt::join(got.begin(), got.begin() + ptrdiff_t(count), ", "));
        };
        for (size_t i = 0; i < count; ++i) {
            tally.measure(value_near(c, p, want, got[i]), 1, what);
            if (i > 0) tally.decide(got[i - 1] <= got[i], what);
        }
        const std::vector<Sure> places = sure_places(c, p, want);
        for (size_t i = 1; i < places.size(); ++i) {
            const Sure &low = places[i - 1], &high = places[i];
            const auto found = std::count_if(got.begin(), got.begin() + ptrdiff_t(count), [&](double x) { return x > low.x && x < high.x; });
            tally.decide(found % 2 == (low.sign != high.sign), what);   // where there is one true root, it is found; a pair more is where the value is rounding, as asked above
        }
    };
}

}  // namespace alidade::numerics
