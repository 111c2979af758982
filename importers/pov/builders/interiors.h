// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// `interior { ... }`, added to the scene.
InteriorId add_interior(Build& build, const Block& block);

}  // namespace alidade::pov
