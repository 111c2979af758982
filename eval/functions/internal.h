// SPDX-License-Identifier: Apache-2.0
/// The functions that POV-Ray has built in, `internal(N)`: its include file functions.inc gives them their names.
#pragma once

#include "core/vec.h"
#include "scene/material.h"

#include <span>
#include <string_view>

namespace alidade {

/// `more`: the arguments behind x, y, z. `noise`: what a function takes that asks for the scene's own generator.
struct InternalFunction {
    int number;
    const char* name;                ///< in functions.inc
    size_t parameters;               ///< behind x, y, z
    double (*value)(const Vec3& p, std::span<const double> more, NoiseGenerator noise);
};

/// What functions.inc calls `internal(number)`, known or not; "" if there is no such function.
std::string_view internal_function_name(double number);
/// Those that are known, one row each.
std::span<const InternalFunction> internal_functions();
/// The row of `internal(number)`, or null.
const InternalFunction* find_internal_function(double number);

}  // namespace alidade
