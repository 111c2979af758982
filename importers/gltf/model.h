// SPDX-License-Identifier: Apache-2.0
/// tinygltf, included the one way this project uses it: header-only, without its own image and file code.
#pragma once

#include "importers/gltf/buffers.h"

#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#define TINYGLTF_USE_CPP14
#include <tiny_gltf.h>

namespace alidade::gltf {

/// The checked `root` as tinygltf's model. It is given `root` as JSON text again, `buffers` (which move into the model) and no images, so that it
/// sees only what has passed our checks; nothing and an error if it refuses even that.
std::optional<tinygltf::Model> to_model(Json root, std::vector<Bytes> buffers, Reporter& report);

}  // namespace alidade::gltf
