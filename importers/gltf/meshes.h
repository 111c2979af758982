// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/accessors.h"

namespace alidade::gltf {

/// A shape made from a glTF mesh, and the material of each of its slots.
struct MeshPart {
    ShapeId shape;
    std::vector<std::optional<MaterialId>> materials;
};

/// Appends the shapes of the model's meshes to `scene`; returns the parts of each mesh. Primitives with the same attributes become slots of one
/// shape, so that no seam opens between materials; others become parts of their own. Meshes that read the same accessors share their shapes.
std::vector<std::vector<MeshPart>> convert_meshes(const Model& model, Scene& scene, Reporter& report);

}  // namespace alidade::gltf
