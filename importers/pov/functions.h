// SPDX-License-Identifier: Apache-2.0
/// Functions and splines that a scene declares, and their calls while it is read.
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// `function [(parameters)] { ... }` or `function W, H { ... }` behind its word: kept as tokens with identifiers resolved.
Value parse_function(Parser& p, Place at);
/// `(arguments)` of a function. `at`: of its name.
Value call_function(Parser& p, const Function& function, Place at);

/// `spline { ... }` behind its word.
Value parse_spline(Parser& p, Place at);
/// `(t)` or `(t, type)` of a spline.
Value call_spline(Parser& p, const Spline& spline, Place at);
/// The value at `t`: linear; quadratic through three knots; natural cubic; cubic_spline with tangents of both sides. All are constant outside.
std::array<double, 5> spline_value(const Spline& spline, double t);

}  // namespace alidade::pov
