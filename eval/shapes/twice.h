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

inline Twice operator*(double k, const Twice& a) {
    const Twice p = Twice::product(k, a.high);
    return Twice::sum(p.high, std::fma(k, a.low, p.low));
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

/// A root after a step of Newton's, `value` of the function being known with twice the digits. A step beyond rounding, where the line hardly falls or rises, is not taken. `scale`: of t and of
/// what it was made of.
inline double after_step(double t, double scale, const Twice& value, double slope) {
    const double step = value.value() / slope;
    return std::abs(step) <= 1e-9 * scale ? t - step : t;
}

inline Twice dot(const TwiceVec& a, const TwiceVec& b) { return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2]; }

}  // namespace alidade
