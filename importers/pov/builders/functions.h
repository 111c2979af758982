// SPDX-License-Identifier: Apache-2.0
/// Functions of the language -> programs of the scene.
#pragma once

#include "eval/functions/internal.h"
#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// The block of a function that is nothing but `pattern { }`, `pigment { }` or `transform { }`, or null.
const Block* block_of(const Function& function);
/// The row of a function that is nothing but `internal(N)`, or null. Fails for numbers that are not modelled.
const InternalFunction* internal_of(const Parser& p, const Function& function);

/// A function of a number: an expression, `pattern { }` or `internal(N)`. Each is built once. Fails where POV-Ray does, and for what is not modelled (Failure::unmodelled).
FunctionId build_function(Build& build, const Function& function);
/// The pattern of a `function { pattern { } }`: a signal without a map.
SignalId build_number_pattern(Build& build, const Block& block);
/// The pigment of a `function { pigment { } }`.
SignalId build_function_pigment(Build& build, const Block& block);

/// Is a function that stands at `place` there by a name?
bool is_declared(const Function& function, Place place);
/// Fails unless the function that stands in a pattern's place is one that POV-Ray takes there. `place`: where it is named.
void check_pattern_function(const Parser& p, const Function& function, Place place);

}  // namespace alidade::pov
