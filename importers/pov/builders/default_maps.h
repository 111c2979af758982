// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// What a pigment's pattern has where the scene gives no map, or a list that is too short. Source   POV-Ray 3.7 reference, 3.4.7.1 and 3.4.7.2; verified by probing.
void add_default_map(Build& build, PatternSignal& s);

}  // namespace alidade::pov
