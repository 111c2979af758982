// SPDX-License-Identifier: Apache-2.0
/// Functions and splines that a scene declares, and their calls while it is read.
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// `function [(parameters)] { ... }` or `function W, H { ... }` behind its word: kept as tokens with identifiers resolved.
Value parse_function(Parser& p, Place at);
/// The same behind a name and `=`.
Value parse_declared_function(Parser& p, Place at);
/// `(arguments)` of a function. `at`: of its name.
Value call_function(Parser& p, const Function& function, Place at);

/// `spline { ... }` behind its word.
Value parse_spline(Parser& p, Place at);
/// `(t)` or `(t, type)` of a spline.
Value call_spline(Parser& p, const Spline& spline, Place at);

}  // namespace alidade::pov
