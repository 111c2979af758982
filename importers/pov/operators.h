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

/// `a op b` for + - * /; both are numeric. `divided_by_zero` is set, never cleared.
Value arithmetic(char op, const Value& a, const Value& b, bool& divided_by_zero);
/// -value
Value negated(Value value);
/// `a op b` for < > = and the two-character marks: 1 or 0.
double compared(char op, double a, double b);
double compared(char op, const std::string& a, const std::string& b);

}  // namespace alidade::pov
