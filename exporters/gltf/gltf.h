// SPDX-License-Identifier: Apache-2.0
/// glTF 2.0: .gltf with a .bin and pictures beside it, or .glb with all in one.
#pragma once

#include "exporters/exporter.h"

namespace alidade {

/// Nodes keep their order and names; one with several parents is written once for each path that leads to it, since glTF's nodes are trees, but its mesh
/// only once. Vertex data are written as floats, bit by bit, after what is not finite has been replaced; a mesh with an origin becomes a child node that
/// is moved there. Materials are written with the extensions that they need, lights as KHR_lights_punctual in candela and lux (683 lm/W).
/// Pictures are written as they are encoded: PNG, JPEG and (with EXT_texture_webp) WebP; others are lost, since glTF does not allow them.
tl::expected<void, std::string> write_gltf(const Scene& scene, OutputFiles& files, Losses& losses);

}  // namespace alidade
