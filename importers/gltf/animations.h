// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/nodes.h"

namespace alidade::gltf {

/// Appends the model's animations to `scene` as data, not baked (glTF 2.0 specification, section 3.11). A channel of morph weights is repeated
/// for every node in `shape_nodes` that carries a shape of its target.
void convert_animations(const Model& model, const ShapeNodes& shape_nodes, Scene& scene, Reporter& report);

}  // namespace alidade::gltf
