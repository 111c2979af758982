// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

namespace alidade {

inline constexpr int kMostRoots = 35;

/// The real roots of coefficients[0] + coefficients[1] x + ... in order, into `roots`, which has room for as many as the degree. How many there are.
///
/// Method   All roots lie within a bound that is a power of two (M. Fujiwara, Tohoku Math. J. 10 (1916), rounded up), to which x is scaled without loss.
///          Between two neighbouring roots of its derivative a polynomial has at most one root, with a change of sign; so the roots of the
///          derivative of order 2 lead to those of the one before, and so on, each by bracketed Newton steps. After C. Yuksel, "High-Performance Polynomial
///          Root Finding for Graphics", Proc. ACM Comput. Graph. Interact. Tech. 5 (2022).
/// Error    a root is where the polynomial as computed changes its sign, or aside by 2^-51 of it or 2^-100 of that bound. None is lost but in pairs, where the polynomial
///          between them is as small as its rounding; so the count is always even or odd as the signs at both ends say.
int real_roots(std::span<const double> coefficients, double* roots);

/// Where roots are asked for.
struct RootRange {
    double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
    int sign = 0;   ///< what is told of the polynomial before the first root, or all along the range if there are none: 1 or -1; 0: nothing
};

/// Those in the range, bit for bit. Others may be anywhere on their side of it, in order; or left out, if there are none in the range.
///
/// Method   of the part in the range the Bernstein coefficients are found; if all have one sign, so has the polynomial. If they have not, halves are asked.
/// Source   G. Farin, "Curves and Surfaces for CAGD", 5th ed. (2002), section 6.
int real_roots_in(std::span<const double> coefficients, RootRange& range, double* roots);

}  // namespace alidade
