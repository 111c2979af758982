// SPDX-License-Identifier: Apache-2.0
/// What the importers of PLY, STL and OFF share: such a file holds one mesh, and no materials.
#pragma once

#include "importers/importer.h"
#include "importers/mesh/obj_text.h"

namespace alidade::mesh {

/// A reader of one format: all of a file's bytes -> its polygons, or nothing and errors in `said`. `strict`: what is left out is an error.
using MeshReader = std::optional<ObjText> (*)(std::span<const std::byte> bytes, uint32_t file, bool strict, Diagnostics& said);

/// The scene of a file: one node with one mesh and a gray material, or a white one if the vertices have colours. A file without polygons makes
/// an empty scene, with a warning.
ImportResult import_mesh_file(const std::string& path, const ImportOptions& options, MeshReader read);

/// The same of bytes; `path` is for messages and names.
ImportResult import_mesh_bytes(std::span<const std::byte> bytes, const std::string& path, const ImportOptions& options, MeshReader read);

/// Begins the only object of a file: faces that are added from now on belong to it.
void begin_only_object(ObjText& out, uint32_t file);

/// Adds a polygon of out.corners, from `first` to their end; false if the file has more corners than an index can count.
bool add_face(ObjText& out, size_t first, uint32_t line);

}  // namespace alidade::mesh
