// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/narrow.h"
#include "eval/shapes/polynomial_horner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade {

namespace {

/// What everything is widened by, in parts of the terms: far more than their roundings.
constexpr double kSlack = 1e-12;
/// How many times a box is halved along each axis, and how many parts are looked at in all.
constexpr int kHalvings = 5, kMostParts = 4096;
/// Polynomials with more terms than this stay as they are: a part would take too long.
constexpr size_t kMostTerms = 500;

/// Holds all values over a box; `magnitude` bounds the sum of the magnitudes of the terms.
struct Range {
    double low = 0, high = 0, magnitude = 0;

    void times(double a, double b) {
        const auto [least, most] = std::minmax({low * a, low * b, high * a, high * b});
        low = least, high = most, magnitude *= std::max(std::abs(a), std::abs(b));
    }
    void add(const Range& r) { low += r.low, high += r.high, magnitude += r.magnitude; }
    void add(double c) { low += c, high += c, magnitude += std::abs(c); }
};

/// May sign * f be 0 or less somewhere in the box?
bool may_hold(const Polynomial& f, double sign, const Bounds& box) {
    const Range r = horner<Range>(f, [&](Range& sum, int axis) { sum.times(box.min[axis], box.max[axis]); });
    const double least = sign > 0 ? r.low : -r.high;
    return !(least > kSlack * r.magnitude);   // what is not a number is kept
}

/// Calls visit(i, j, k, c) for the terms c x^i y^j z^k.
template <class Visit> void for_each_term(const Polynomial& f, const Visit& visit) {
    size_t at = 0;
    for (int i = f.order; i >= 0; --i)
        for (int j = f.order - i; j >= 0; --j)
            for (int k = f.order - i - j; k >= 0; --k) visit(i, j, k, f.coefficients[at++]);
}

/// With r the largest coordinate of a point, sign * f > 0 where r is greater than this; infinite where that is not known. It is where the terms of the
/// highest degree have even powers alone and none is negative: then their sum is at least m r^order, m being the least of the three pure ones.
/// Source   the bound on the roots of m r^n = sum of s_k r^k of M. Fujiwara, Tohoku Math. J. 10 (1916).
double reach(const Polynomial& f, double sign) {
    double least = kInf;
    bool known = f.order % 2 == 0;
    for_each_term(f, [&](int i, int j, int k, double c) {
        if (i + j + k < f.order) return;
        const bool even = i % 2 == 0 && j % 2 == 0 && k % 2 == 0;
        known = known && (even ? sign * c >= 0 : c == 0);
        if (std::max({i, j, k}) == f.order) least = std::min(least, sign * c);
    });
    if (!known || !(least > 0)) return kInf;
    std::vector<double> sums(size_t(f.order), 0.0);
    for_each_term(f, [&](int i, int j, int k, double c) {
        if (i + j + k < f.order) sums[size_t(i + j + k)] += std::abs(c);
    });
    double out = 0;
    for (int k = 0; k < f.order; ++k) out = std::max(out, std::pow(sums[size_t(k)] / least, 1.0 / (f.order - k)));
    return 2 * out * (1 + 1e-9);
}

/// Extends `found` by the parts of a box where the polynomial may hold.
class Search {
  public:
    Search(const Polynomial& f, double sign) : f_(f), sign_(sign) {}

    void run(const Bounds& box, int halvings) {
        if (found_.contains(box.min) && found_.contains(box.max)) return;   // it can add nothing
        if (looked_++ < kMostParts && !may_hold(f_, sign_, box)) return;
        if (halvings == 0 || looked_ >= kMostParts) return found_.extend(box);
        const Vec3 middle = box.center();
        for (int octant = 0; octant < 8; ++octant) {
            Bounds part = box;
            for (int a = 0; a < 3; ++a) (octant >> a & 1 ? part.min : part.max)[a] = middle[a];
            run(part, halvings - 1);
        }
    }
    const Bounds& found() const { return found_; }

  private:
    const Polynomial& f_;
    double sign_;
    int looked_ = 0;
    Bounds found_;
};

}  // namespace

Bounds narrowed(const Polynomial& f, bool outside, const Bounds& box) {
    if (!is_complete(f) || f.coefficients.size() > kMostTerms || box.empty()) return box;
    const double sign = outside ? -1 : 1, far = reach(f, sign);
    const Bounds start = intersection(box, Bounds{Vec3(-far), Vec3(far)});
    if (start.empty()) return Bounds();
    if (!start.finite()) return start;
    Search search(f, sign);
    search.run(start, kHalvings);
    return search.found();
}

}  // namespace alidade
