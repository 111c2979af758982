// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// `light_source { ... }` -> a node that stands at the light and points where it points (and what it looks like below it).
/// Source   POV-Ray 3.7 reference, 3.4.4 "Light Source".
NodeId build_light(Build& build, const Block& block);

}  // namespace alidade::pov
