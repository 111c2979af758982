// SPDX-License-Identifier: Apache-2.0
/// Exact signs, for the few decisions that rounding leaves open.
#pragma once

#include "core/vec.h"

namespace alidade {

/// d . ((a - o) x (b - o)): which side of the edge from a to b the line through o along d passes. The sign is exact, also where it is 0; swapping
/// a and b negates the result exactly. The value is within a few ulps of the exact one.
///
/// Range    components must be 0 or multiples of 2^-300, and below 2^481 (2^25 for d): then nothing overflows or underflows.
/// Method   integers of 192 or 320 bits, where those hold the coordinates: an axis has its own unit. Else floating-point expansions: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997.
double exact_edge(const Vec3& d, const Vec3& o, const Vec3& a, const Vec3& b);

/// Do the three points lie on one line (or coincide), exactly? The range is that of exact_edge.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace alidade
