// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/accessors.h"

namespace alidade::gltf {

/// Appends a camera to `scene` for each of the model's, with the same index (glTF 2.0 specification, section 3.10): they look along -z, y up.
/// A perspective camera with an aspect ratio shows all of its window; one without takes the picture's. yfov is limited to 0.999 pi, with a warning.
void convert_cameras(const Model& model, Scene& scene, Reporter& report);

}  // namespace alidade::gltf
