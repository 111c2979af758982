// SPDX-License-Identifier: Apache-2.0
/// Objects with their modifiers -> nodes.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// The node of an object's block; nothing, and a tally, if it is not modelled. A texture that the object does not give is inherited. `placed` moves what a block
/// like `object { }` wraps, ahead of its modifiers.
std::optional<BuiltObject> build_object(Build& build, const Block& block, const Transform& placed = {});

}  // namespace alidade::pov
