// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/accessors.h"

namespace alidade::gltf {

/// Appends a material to `scene` for each of the model's, with the same index, and the signals that they need. `scene.images` must be there.
void convert_materials(const Model& model, Scene& scene, Reporter& report);

}  // namespace alidade::gltf
