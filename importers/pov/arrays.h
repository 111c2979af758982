// SPDX-License-Identifier: Apache-2.0
/// Arrays, with the rules of POV-Ray 3.7 (reference, 3.3.1.10): rectangles of any values; assignment copies.
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// `array [n]... { initialisers }` behind its word.
Value parse_array(Parser& p, Place at);
/// The element that the subscripts behind an array mean. Empty if it was never assigned to, unless `make` makes it.
Ref<Slot> parse_subscripts(Parser& p, Array& array, bool make);
/// Fails unless `value`, which becomes an element, is of the kind of the first one that was given: so it is in POV-Ray, also where #undef has taken that.
void check_element(Parser& p, Array& array, const Value& value, Place at);
/// Fails where a subscript stands behind the name of what is no array. (Before 3.5 a declaration without a semicolon may end before a [.)
void refuse_subscript(Parser& p, const Token& name, const Value& value);
/// `value`, and if it is an array that somebody else holds, a copy of it and of the arrays in it: so arrays are trees.
Value owned(Parser& p, Value value, Place at);

}  // namespace alidade::pov
