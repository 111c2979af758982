// SPDX-License-Identifier: Apache-2.0
/// STL meshes, text and binary.
#pragma once

#include "importers/mesh/mesh_file.h"

namespace alidade {

/// Reads all triangles of all solids; equal vertices become one. The normals of facets are not read: the mesh is flat, as they say, and many files
/// have wrong ones. Colours in attribute bytes are not read. A file that holds fewer triangles than it promises is an error.
/// Source   3D Systems, "StereoLithography Interface Specification", 1988.
ImportResult import_stl(const std::string& path, const ImportOptions& options);

/// Text that begins with a solid and its first facet, or a binary file that is whole in `head`. Binary STL has no mark of its own: longer files
/// are recognised by their names' ending only.
bool looks_like_stl(std::span<const std::byte> head);

namespace mesh {

/// A MeshReader. A file is binary if its size is what the count in it says, whatever its header says ("solid" too); otherwise, text if it begins
/// with "solid" and has no NUL.
std::optional<ObjText> read_stl(std::span<const std::byte> bytes, uint32_t file, bool strict, Diagnostics& said);

}  // namespace mesh
}  // namespace alidade
