// SPDX-License-Identifier: Apache-2.0
/// Meshes compressed by Draco: KHR_draco_mesh_compression.
#pragma once

#include "importers/gltf/buffers.h"

namespace alidade::gltf {

/// Decodes every compressed primitive of the checked `root` into buffers of its own, appended to `buffers`, and points its accessors at them. To be
/// called after check_ranges(). The decoded counts must be those of the accessors; and no mesh is decoded that claims more than 64 triangles for
/// each of its bytes, beyond a million in the whole file.
void decompress_primitives(Json& root, std::vector<Bytes>& buffers, Reporter& report);

}  // namespace alidade::gltf
