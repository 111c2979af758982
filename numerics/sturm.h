// SPDX-License-Identifier: Apache-2.0
/// The real roots of polynomials whose coefficients are doubles, by integers of any length: also where roots are double, exactly.
#pragma once

#include "numerics/exact.h"

#include <span>

namespace alidade::numerics {

/// The different real roots of coefficients[0] + coefficients[1] x + ..., in order, each to 2^-160 of a bound of all. The last coefficient is not 0, and there are two or more.
/// Method   Sturm's theorem for the polynomial without its multiple roots, and halving.
std::vector<Exact> sturm_roots(std::span<const double> coefficients);

}  // namespace alidade::numerics
