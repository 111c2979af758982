// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/document.h"
#include "exporters/losses.h"
#include "exporters/vertices.h"

namespace alidade::gltf_export {

/// The triangles `which` of a mesh as a primitive without a material. What glTF does not allow is mended: numbers that are not finite, normals
/// and tangents that are no unit vectors (one without a direction takes its triangles' normal), sets of coordinates or colours that are missing before others.
Json write_primitive(const Mesh& mesh, std::span<const uint32_t> which, bool add_origin, Document& document, Losses& losses);

}  // namespace alidade::gltf_export
