// SPDX-License-Identifier: Apache-2.0
/// Functions that give a float (POV-Ray reference, 3.3.1.5.4). Domains and roundings as probed.
#include "importers/pov/arrays.h"
#include "importers/pov/builtins/builtins.h"
#include "importers/pov/expressions.h"
#include "importers/pov/integers.h"
#include "importers/pov/operators.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace alidade::pov {

namespace {

template <double (*function)(double)>
Value of_one(Parser& p, Place) { return Value::number(function(one_float(p))); }

template <double (*function)(double, double)>
Value of_two(Parser& p, Place) {
    p.expect('(', "before the arguments of a function");
    const double a = parse_float(p), b = next_float(p);
    close(p);
    return Value::number(function(a, b));
}

double truncated(double x) { return to_int(x); }
double quotient(double a, double b) { return to_int(a / b); }
double degrees(double x) { return x / (std::numbers::pi / 180.0); }
double radians(double x) { return x * (std::numbers::pi / 180.0); }

/// acos and asin clamp their argument, with a warning.
template <double (*function)(double)>
Value of_sine(Parser& p, Place at) {
    const double x = one_float(p);
    if (x < -1 || x > 1) p.warn(at, fmt::format("the argument {} is not in -1 to 1", x));
    return Value::number(function(std::clamp(x, -1.0, 1.0)));
}

/// Real for positive arguments alone.
template <double (*function)(double)>
Value of_positive(Parser& p, Place at) {
    const double x = one_float(p);
    if (x <= 0) p.fail(at, fmt::format("the logarithm of {} is not real", x));
    return Value::number(function(x));
}

Value root(Parser& p, Place at) {
    const double x = one_float(p);
    if (x < 0) p.fail(at, fmt::format("the square root of {} is not real", x));
    return Value::number(std::sqrt(x));
}

Value power(Parser& p, Place at) {
    p.expect('(', "before the arguments of a function");
    const double a = parse_float(p), b = next_float(p);
    close(p);
    if (a == 0 && b == 0) p.fail(at, "0 to the power 0 has no value");
    return Value::number(std::pow(a, b));
}

Value angle(Parser& p, Place at) {
    p.expect('(', "before the arguments of a function");
    const double y = parse_float(p), x = next_float(p);
    close(p);
    if (x == 0 && y == 0) p.fail(at, "atan2(0, 0) has no value");
    return Value::number(std::atan2(y, x));
}

/// Any number of arguments, folded from the left.
template <double (*combine)(double, double)>
Value of_many(Parser& p, Place) {
    p.expect('(', "before the arguments of a function");
    double all = parse_float(p);
    while (p.accept(',')) all = combine(all, parse_float(p));
    close(p);
    return Value::number(all);
}

double least(double a, double b) { return b < a ? b : a; }
double greatest(double a, double b) { return b > a ? b : a; }
double bits_and(double a, double b) { return to_int(a) & to_int(b); }
double bits_or(double a, double b) { return to_int(a) | to_int(b); }
double bits_xor(double a, double b) { return to_int(a) ^ to_int(b); }

/// select(a, negative, not negative) or select(a, negative, zero, positive), exact at 0.
Value select_sign(Parser& p, Place) {
    p.expect('(', "before the arguments of a function");
    const double a = parse_float(p), negative = next_float(p), second = next_float(p);
    const double positive = p.accept(',') ? parse_float(p) : second;
    close(p);
    return Value::number(a < 0 ? negative : a > 0 ? positive : second);
}

Value seed(Parser& p, Place) { return Value::number(double(p.random.seed(one_float(p)))); }

Value rand(Parser& p, Place at) {
    const double stream = one_float(p);
    const std::optional<double> x = p.random.next(stream);
    if (!x) p.fail(at, fmt::format("there is no stream {} of random numbers", stream), "make one with seed(), and give what it returns");
    return Value::number(*x);
}

/// defined(NAME) or defined(ARRAY[i])
Value is_defined(Parser& p, Place) {
    p.expect('(', "behind defined");
    const Token name = p.raw_token();
    bool known = false;                           // as words of the language are (probed)
    if (name.kind == TokenKind::name) known = p.symbols.find(name.id) && bool(parse_reference(p, name, false));
    p.expect(')', "behind the name");
    return Value::number(known);
}

const Array& array_argument(Parser& p) {
    const Token name = p.next();
    Slot* slot = name.kind == TokenKind::name ? p.symbols.find(name.id) : nullptr;
    Ref<Slot> array = slot ? parse_reference(p, name, false) : Ref<Slot>();
    if (slot && slot->value.kind == Kind::array && (!array || array->value.kind != Kind::array)) array = Ref<Slot>(slot);
    if (!array || array->value.kind != Kind::array) p.fail(name.place(), fmt::format("the name of an array is expected, not {}", p.describe(name)));
    return array->value.as<Array>();
}

Value dimensions(Parser& p, Place) {
    p.expect('(', "behind dimensions");
    const double n = double(array_argument(p).sizes.size());
    p.expect(')', "behind the array");
    return Value::number(n);
}

Value dimension_size(Parser& p, Place) {
    p.expect('(', "behind dimension_size");
    const Array& array = array_argument(p);
    p.accept(',');
    const double which = parse_float(p);
    p.expect(')', "behind the dimension");
    if (!(which >= 1 && which < double(array.sizes.size()) + 1)) return Value::number(0);   // as POV-Ray has it
    return Value::number(array.sizes[size_t(which) - 1]);
}

constexpr BuiltinEntry kFloatFunctions[] = {
    {"abs"_w, of_one<std::fabs>}, {"acosh"_w, of_one<std::acosh>}, {"asinh"_w, of_one<std::asinh>}, {"atanh"_w, of_one<std::atanh>},
    {"atan"_w, of_one<std::atan>}, {"ceil"_w, of_one<std::ceil>}, {"cos"_w, of_one<std::cos>}, {"cosh"_w, of_one<std::cosh>},
    {"exp"_w, of_one<std::exp>}, {"floor"_w, of_one<std::floor>}, {"int"_w, of_one<truncated>}, {"sin"_w, of_one<std::sin>},
    {"sinh"_w, of_one<std::sinh>}, {"tan"_w, of_one<std::tan>}, {"tanh"_w, of_one<std::tanh>}, {"degrees"_w, of_one<degrees>},
    {"radians"_w, of_one<radians>}, {"acos"_w, of_sine<std::acos>}, {"asin"_w, of_sine<std::asin>}, {"ln"_w, of_positive<std::log>},
    {"log"_w, of_positive<std::log10>}, {"sqrt"_w, root}, {"pow"_w, power}, {"atan2"_w, angle}, {"mod"_w, of_two<std::fmod>},
    {"div"_w, of_two<quotient>}, {"min"_w, of_many<least>}, {"max"_w, of_many<greatest>}, {"bitwise_and"_w, of_many<bits_and>},
    {"bitwise_or"_w, of_many<bits_or>}, {"bitwise_xor"_w, of_many<bits_xor>}, {"select"_w, select_sign}, {"seed"_w, seed}, {"rand"_w, rand},
    {"defined"_w, is_defined}, {"dimensions"_w, dimensions}, {"dimension_size"_w, dimension_size},
};

}  // namespace

std::span<const BuiltinEntry> float_functions() { return kFloatFunctions; }

}  // namespace alidade::pov
