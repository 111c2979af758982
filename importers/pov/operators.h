// SPDX-License-Identifier: Apache-2.0
/// Arithmetic of values, with POV-Ray's promotion: a float stands for all components, a shorter vector is padded with zeros.
#pragma once

#include "importers/pov/value.h"

namespace alidade::pov {

/// Two numbers nearer than this are equal, and one nearer to 0 is false (manual, 3.3.1.5; probed).
inline constexpr double kEpsilon = 1e-10;
/// What POV-Ray gives for a division by zero, whatever the sign.
bool truth(double x);

/// `value` with `terms` components.
std::array<double, 5> promoted(const Value& value, uint8_t terms);

/// The same where POV-Ray reads a vector, but not a colour: of `V.y` it is <V.y, V.y, V.z> (probed), V being a vector of three.
std::array<double, 5> as_vector(const Value& value, uint8_t terms);

/// `a op b` for + - * /; b is not 0 where it divides.
inline double arithmetic(char op, double a, double b) { return op == '+' ? a + b : op == '-' ? a - b : op == '*' ? a * b : a / b; }
/// The same with b in all components of `left` or in each its own; both are numeric. True if a 0 has divided.
bool apply(char op, Value& left, const Value& right);
void negate(Value& value);
/// The same for < > = & | and the two-character marks: each component becomes 1 or 0.
void compare(char op, Value& left, const Value& right);
/// `a op b`: 1 or 0.
double compared(char op, double a, double b);
double compared(char op, const std::string& a, const std::string& b);

}  // namespace alidade::pov
