// SPDX-License-Identifier: Apache-2.0
#include "numerics/polynomial.h"

namespace alidade::numerics {

namespace {

/// Coefficients below this of the largest are what rounding left of 0.
const Exact kNothing = [] {
    Exact x = exact(1);
    mpf_div_2exp(x.get_mpf_t(), x.get_mpf_t(), 360);
    return x;
}();

Exact largest(const ExactPolynomial& p) {
    Exact most = exact(0);
    for (const Exact& c : p) most = std::max(most, Exact(abs(c)));
    return most;
}

/// Without leading zeros, and with a largest coefficient of 1; signs stay.
void normalize(ExactPolynomial& p, const Exact& scale) {
    while (!p.empty() && abs(p.back()) <= kNothing * scale) p.pop_back();
    const Exact most = largest(p);
    for (Exact& c : p) c /= most;
}

ExactPolynomial derivative(const ExactPolynomial& p) {
    ExactPolynomial d;
    for (size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * int(i));
    return d;
}

ExactPolynomial negative_remainder(ExactPolynomial a, const ExactPolynomial& b) {
    const Exact scale = largest(a);
    while (a.size() >= b.size()) {
        const Exact k = a.back() / b.back();
        const size_t shift = a.size() - b.size();
        for (size_t i = 0; i < b.size(); ++i) a[i + shift] -= k * b[i];
        a.pop_back();
    }
    for (Exact& c : a) c = -c;
    normalize(a, scale);
    return a;
}

/// Changes of sign along Sturm's chain at t: between two places, their difference is the number of roots.
int changes(const std::vector<ExactPolynomial>& chain, const Exact& t) {
    int n = 0, last = 0;
    for (const ExactPolynomial& p : chain) {
        const int s = sgn(value(p, t));
        n += s && last && s != last;
        if (s) last = s;
    }
    return n;
}

void isolate(const std::vector<ExactPolynomial>& chain, const Exact& low, int at_low, const Exact& high, int at_high, const Exact& small, std::vector<Exact>& roots) {
    if (at_low == at_high) return;
    const Exact middle = (low + high) / 2;
    if (high - low <= small) {
        roots.push_back(middle);
        return;
    }
    const int at_middle = changes(chain, middle);
    isolate(chain, low, at_low, middle, at_middle, small, roots);
    isolate(chain, middle, at_middle, high, at_high, small, roots);
}

}  // namespace

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b) {
    ExactPolynomial p(a.size() + b.size() - 1, exact(0));
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t j = 0; j < b.size(); ++j) p[i + j] += a[i] * b[j];
    return p;
}

ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b) {
    ExactPolynomial p(std::max(a.size(), b.size()), exact(0));
    for (size_t i = 0; i < a.size(); ++i) p[i] += a[i];
    for (size_t i = 0; i < b.size(); ++i) p[i] += b[i];
    return p;
}

Exact value(const ExactPolynomial& p, const Exact& t) {
    Exact v = exact(0);
    for (size_t i = p.size(); i-- > 0;) v = v * t + p[i];
    return v;
}

std::vector<Exact> real_roots(ExactPolynomial p) {
    normalize(p, largest(p));
    if (p.size() < 2) return {};
    std::vector<ExactPolynomial> chain{p, derivative(p)};
    normalize(chain[1], largest(chain[1]));
    while (chain.back().size() > 1) {
        ExactPolynomial next = negative_remainder(chain[chain.size() - 2], chain.back());
        if (next.empty()) break;
        chain.push_back(std::move(next));
    }
    Exact bound = exact(1);   // Cauchy's
    for (size_t i = 0; i + 1 < p.size(); ++i) bound = std::max(bound, Exact(1 + abs(p[i] / p.back())));
    Exact small = bound;
    mpf_div_2exp(small.get_mpf_t(), small.get_mpf_t(), 160);
    std::vector<Exact> roots;
    const Exact low = -bound;
    isolate(chain, low, changes(chain, low), bound, changes(chain, bound), small, roots);
    return roots;
}

}  // namespace alidade::numerics
