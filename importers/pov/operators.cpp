// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/operators.h"

#include <cmath>
#include <limits>

namespace alidade::pov {

bool truth(double x) { return std::fabs(x) > kEpsilon; }

std::array<double, 5> promoted(const Value& value, uint8_t terms) {
    if (value.terms != 1) return value.c;      // what is missing is zero already
    std::array<double, 5> all{};
    std::fill_n(all.begin(), terms, value.c[0]);
    return all;
}

namespace {

double apply(char op, double a, double b, bool& divided_by_zero) {
    switch (op) {
        case '+': return a + b;
        case '-': return a - b;
        case '*': return a * b;
        default:
            if (b != 0) return a / b;
            divided_by_zero = true;
            return std::numeric_limits<double>::infinity();
    }
}

}  // namespace

Value arithmetic(char op, const Value& a, const Value& b, bool& divided_by_zero) {
    if (a.terms == 1 && b.terms == 1) return Value::number(apply(op, a.c[0], b.c[0], divided_by_zero));
    Value out;
    out.terms = std::max(a.terms, b.terms);
    out.kind = a.kind == Kind::colour || b.kind == Kind::colour ? Kind::colour : Kind::vector;
    const std::array<double, 5> p = promoted(a, out.terms), q = promoted(b, out.terms);
    for (int i = 0; i < out.terms; ++i) out.c[i] = apply(op, p[i], q[i], divided_by_zero);
    return out;
}

Value negated(Value value) {
    for (int i = 0; i < value.terms; ++i) value.c[i] = -value.c[i];
    return value;
}

double compared(char op, double a, double b) {
    const bool equal = std::fabs(a - b) <= kEpsilon;
    switch (op) {
        case '<': return a < b;
        case '>': return a > b;
        case kLessEqual: return a <= b || equal;
        case kGreaterEqual: return a >= b || equal;
        case kNotEqual: return !equal;
        default: return equal;
    }
}

double compared(char op, const std::string& a, const std::string& b) { return compared(op, double(a.compare(b) < 0 ? -1 : a.compare(b) > 0), 0.0); }

}  // namespace alidade::pov
