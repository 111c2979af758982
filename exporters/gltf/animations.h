// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/nodes.h"

namespace alidade::gltf_export {

/// The scene's skins, with their indices.
void write_skins(const Scene& scene, const WrittenNodes& nodes, Document& document);

/// The scene's animations; channels without keys or without a node are lost.
void write_animations(const Scene& scene, const WrittenNodes& nodes, Document& document, Losses& losses);

}  // namespace alidade::gltf_export
