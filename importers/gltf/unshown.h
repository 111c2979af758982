// SPDX-License-Identifier: Apache-2.0
/// Meshes that the scene does not show, left out before their bytes are read.
#pragma once

#include "importers/gltf/json.h"

#include <vector>

namespace alidade::gltf {

/// Takes the meshes of nodes that the file's scene does not show (and those of no node) out of the checked `root`, in place, so that numbers stay: such a mesh
/// has no primitives, and accessors that nothing else asks for have one element and no data. Returns which buffers need not be read: those that only such
/// accessors lead to. Without scenes everything is shown.
std::vector<bool> leave_out_unshown(Json& root);

}  // namespace alidade::gltf
