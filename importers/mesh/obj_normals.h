// SPDX-License-Identifier: Apache-2.0
/// The normals that an OBJ file leaves to its reader.
#pragma once

#include "importers/mesh/obj_text.h"

#include <span>

namespace alidade::mesh {

/// Makes the normals of an object complete: `sections` are its own, one after the other. If it has normals or smoothing groups, every corner gets
/// one: the file's; or, in a smoothing group, the average over the polygons of this group around its vertex, weighted by their angles there; or
/// the polygon's own. An object without any stays without: it is flat.
/// Source   Thuermer and Wuethrich, "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 3(1), 1998 (the weights).
void complete_normals(ObjText& text, size_t first_section, size_t last_section);

/// The corners of a face.
inline std::span<const Corner> corners_of(const ObjText& text, const Face& face) { return {text.corners.data() + face.first, face.count}; }
inline std::span<Corner> corners_of(ObjText& text, const Face& face) { return {text.corners.data() + face.first, face.count}; }

}  // namespace alidade::mesh
