// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/accessors.h"

namespace alidade::gltf {

/// One primitive of a mesh as triangles. Nothing, and a warning, if it has no surface (points, lines, no positions); nothing, and an error,
/// if it is invalid: attributes of the wrong type or of different lengths, indices out of range.
/// Vertices are the file's, unless most of them are not used (many primitives over one large vertex array): then only those that are.
std::optional<Mesh> read_primitive(const Model& model, const tinygltf::Primitive& primitive, const std::string& at, ReadBudget& budget,
                                   Reporter& report);

/// The triangles of a vertex list by its mode (glTF 2.0 specification, section 3.7.2.1): 4 triangles, 5 strip, 6 fan.
std::vector<Index3> assemble_triangles(const std::vector<uint32_t>& vertices, int mode);

}  // namespace alidade::gltf
