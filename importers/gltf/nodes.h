// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/meshes.h"

namespace alidade::gltf {

/// The nodes that carry the shapes of each glTF node: itself, or children made for them.
using ShapeNodes = std::vector<std::vector<NodeId>>;

/// Appends the model's nodes to `scene`, with the same indices, and the roots of its scene. A glTF node may hold a mesh, a camera and a
/// light at once; a node of ours holds one thing, so where there are more each gets a child node after all of the file's nodes. Each instance of
/// EXT_mesh_gpu_instancing is such a child, too; they share the nodes of the mesh.
ShapeNodes convert_nodes(const Model& model, const std::vector<std::vector<MeshPart>>& meshes, const std::vector<std::optional<LightId>>& lights,
                         Scene& scene, Reporter& report);

/// Appends the model's skins, with the same indices, and checks that the joints which vertices name are there. After convert_nodes().
void convert_skins(const Model& model, Scene& scene, Reporter& report);

}  // namespace alidade::gltf
