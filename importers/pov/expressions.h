// SPDX-License-Identifier: Apache-2.0
/// Expressions are evaluated while they are read (POV-Ray reference, 3.3.1.5 to 3.3.1.9).
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// Where a value stands. In brackets directives and macros may stand between its parts; behind `=` of a #declare one ends it, since it may use what is being
/// declared: `#declare A = 2 #declare B = A*2` needs no semicolons.
enum class Standing { in_brackets, in_declaration };
/// What comes behind a part of a value.
inline Token peek_behind(Parser& p, Standing standing) { return standing == Standing::in_declaration ? p.peek_behind_value() : p.peek(); }

/// What may stand behind `=` of a #declare: any expression, colour, string, array, spline, function or block.
Value parse_value(Parser& p, Standing standing = Standing::in_brackets);
/// A float, vector or colour expression without comparisons (those stand in brackets alone), or another value as it is.
Value parse_expression(Parser& p, Standing standing = Standing::in_brackets);
/// What stands in brackets: comparisons, & and |, `? :`.
Value parse_full(Parser& p);
/// As a value is kept when it is declared or handed to a macro: colours, and vectors of five, in single precision.
Value kept(Value value);
/// A function or a spline with the arguments that follow, if any do; of another value, itself. `at`: of its name. (By value: directives in front
/// of the arguments, and in them, may declare the name anew.)
Value called(Parser& p, Value value, Place at);
/// The whole expression of which the first operand was read already: its dots and operators follow.
Value continue_from_value(Parser& p, Value first);
/// The same from a name that was taken.
Value continue_from_identifier(Parser& p, const Token& name);

double parse_float(Parser& p, Standing standing = Standing::in_brackets);
/// Three components; a float stands for all.
std::array<double, 5> parse_vector(Parser& p);
/// `value` where a vector of `terms` is read, `role` and `of` say for what ("as", "the centre of a sphere"): a shorter one is filled with zeros and a float
/// stands for all; a longer one and a colour, which has five, are refused.
std::array<double, 5> wanted_vector(Parser& p, const Value& value, uint8_t terms, Place at, std::string_view role = "", std::string_view of = "");
std::string parse_string(Parser& p);
/// `( condition )`
bool parse_condition(Parser& p);

/// Can `token` begin an expression?
bool begins_expression(const Parser& p, const Token& token);

/// The slot that a name and its subscripts mean, empty for an array element that was never assigned to; the name has been taken.
/// With `make`, that element is made (and the array is no longer shared). `holder`: the array that holds it.
Ref<Slot> parse_reference(Parser& p, const Token& name, bool make, Ref<Array>* holder = nullptr);

/// `color ...`, `rgb ...`, `red .3 green .2`
bool begins_colour(const Token& token);
Value parse_colour(Parser& p, Standing standing = Standing::in_brackets);
/// `red .3`, `filter .5` ... behind a colour replace its components.
Value parse_colour_components(Parser& p, Value colour, Standing standing = Standing::in_brackets);
/// A whole vector literal `<...>` behind its `<`. Where it has more than the five components of a vector, all its numbers are in `list`.
Value parse_vector(Parser& p, Place at, std::vector<double>& list);

}  // namespace alidade::pov
