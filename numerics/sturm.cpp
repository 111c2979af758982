// SPDX-License-Identifier: Apache-2.0
#include "numerics/sturm.h"

namespace alidade::numerics {

namespace {

using Integer = mpz_class;
using IntegerPolynomial = std::vector<Integer>;   ///< the last one is not 0

/// numerator / 2^halvings
struct Dyadic {
    Integer numerator;
    unsigned halvings = 0;

    Dyadic operator+(const Dyadic& other) const {
        const unsigned most = std::max(halvings, other.halvings);
        return {(numerator << (most - halvings)) + (other.numerator << (most - other.halvings)), most};
    }
    Dyadic half() const { return {numerator, halvings + 1}; }
};

/// Without what all coefficients have in common; the sign stays.
void make_primitive(IntegerPolynomial& p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
    Integer common = 0;
    for (const Integer& c : p) common = gcd(common, c);
    for (Integer& c : p) c /= common;
}

IntegerPolynomial derivative(const IntegerPolynomial& p) {
    IntegerPolynomial d;
    for (size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * int(i));
    make_primitive(d);
    return d;
}

/// What is left of k a / b, k > 0, and k's quotient.
IntegerPolynomial remainder(IntegerPolynomial a, const IntegerPolynomial& b, IntegerPolynomial& quotient) {
    const Integer leading = abs(b.back());
    quotient.assign(a.size() >= b.size() ? a.size() - b.size() + 1 : 0, 0);
    while (a.size() >= b.size()) {
        const Integer k = sgn(b.back()) * a.back();
        const size_t shift = a.size() - b.size();
        for (Integer& c : a) c *= leading;
        for (Integer& c : quotient) c *= leading;
        for (size_t i = 0; i < b.size(); ++i) a[i + shift] -= k * b[i];
        quotient[shift] += k;
        a.pop_back();
    }
    make_primitive(a);
    return a;
}

std::vector<IntegerPolynomial> sturm_chain(const IntegerPolynomial& p) {
    std::vector<IntegerPolynomial> chain{p, derivative(p)};
    IntegerPolynomial quotient;
    while (chain.back().size() > 1) {
        IntegerPolynomial next = remainder(chain[chain.size() - 2], chain.back(), quotient);
        if (next.empty()) break;
        for (Integer& c : next) c = -c;
        chain.push_back(std::move(next));
    }
    return chain;
}

int sign_at(const IntegerPolynomial& p, const Dyadic& x) {
    Integer sum = 0;   // of 2^(halvings i) times what Horner's rule has after i steps
    for (size_t i = p.size(); i-- > 0;) sum = sum * x.numerator + (p[i] << (x.halvings * (p.size() - 1 - i)));
    return sgn(sum);
}

/// Changes of sign along the chain: from x to y > x it loses one for each root in (x, y].
int changes(const std::vector<IntegerPolynomial>& chain, const Dyadic& x) {
    int n = 0, last = 0;
    for (const IntegerPolynomial& p : chain) {
        const int s = sign_at(p, x);
        n += s && last && s != last;
        if (s) last = s;
    }
    return n;
}

struct Search {
    const std::vector<IntegerPolynomial>& chain;
    std::vector<Dyadic> roots;

    /// The roots in (low, high], `steps` halvings deep at most.
    void isolate(const Dyadic& low, int at_low, const Dyadic& high, int at_high, int steps) {
        if (at_low == at_high) return;
        if (at_low == at_high + 1 || steps == 0) return refine(low, high, steps);
        const Dyadic middle = (low + high).half();
        const int at_middle = changes(chain, middle);
        isolate(low, at_low, middle, at_middle, steps - 1);
        isolate(middle, at_middle, high, at_high, steps - 1);
    }
    /// The only root in (low, high].
    void refine(Dyadic low, Dyadic high, int steps) {
        const int above = sign_at(chain[0], high);
        for (; above && steps > 0; --steps) {
            const Dyadic middle = (low + high).half();
            const int s = sign_at(chain[0], middle);
            if (s == 0) return roots.push_back(middle);
            (s == above ? high : low) = middle;
        }
        roots.push_back(above ? (low + high).half() : high);
    }
};

Integer shifted(double x, int exponent) {
    int own = 0;
    const double fraction = std::frexp(x, &own);
    return Integer(std::ldexp(fraction, 53)) << unsigned(own - 53 - exponent);
}

/// The polynomial of x / 2^scale, in integers.
IntegerPolynomial integers(std::span<const double> c, int scale) {
    int least = std::numeric_limits<int>::max();
    for (size_t i = 0; i < c.size(); ++i)
        if (c[i] != 0) least = std::min(least, std::ilogb(c[i]) - 53 + int(i) * scale);
    IntegerPolynomial p;
    for (size_t i = 0; i < c.size(); ++i) p.push_back(c[i] == 0 ? Integer(0) : shifted(c[i], least - int(i) * scale));
    make_primitive(p);
    return p;
}

/// All roots are within 2^exponent (Fujiwara).
int bound_exponent(std::span<const double> c) {
    double most = -1000;
    for (size_t i = 0; i + 1 < c.size(); ++i)
        if (c[i] != 0) most = std::max(most, (std::log2(std::abs(c[i])) - std::log2(std::abs(c.back()))) / double(c.size() - 1 - i));
    return int(std::ceil(most)) + 2;
}

}  // namespace

std::vector<Exact> sturm_roots(std::span<const double> coefficients) {
    const int scale = bound_exponent(coefficients);
    const IntegerPolynomial p = integers(coefficients, scale);
    std::vector<IntegerPolynomial> chain = sturm_chain(p);
    if (chain.back().size() > 1) {   // what p and its derivative have in common: the multiple roots
        IntegerPolynomial simple;
        remainder(p, chain.back(), simple);
        make_primitive(simple);
        chain = sturm_chain(simple);
    }
    Search search{chain, {}};
    const Dyadic low{-1, 0}, high{1, 0};
    search.isolate(low, changes(chain, low), high, changes(chain, high), 161);
    std::vector<Exact> roots;
    for (const Dyadic& x : search.roots) {
        Exact root(x.numerator, kBits);
        const int up = scale - int(x.halvings);
        if (up >= 0) mpf_mul_2exp(root.get_mpf_t(), root.get_mpf_t(), unsigned(up));
        else mpf_div_2exp(root.get_mpf_t(), root.get_mpf_t(), unsigned(-up));
        roots.push_back(root);
    }
    return roots;
}

}  // namespace alidade::numerics
