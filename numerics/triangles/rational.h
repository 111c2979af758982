// SPDX-License-Identifier: Apache-2.0
/// A ray and a triangle in rational arithmetic: no rounding anywhere.
#pragma once

#include "core/ray.h"

#include <gmpxx.h>

#include <array>

namespace alidade::numerics {

using Rational = mpq_class;
using RationalVec = std::array<Rational, 3>;

RationalVec rational(const Vec3& v);  ///< exact: every finite double is rational
RationalVec operator-(const RationalVec& a, const RationalVec& b);
RationalVec cross(const RationalVec& a, const RationalVec& b);
Rational dot(const RationalVec& a, const RationalVec& b);

/// Where the line of a ray meets the plane of a triangle.
struct ExactCrossing {
    int side = -1;     ///< 1: inside the triangle; 0: on an edge or vertex; -1: outside, or parallel
    Rational t, u, v;  ///< of the crossing; the point is (1-u-v) p0 + u p1 + v p2. Not set if parallel
};
ExactCrossing exact_crossing(const Ray& ray, const std::array<Vec3, 3>& triangle);

/// Is `p` within `bound` of the plane of the triangle, measured along the normal?
bool within(const Vec3& p, double bound, const std::array<Vec3, 3>& triangle);

/// |computed - exact| / |exact|; |computed| where exact is 0.
double relative_error(double computed, const Rational& exact);

}  // namespace alidade::numerics
