// SPDX-License-Identifier: Apache-2.0
/// Numbers of twice a double's digits, for the few lines that nearly touch a surface: there, a rounding in the last place moves a crossing by its square root.
#pragma once

#include "core/vec.h"

#include <cmath>

namespace alidade {

/// An unevaluated sum, |low| at most half a unit in the last place of high.
/// Source   D. E. Knuth, "The Art of Computer Programming", vol. 2, 3rd ed., 4.2.2; T. J. Dekker, "A Floating-Point Technique for Extending the Available Precision" (1971).
struct Twice {
    double high = 0, low = 0;

    Twice() = default;
    Twice(double x) : high(x) {}
    double value() const { return high + low; }

    static Twice sum(double a, double b) {
        Twice s(a + b);
        const double of_b = s.high - a;
        s.low = (a - (s.high - of_b)) + (b - of_b);
        return s;
    }
    static Twice product(double a, double b) {
        Twice p(a * b);
        p.low = std::fma(a, b, -p.high);
        return p;
    }
};

inline Twice operator+(const Twice& a, const Twice& b) {
    const Twice high = Twice::sum(a.high, b.high), low = Twice::sum(a.low, b.low);
    const Twice first = Twice::sum(high.high, high.low + low.high);
    return Twice::sum(first.high, first.low + low.low);
}
inline Twice operator-(const Twice& a) {
    Twice minus(-a.high);
    minus.low = -a.low;
    return minus;
}
inline Twice operator-(const Twice& a, const Twice& b) { return a + -b; }
inline Twice operator*(const Twice& a, const Twice& b) {
    const Twice p = Twice::product(a.high, b.high);
    return Twice::sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

struct TwiceVec {
    Twice v[3];

    TwiceVec() = default;
    TwiceVec(const Vec3& a) : v{a.x, a.y, a.z} {}
    /// a - b, exactly.
    static TwiceVec difference(const Vec3& a, const Vec3& b) {
        TwiceVec d;
        for (int i = 0; i < 3; ++i) d.v[i] = Twice::sum(a[i], -b[i]);
        return d;
    }
    /// This + t * d.
    TwiceVec moved(const Twice& t, const TwiceVec& d) const {
        TwiceVec m;
        for (int i = 0; i < 3; ++i) m.v[i] = v[i] + t * d.v[i];
        return m;
    }
};

/// Lines whose cosine to the normal has a smaller square than this are near a tangent.
inline constexpr double kNearTangent = 1.0 / 16;

/// A root of a function with derivative `slope` there, after a Newton step with twice the digits if that leads nearer. `f(t)` is a Twice.
template <class F> double refined(const F& f, double t, double slope) {
    const double here = f(t).value(), next = t - here / slope;
    return std::isfinite(next) && std::abs(f(next).value()) < std::abs(here) ? next : t;
}

inline Twice dot(const TwiceVec& a, const TwiceVec& b) { return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2]; }

}  // namespace alidade
