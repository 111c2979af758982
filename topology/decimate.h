// SPDX-License-Identifier: Apache-2.0
/// Coarser meshes of the same shape.
#pragma once

#include "scene/shape.h"

#include <tl/expected.hpp>

namespace alidade::topology {

/// `mesh` with about `ratio` of its triangles (0 < ratio <= 1), by collapsing the edges that cost least by quadric error. The vertices that are left stay
/// where they are. Texture coordinates, colours and material slots keep their seams: an edge is collapsed only if every triangle that it moves finds
/// its own side of the seam at the vertex that is left. Borders and seams count as walls, no triangle turns around, and nothing moves by more than about
/// a twentieth of the mesh's size. So the ratio may be out of reach: count the triangles. Polygons of the file are forgotten; normals and tangents are left out, and want to be made anew.
/// A mesh that is not manifold, or is skinned or morphed, is refused with the reason, as a clause.
///
/// Source   Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH 1997; corners as Hoppe, "Progressive Meshes", SIGGRAPH
///          1996, sees them (wedges); the queue of collapses by OpenMesh.
/// Cost     half a minute a million triangles.
tl::expected<Mesh, std::string> decimate(const Mesh& mesh, double ratio);

}  // namespace alidade::topology
