// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// The camera of a block. What it does not say is as in POV-Ray: at the origin, along z, 1.33 wide and 1 high at distance 1.
/// Source   POV-Ray 3.7 reference, 3.4.2 "Camera"; the order in which its parts act was found by probing.
Camera build_camera(Build& build, const Block& block);

}  // namespace alidade::pov
