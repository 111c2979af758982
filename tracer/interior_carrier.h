// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace alidade {

/// The length of the part of the path up to the node that carries the interior: the nearest that has one, else the outermost operation, whose parts are
/// one body; 0 if there is neither.
size_t interior_carrier(const Scene& scene, const std::vector<NodeId>& path);

/// Is the body hollow that a node on the path carries? As POV-Ray has it, if a node down to it says so, or else the last of its parts that has no interior of its own.
bool is_hollow(const Scene& scene, const std::vector<NodeId>& path, size_t carrier);

}  // namespace alidade
