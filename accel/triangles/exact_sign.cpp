// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/exact_sign.h"

#include "core/error_bound.h"

#include <array>
#include <cassert>

namespace alidade {

namespace {

/// A rounded result and its error: together exactly the true one.
struct Pair {
    double high, low;
};

Pair two_sum(double a, double b) {
    const double sum = a + b, b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// As two_sum, for |a| >= |b| or a == 0.
Pair fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

Pair two_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// A number as an exact sum of doubles without zeros, which do not overlap and grow in magnitude. Zero has no terms.
template <size_t N> class Expansion {
  public:
    Expansion() = default;
    explicit Expansion(const Pair& p) { append(p.low), append(p.high); }

    void append(double term) {
        if (term != 0) assert(size_ < N), terms_[size_++] = term;
    }
    size_t size() const { return size_; }
    double operator[](size_t i) const { return terms_[i]; }

    /// Its last term dominates, so this has the exact sign; the terms are added from the smallest up.
    double value() const {
        double sum = 0;
        for (size_t i = 0; i < size_; ++i) sum += terms_[i];
        return sum;
    }

  private:
    std::array<double, N> terms_;
    size_t size_ = 0;
};

/// Merges the terms by magnitude and adds them up, keeping every error.
template <size_t N, size_t M> Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
    Expansion<N + M> sum;
    size_t i = 0, j = 0;
    const auto next = [&] { return j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j])) ? e[i++] : f[j++]; };
    const size_t count = e.size() + f.size();
    if (count == 0) return sum;
    double running = next();
    for (size_t k = 1; k < count; ++k) {
        const double term = next();
        const Pair p = k == 1 ? fast_two_sum(term, running) : two_sum(running, term);
        sum.append(p.low);
        running = p.high;
    }
    sum.append(running);
    return sum;
}

template <size_t N> Expansion<2 * N> operator*(const Expansion<N>& e, double factor) {
    Expansion<2 * N> product;
    if (e.size() == 0) return product;
    Pair p = two_product(e[0], factor);
    product.append(p.low);
    for (size_t i = 1; i < e.size(); ++i) {
        const Pair term = two_product(e[i], factor);
        const Pair sum = two_sum(p.high, term.low);
        product.append(sum.low);
        p = fast_two_sum(term.high, sum.high);
        product.append(p.low);
    }
    product.append(p.high);
    return product;
}

using Difference = Expansion<2>;

Difference difference(double a, double b) { return Difference(two_sum(a, -b)); }

Expansion<8> product(const Difference& a, const Difference& b) {
    if (b.size() == 0) return {};
    Expansion<8> result = a * b[0] + Expansion<4>();
    if (b.size() == 2) result = a * b[0] + a * b[1];
    return result;
}

Expansion<32> cross_term(double d, const Difference& ay, const Difference& az, const Difference& by, const Difference& bz) {
    if (d == 0) return {};
    return product(ay, bz) * d + product(az, by) * -d;
}

}  // namespace

double exact_edge(const Vec3& d, const Vec3& o, const Vec3& a, const Vec3& b) {
    std::array<Difference, 3> p, q;
    for (int i = 0; i < 3; ++i) p[size_t(i)] = difference(a[i], o[i]), q[size_t(i)] = difference(b[i], o[i]);
    return (cross_term(d.x, p[1], p[2], q[1], q[2]) + cross_term(d.y, p[2], p[0], q[2], q[0]) + cross_term(d.z, p[0], p[1], q[0], q[1])).value();
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 e = b - a, f = c - a;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double left = e[j] * f[k], right = e[k] * f[j];
        if (std::abs(left - right) > gamma_bound(8) * (std::abs(left) + std::abs(right))) return false;   // of any rounding of differences and products
    }
    return exact_edge({1, 0, 0}, a, b, c) == 0 && exact_edge({0, 1, 0}, a, b, c) == 0 && exact_edge({0, 0, 1}, a, b, c) == 0;
}

}  // namespace alidade
