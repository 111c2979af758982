// SPDX-License-Identifier: Apache-2.0
/// Wavefront OBJ scenes with their MTL material libraries.
#pragma once

#include "importers/importer.h"

namespace alidade {

/// Reads polygons, corner normals and texture coordinates, vertex colours, smoothing groups, objects and materials (mesh/mtl_material.h says how
/// they are mapped). Each object (`o`) is a node with one mesh; its groups are merged; material slots are numbered in the order of their first use.
/// Points, lines, curves and surfaces are left out with a warning, and so are faces that cannot be drawn; an index that names nothing, a malformed
/// number or a face of fewer than three corners is an error, at its line and column.
ImportResult import_obj(const std::string& path, const ImportOptions& options);

/// Text whose first statement is one that OBJ files have.
bool looks_like_obj(std::span<const std::byte> head);

}  // namespace alidade
