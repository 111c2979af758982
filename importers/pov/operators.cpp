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

std::array<double, 5> as_vector(const Value& value, uint8_t terms) { return value.rest > 0 ? value.c : promoted(value, terms); }

/// Makes `left` a value of as many components as the longer one has, and returns those of `right`.
[[gnu::always_inline]] static inline std::array<double, 5> promote_both(Value& left, const Value& right) {
    const uint8_t terms = std::max(left.terms, right.terms);
    if (terms > 1) {
        const bool colour = left.kind == Kind::colour || right.kind == Kind::colour;
        left.c = promoted(left, terms), left.terms = terms, left.rest = 0, left.kind = colour ? Kind::colour : Kind::vector;
    }
    return promoted(right, terms);
}

bool apply(char op, Value& left, const Value& right) {
    const std::array<double, 5> all = promote_both(left, right);
    bool by_zero = false;
    for (int i = 0; i < left.terms; ++i) {
        const bool zero = op == '/' && all[i] == 0;
        left.c[i] = zero ? std::numeric_limits<double>::infinity() : arithmetic(op, left.c[i], all[i]);
        by_zero |= zero;
    }
    return by_zero;
}

void negate(Value& value) {
    for (int i = 0; i < value.terms; ++i) value.c[i] = -value.c[i];
}

void compare(char op, Value& left, const Value& right) {
    const std::array<double, 5> all = promote_both(left, right);
    left.rest = 0;
    for (int i = 0; i < left.terms; ++i) left.c[i] = compared(op, left.c[i], all[i]);
}

double compared(char op, double a, double b) {
    const bool equal = std::fabs(a - b) <= kEpsilon;
    switch (op) {
        case '<': return a < b;
        case '>': return a > b;
        case kLessEqual: return a <= b || equal;
        case kGreaterEqual: return a >= b || equal;
        case kNotEqual: return !equal;
        case '&': return truth(a) && truth(b);
        case '|': return truth(a) || truth(b);
        default: return equal;
    }
}

double compared(char op, const std::string& a, const std::string& b) { return compared(op, double(a.compare(b) < 0 ? -1 : a.compare(b) > 0), 0.0); }

}  // namespace alidade::pov
