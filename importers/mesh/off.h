// SPDX-License-Identifier: Apache-2.0
/// OFF meshes (Geomview's object file format), text.
#pragma once

#include "importers/mesh/mesh_file.h"

namespace alidade {

/// Reads vertices with what the first word says of them (ST: texture coordinates, C: colours, N: normals, 4: homogeneous coordinates) and faces;
/// colours of faces are left out with a warning. Vertex colours over 1 are sRGB-encoded, from 0 to 255, else linear, from 0 to 1. nOFF and
/// binary files are refused, and so are counts that the file's bytes cannot hold and indices that name nothing.
/// Source   Geomview manual, version 1.9, section 4.2.5 "OFF Files".
ImportResult import_off(const std::string& path, const ImportOptions& options);

/// Text whose first word is one of OFF, such as COFF, and is followed by a number.
bool looks_like_off(std::span<const std::byte> head);

namespace mesh {

/// A MeshReader.
std::optional<ObjText> read_off(std::span<const std::byte> bytes, uint32_t file, bool strict, Diagnostics& said);

}  // namespace mesh
}  // namespace alidade
