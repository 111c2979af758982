// SPDX-License-Identifier: Apache-2.0
/// Bounds on rounding errors. There is no scene-wide epsilon anywhere: a bound lives at the function whose error it bounds.
#pragma once

#include <cmath>
#include <limits>

namespace alidade {

/// Unit roundoff of R: half the distance between 1 and the next number.
template <class R> inline constexpr R kUnitRoundoff = std::numeric_limits<R>::epsilon() / 2;

/// gamma_n = n u / (1 - n u): bounds the relative error of n successive roundings.
/// Source   Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed. (2002), lemma 3.1.
template <class R = double> constexpr R gamma_bound(int n) {
    return (R(n) * kUnitRoundoff<R>) / (R(1) - R(n) * kUnitRoundoff<R>);
}

/// How far a computed hit may lie from the true surface: in the space of the ray, along the surface's normal, and never negative.
struct ErrorBound {
    double along_normal = 0;
};

}  // namespace alidade
