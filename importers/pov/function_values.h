// SPDX-License-Identifier: Apache-2.0
/// What a declared function is worth at given arguments, while the scene is read.
#pragma once

#include "importers/pov/parser.h"

#include <span>

namespace alidade::pov {

/// Fails with a place for what is not modelled (patterns, pigments, internal()).
double function_value(const Parser& p, const Function& function, std::span<const double> arguments, Place at);

}  // namespace alidade::pov
