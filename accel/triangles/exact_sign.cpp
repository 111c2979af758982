// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/exact_sign.h"

#include "core/error_bound.h"
#include "core/powers_of_two.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

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

__extension__ using Int128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

/// An integer of 320 bits, from -2^319 on.
class Long {
  public:
    Long() = default;
    /// a b
    Long(Int128 a, Int128 b) {
        const Unsigned128 x = a < 0 ? -Unsigned128(a) : Unsigned128(a), y = b < 0 ? -Unsigned128(b) : Unsigned128(b);
        const auto x0 = uint64_t(x), y0 = uint64_t(y), x1 = uint64_t(x >> 64), y1 = uint64_t(y >> 64);
        const Unsigned128 least = Unsigned128(x0) * y0, middle = Unsigned128(x0) * y1 + (least >> 64), other = Unsigned128(x1) * y0 + uint64_t(middle);
        const Unsigned128 most = Unsigned128(x1) * y1 + (middle >> 64) + (other >> 64);
        words_ = {uint64_t(least), uint64_t(other), uint64_t(most), uint64_t(most >> 64), 0};
        if ((a < 0) != (b < 0)) negate();
    }

    void negate() {
        bool carry = true;
        for (uint64_t& word : words_) word = ~word + carry, carry = carry && word == 0;
    }
    Long& operator+=(const Long& other) {
        Unsigned128 sum = 0;
        for (size_t i = 0; i < words_.size(); ++i) sum = (sum >> 64) + words_[i] + other.words_[i], words_[i] = uint64_t(sum);
        return *this;
    }
    Long& operator*=(int64_t factor) {
        const uint64_t size = factor < 0 ? -uint64_t(factor) : uint64_t(factor);
        Unsigned128 product = 0;
        for (uint64_t& word : words_) product = (product >> 64) + Unsigned128(word) * size, word = uint64_t(product);
        if (factor < 0) negate();
        return *this;
    }
    /// To a few ulps, with its sign.
    double value() const {
        Long size = *this;
        const bool negative = words_.back() >> 63;
        if (negative) size.negate();   // so that nothing cancels below
        double sum = 0;
        for (size_t i = words_.size(); i-- > 0;) sum = sum * 0x1p64 + double(size.words_[i]);
        return negative ? -sum : sum;
    }

  private:
    std::array<uint64_t, 5> words_{};   ///< the lowest first
};

/// Where the bits of some numbers stand: all are multiples of 2^low, and below 2^high.
struct BitRange {
    int low = 10000, high = -10000;   ///< none is but 0

    void add(double x) {
        if (x == 0) return;
        const auto bits = std::bit_cast<uint64_t>(x);
        const int exponent = int(bits >> 52 & 0x7ff) - 1075;
        low = std::min(low, exponent + std::countr_zero(bits | uint64_t(1) << 52)), high = std::max(high, exponent + 53);
    }
    bool empty() const { return low > high; }
    int bits() const { return empty() ? 0 : high - low; }
};

/// exact_edge's numbers as integers: those of each axis in a unit of its own, d in another multiple of each.
struct EdgeInIntegers {
    std::array<int, 3> unit{};   ///< exponents of 2
    int factor = 0;
    int point_bits = 0, direction_bits = 0;

    EdgeInIntegers(const Vec3& d, const Vec3& o, const Vec3& a, const Vec3& b) {
        BitRange directions;
        for (int i = 0; i < 3; ++i) {
            BitRange points, direction;
            points.add(o[i]), points.add(a[i]), points.add(b[i]), direction.add(d[i]);
            if (points.empty()) points = direction;   // 0 in any unit
            if (points.empty()) continue;
            unit[size_t(i)] = points.low;
            point_bits = std::max(point_bits, points.bits());
            if (!direction.empty()) directions.low = std::min(directions.low, direction.low - points.low), directions.high = std::max(directions.high, direction.high - points.low);
        }
        direction_bits = directions.bits(), factor = directions.empty() ? 0 : directions.low;
    }
    /// Powers of two that doubles have, and units that leave the numbers whole.
    bool fits(int points, int directions) const {
        const bool known = std::all_of(unit.begin(), unit.end(), [&](int u) { return std::abs(u) < 1000 && std::abs(u + factor) < 1000; });
        return known && point_bits <= points && direction_bits <= directions;
    }
    double point(double x, size_t axis) const { return x * power_of_two(-unit[axis]); }
    int64_t direction(double x, size_t axis) const { return int64_t(x * power_of_two(-unit[axis] - factor)); }
    double value(double of_integers) const { return std::ldexp(of_integers, unit[0] + unit[1] + unit[2] + factor); }
};

/// So many bits of each number: the sums of up to 2 + 2 * 62 + 61 bits have their halves in 128.
constexpr int kFewBits = 61;

double edge_of_few_bits(const EdgeInIntegers& n, const Vec3& d, const Vec3& o, const Vec3& a, const Vec3& b) {
    std::array<int64_t, 3> p{}, q{};
    for (size_t i = 0; i < 3; ++i) {
        const int axis = int(i);
        const auto origin = int64_t(n.point(o[axis], i));
        p[i] = int64_t(n.point(a[axis], i)) - origin, q[i] = int64_t(n.point(b[axis], i)) - origin;
    }
    Int128 high = 0, low = 0;   // of 2^64, and of 1
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const Int128 area = Int128(p[j]) * q[k] - Int128(p[k]) * q[j];
        const int64_t along = n.direction(d[int(i)], i);
        high += (area >> 64) * along, low += Int128(uint64_t(area)) * along;
    }
    high += low >> 64;
    auto rest = uint64_t(low);
    const bool negative = high < 0;
    if (negative) rest = -rest, high = rest == 0 ? -high : ~high;   // so that nothing cancels below
    const double size = double(high) * 0x1p64 + double(rest);
    return n.value(negative ? -size : size);
}

/// And so many: their sums have up to 2 + 2 * 125 + 61.
constexpr int kManyBits = 124;

double edge_of_many_bits(const EdgeInIntegers& n, const Vec3& d, const Vec3& o, const Vec3& a, const Vec3& b) {
    std::array<Int128, 3> p{}, q{};
    for (size_t i = 0; i < 3; ++i) {
        const int axis = int(i);
        const auto origin = Int128(n.point(o[axis], i));
        p[i] = Int128(n.point(a[axis], i)) - origin, q[i] = Int128(n.point(b[axis], i)) - origin;
    }
    Long sum;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        Long area(p[j], q[k]);
        area += Long(-p[k], q[j]);
        area *= n.direction(d[int(i)], i);
        sum += area;
    }
    return n.value(sum.value());
}

/// exact_edge for all numbers in its range.
double edge_in_expansions(const Vec3& d, const Vec3& o, const Vec3& a, const Vec3& b) {
    std::array<Difference, 3> p, q;
    for (int i = 0; i < 3; ++i) p[size_t(i)] = difference(a[i], o[i]), q[size_t(i)] = difference(b[i], o[i]);
    return (cross_term(d.x, p[1], p[2], q[1], q[2]) + cross_term(d.y, p[2], p[0], q[2], q[0]) + cross_term(d.z, p[0], p[1], q[0], q[1])).value();
}

}  // namespace

double exact_edge(const Vec3& d, const Vec3& o, const Vec3& a, const Vec3& b) {
    const EdgeInIntegers n(d, o, a, b);
    if (n.fits(kFewBits, kFewBits)) return edge_of_few_bits(n, d, o, a, b);
    if (n.fits(kManyBits, kFewBits)) return edge_of_many_bits(n, d, o, a, b);
    return edge_in_expansions(d, o, a, b);
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
