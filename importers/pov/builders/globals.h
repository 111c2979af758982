// SPDX-License-Identifier: Apache-2.0
/// global_settings: what holds for the whole scene.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// What POV-Ray takes where the scene says nothing, which depends on its version.
void begin_settings(Build& build);
void read_globals(Build& build, const Block& block);

}  // namespace alidade::pov
