// SPDX-License-Identifier: Apache-2.0
/// What a declared function is worth at given arguments, while the scene is read.
#pragma once

#include "core/vec.h"
#include "importers/pov/parser.h"

#include <array>
#include <optional>
#include <span>

namespace alidade::pov {

/// Fails with a place, which is `at` for the call itself, for what is not modelled, and for the function of a pigment.
double function_value(Parser& p, const Function& function, std::span<const double> arguments, Place at);
/// Of the function of a pigment, its colour; nothing for others.
std::optional<std::array<double, 5>> function_colour(Parser& p, const Function& function, std::span<const double> arguments, Place at);

/// Of the function of a transformation, where it moves a point; nothing for others.
std::optional<Vec3> function_point(Parser& p, const Function& function, std::span<const double> arguments, Place at);

}  // namespace alidade::pov
