// SPDX-License-Identifier: Apache-2.0
/// PLY meshes (the Stanford format), text and binary.
#pragma once

#include "importers/mesh/mesh_file.h"

namespace alidade {

/// Reads `vertex` (x y z, nx ny nz, u v or s t or texture_u texture_v, red green blue alpha), `face` (vertex_indices or vertex_index, a list
/// `texcoord` of each corner's u v) and `tristrips`, in any order and of any type; the rest is skipped with a note. Integer colours are
/// sRGB-encoded, as Blender and MeshLab write them; float ones are linear. Alpha goes with the colours; the material is opaque.
/// Element counts that the file's bytes cannot hold, truncated data, and indices that name nothing are errors: in text at their line and column,
/// in binary data with their byte.
ImportResult import_ply(const std::string& path, const ImportOptions& options);

/// Bytes that begin with the line "ply".
bool looks_like_ply(std::span<const std::byte> head);

namespace mesh {

/// A MeshReader.
std::optional<ObjText> read_ply(std::span<const std::byte> bytes, uint32_t file, bool strict, Diagnostics& said);

}  // namespace mesh
}  // namespace alidade
