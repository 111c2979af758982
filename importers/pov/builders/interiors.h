// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// `interior { ... }`, added to the scene. As in POV-Ray it goes on with the one that the thing has `before`, unless it begins with a name.
InteriorId add_interior(Build& build, const Block& block, std::optional<InteriorId> before);

/// What a scene says is an index of refraction, as POV-Ray takes it: 0 is 1.
double checked_ior(Build& build, double ior, Place place);

}  // namespace alidade::pov
