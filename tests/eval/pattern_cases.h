// SPDX-License-Identifier: Apache-2.0
/// Patterns in POV-Ray's words, and as the scene graph has them.
#pragma once

#include "scene/material.h"

#include <string>
#include <vector>

namespace alidade {

struct PatternCase {
    std::string declaration;   ///< what stands in `pattern { }`, or in `pigment { }` where the pattern may stand only there
    PatternSignal signal;
    int colours = 0;           ///< of a list: then POV-Ray is asked for the place in the list
};

/// At least one case for each row of the registry, each warp and each wave.
std::vector<PatternCase> pattern_cases();

}  // namespace alidade
