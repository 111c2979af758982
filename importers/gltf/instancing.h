// SPDX-License-Identifier: Apache-2.0
/// Many copies of a node's mesh: EXT_mesh_gpu_instancing.
#pragma once

#include "importers/gltf/accessors.h"

namespace alidade::gltf {

/// Checks the instances of all nodes of the checked `root`: formats, equal counts, and that the file has a number of bytes for each of them. To be
/// called before materialise_zeros(), which would count as bytes what the file does not hold.
void check_instances(const Json& root, const std::vector<Bytes>& buffers, Reporter& report);

/// Where the instances of `node`, which stands at `at`, put its mesh, in the node's space; nothing if it has none.
std::optional<std::vector<Transform>> read_instances(const Model& model, const tinygltf::Node& node, const std::string& at, Reporter& report);

}  // namespace alidade::gltf
