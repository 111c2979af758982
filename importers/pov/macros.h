// SPDX-License-Identifier: Apache-2.0
/// #macro and its calls (POV-Ray reference, 3.3.2.8).
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// `#macro NAME (parameters)`: the body is not read, but remembered as a range of tokens. `index`: of the directive in its frame.
void define_macro(Parser& p, const Token& directive, uint32_t index);
/// Reads the arguments, and makes the body what is read next. An argument that is an identifier or an array element alone is passed by
/// reference: what the macro assigns to its parameter, the caller's variable gets.
void call_macro(Parser& p, const Token& name, Ref<Macro> macro);

}  // namespace alidade::pov
