// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/narrow.h"
#include "eval/shapes/polynomial_horner.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace alidade {

namespace {

/// What everything is widened by, in parts of the terms: far more than their roundings.
constexpr double kSignSlack = 1e-12;
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
    return !(least > kSignSlack * r.magnitude);   // what is not a number is kept
}

/// Calls visit(i, j, k, c) for the terms c x^i y^j z^k.
template <class Visit> void for_each_term(const Polynomial& f, const Visit& visit) {
    size_t at = 0;
    for (int i = f.order; i >= 0; --i)
        for (int j = f.order - i; j >= 0; --j)
            for (int k = f.order - i - j; k >= 0; --k) visit(i, j, k, f.coefficients[at++]);
}

/// All t >= 0 with t^n <= the sum of s_k t^k, k < n, are at most this: twice the greatest (s_k)^(1 / (n - k)).
/// Source   M. Fujiwara, Tohoku Math. J. 10 (1916).
double largest_root(std::span<const double> s) {
    double out = 0;
    for (size_t k = 0; k < s.size(); ++k) out = std::max(out, std::pow(s[k], 1.0 / double(s.size() - k)));
    return 2 * out * (1 + 1e-9);
}

bool is_even(int i, int j, int k) { return i % 2 == 0 && j % 2 == 0 && k % 2 == 0; }

/// With r the largest coordinate of a point, sign * f > 0 where r is greater than this; infinite where that is not known. It is where the terms of the
/// highest degree have even powers alone and none is negative: then their sum is at least m r^order, m being the least of the three pure ones.
double reach_together(const Polynomial& f, double sign) {
    double least = kInf;
    bool known = f.order % 2 == 0;
    std::vector<double> sums(size_t(f.order), 0.0);
    for_each_term(f, [&](int i, int j, int k, double c) {
        if (i + j + k < f.order) return void(sums[size_t(i + j + k)] += std::abs(c));
        known = known && (is_even(i, j, k) ? sign * c >= 0 : c == 0);
        if (std::max({i, j, k}) == f.order) least = std::min(least, sign * c);
    });
    if (!known || !(least > 0)) return kInf;
    for (double& sum : sums) sum /= least;
    return largest_root(sums);
}

/// What is left of sign * f along one axis: the coefficients of the powers of that coordinate alone, but for the constant, up to the highest.
struct Pure {
    std::vector<double> c;

    bool grows() const { return c.size() > 2 && c.size() % 2 == 1 && c.back() > 0; }
    /// Over the leading coefficient, how much each lower power can take away; the constant is `more`.
    std::vector<double> losses(double more) const {
        std::vector<double> s{std::max(0.0, more / c.back())};
        for (size_t k = 1; k + 1 < c.size(); ++k) s.push_back(k % 2 == 0 ? std::max(0.0, -c[k] / c.back()) : std::abs(c[k] / c.back()));
        return s;
    }
    /// It is nowhere less than minus this: where the highest power outweighs the others it is not negative.
    double depth() const {
        const std::vector<double> s = losses(0);
        const double far = largest_root(s);
        double sum = 0;
        for (size_t k = 1; k < s.size(); ++k) sum += s[k] * std::pow(far, double(k));
        return sum * c.back() * (1 + 1e-9);
    }
};

/// As above, coordinate by coordinate, where all terms of several coordinates have even powers and none is negative: without them f is a sum of three
/// polynomials of one coordinate, each of which has a lower bound if its highest power does.
Vec3 reach_apart(const Polynomial& f, double sign) {
    Pure along[3];
    for (Pure& p : along) p.c.assign(1, 0.0);
    bool known = true;
    double constant = 0;
    for_each_term(f, [&](int i, int j, int k, double c) {
        const int power = i + j + k, axis = i == power ? 0 : j == power ? 1 : k == power ? 2 : 3;
        if (c == 0) return;
        if (power == 0) constant = sign * c;
        else if (axis == 3) known = known && is_even(i, j, k) && sign * c > 0;
        else along[axis].c.resize(std::max(along[axis].c.size(), size_t(power) + 1), 0.0), along[axis].c[size_t(power)] = sign * c;
    });
    if (!known || !along[0].grows() || !along[1].grows() || !along[2].grows()) return Vec3(kInf);
    Vec3 out;
    for (int a = 0; a < 3; ++a) out[a] = largest_root(along[a].losses(along[(a + 1) % 3].depth() + along[(a + 2) % 3].depth() - constant));
    return out;
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
    const double sign = outside ? -1 : 1;
    const Vec3 far = glm::min(Vec3(reach_together(f, sign)), reach_apart(f, sign));
    Bounds out = intersection(box, Bounds{-far, far});
    for (int round = 0; round < 2 && out.finite() && !out.empty(); ++round) {   // the second lattice is finer
        Search search(f, sign);
        search.run(out, kHalvings);
        out = search.found();
    }
    return out.empty() ? Bounds() : out;
}

}  // namespace alidade
