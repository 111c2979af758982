// SPDX-License-Identifier: Apache-2.0
#include "eval/functions/float_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alidade {

namespace {

using Arguments = std::span<const double>;
constexpr size_t kAny = 10'000;

template <double (*function)(double)> double of_one(Arguments a) { return function(a[0]); }
double degrees(double x) { return x * (180.0 / std::numbers::pi); }
double radians(double x) { return x * (std::numbers::pi / 180.0); }

double select_sign(Arguments a) { return a[0] < 0 ? a[1] : a.size() < 4 || a[0] == 0 ? a[2] : a[3]; }

constexpr FloatFunction kFloatFunctions[] = {
    {"abs", 1, 1, of_one<std::fabs>},
    {"acos", 1, 1, of_one<std::acos>},
    {"acosh", 1, 1, of_one<std::acosh>},
    {"asin", 1, 1, of_one<std::asin>},
    {"asinh", 1, 1, of_one<std::asinh>},
    {"atan", 1, 1, of_one<std::atan>},
    {"atan2", 2, 2, [](Arguments a) { return std::atan2(a[0], a[1]); }},
    {"atanh", 1, 1, of_one<std::atanh>},
    {"ceil", 1, 1, of_one<std::ceil>},
    {"cos", 1, 1, of_one<std::cos>},
    {"cosh", 1, 1, of_one<std::cosh>},
    {"degrees", 1, 1, of_one<degrees>},
    {"div", 2, 2, [](Arguments a) { return std::trunc(a[0] / a[1]); }},
    {"exp", 1, 1, of_one<std::exp>},
    {"floor", 1, 1, of_one<std::floor>},
    {"int", 1, 1, of_one<std::trunc>},
    {"ln", 1, 1, of_one<std::log>},
    {"log", 1, 1, of_one<std::log10>},
    {"max", 2, kAny, [](Arguments a) { return *std::max_element(a.begin(), a.end()); }},
    {"min", 2, kAny, [](Arguments a) { return *std::min_element(a.begin(), a.end()); }},
    {"mod", 2, 2, [](Arguments a) { return std::fmod(a[0], a[1]); }},
    {"pow", 1, 2, [](Arguments a) { return a.size() == 1 ? a[0] : std::pow(a[0], a[1]); }},   // POV-Ray takes one
    {"radians", 1, 1, of_one<radians>},
    {"select", 3, 4, select_sign},
    {"sin", 1, 1, of_one<std::sin>},
    {"sinh", 1, 1, of_one<std::sinh>},
    {"sqrt", 1, 1, of_one<std::sqrt>},
    {"tan", 1, 1, of_one<std::tan>},
    {"tanh", 1, 1, of_one<std::tanh>},
};

}  // namespace

std::span<const FloatFunction> float_functions() { return kFloatFunctions; }

const FloatFunction* find_float_function(std::string_view name) {
    for (const FloatFunction& row : kFloatFunctions)
        if (name == row.name) return &row;
    return nullptr;
}

}  // namespace alidade
