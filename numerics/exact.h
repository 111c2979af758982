// SPDX-License-Identifier: Apache-2.0
/// Numbers of 512 bits, for oracles: a double goes in exactly.
#pragma once

#include "core/vec.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace alidade::numerics {

inline constexpr unsigned kBits = 512;
using Exact = mpf_class;

inline Exact exact(double x) { return Exact(x, kBits); }

struct ExactVec {
    Exact x, y, z;
    ExactVec(const Vec3& v) : x(exact(v.x)), y(exact(v.y)), z(exact(v.z)) {}
    ExactVec(Exact a, Exact b, Exact c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
};
inline ExactVec operator-(const ExactVec& a, const ExactVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline ExactVec operator+(const ExactVec& a, const ExactVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline ExactVec operator*(const ExactVec& a, const Exact& k) { return {a.x * k, a.y * k, a.z * k}; }
inline Exact dot(const ExactVec& a, const ExactVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline ExactVec cross(const ExactVec& a, const ExactVec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Exact length(const ExactVec& a) { return sqrt(dot(a, a)); }

/// The distance between a double and the next at x.
inline double ulp(double x) { return std::nextafter(std::abs(x), kInf) - std::abs(x); }
inline double to_double(const Exact& x) { return x.get_d(); }
inline double ulps(double x, const Exact& true_x, double of) { return to_double(abs(exact(x) - true_x)) / ulp(of); }

/// The real roots of a t^2 + 2 b t + c, in order; none or two.
inline std::vector<Exact> quadratic_roots(const Exact& a, const Exact& b, const Exact& c) {
    const Exact d = b * b - a * c;
    if (a == 0 || d < 0) return {};
    const Exact root = sqrt(d);
    std::vector<Exact> t{(-b - root) / a, (-b + root) / a};
    std::sort(t.begin(), t.end());
    return t;
}

}  // namespace alidade::numerics
