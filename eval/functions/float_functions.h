// SPDX-License-Identifier: Apache-2.0
/// The functions of numbers that POV-Ray's language has, as formulas call them.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace alidade {

struct FloatFunction {
    const char* name;
    size_t fewest, most;     ///< arguments
    double (*value)(std::span<const double> arguments);
};

/// One row for each.
std::span<const FloatFunction> float_functions();
/// Null if there is none of the name.
const FloatFunction* find_float_function(std::string_view name);

}  // namespace alidade
