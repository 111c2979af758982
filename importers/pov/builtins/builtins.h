// SPDX-License-Identifier: Apache-2.0
/// The functions and values that the language brings along. Each stands in a table of one of the files here.
#pragma once

#include "importers/pov/parser.h"

#include <span>

namespace alidade::pov {

/// Reads its arguments, if it has any, and gives its value. The word itself, which stands at `at`, has been taken.
using Builtin = Value (*)(Parser& p, Place at);

struct BuiltinEntry {
    WordId word;
    Builtin evaluate;
};

std::span<const BuiltinEntry> float_functions();
std::span<const BuiltinEntry> vector_functions();
std::span<const BuiltinEntry> string_functions();
std::span<const BuiltinEntry> object_functions();
std::span<const BuiltinEntry> constants();
/// What else POV-Ray gives a scene: names that it may declare anew, and the command line before it. After the scene is open.
void predeclare(Parser& p);

/// The built-in of a word, or null.
Builtin find_builtin(WordId word);

/// The one argument in its brackets; and a float argument behind a comma.
double one_float(Parser& p);
double next_float(Parser& p);
Value one_value(Parser& p);
/// The bracket behind them.
void close(Parser& p);

Value of_three(const Vec3& v);

}  // namespace alidade::pov
