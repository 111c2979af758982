// SPDX-License-Identifier: Apache-2.0
/// The real roots of polynomials whose coefficients are exact.
#pragma once

#include "numerics/exact.h"

namespace alidade::numerics {

/// c[0] + c[1] t + ...
using ExactPolynomial = std::vector<Exact>;

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b);
ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b);
Exact value(const ExactPolynomial& p, const Exact& t);

/// Its different real roots in order, each to 2^-160 of the largest: by Sturm's theorem and halving.
std::vector<Exact> real_roots(ExactPolynomial p);

}  // namespace alidade::numerics
