// SPDX-License-Identifier: Apache-2.0
/// A program's blocks -> a scene.
#pragma once

#include "importers/pov/reader.h"
#include "scene/scene.h"

namespace alidade::pov {

class Parser;

/// Builds every top-level block. An error ends the block that it is in; what is not modelled is tallied by the parser that has read the program.
Scene build_scene(Parser& parser, const Program& program);

}  // namespace alidade::pov
