// SPDX-License-Identifier: Apache-2.0
/// Normals for meshes whose file gives none.
#pragma once

#include "scene/shape.h"

namespace alidade::topology {

/// Gives `mesh` new normals: a corner's is the average over the triangles around its vertex that can be reached over edges whose two triangles meet at
/// no more than `crease_degrees` (0: coplanar; 180: all that is wound consistently), weighted by their angles there. Edges inside a polygon of the
/// file are never creases; edges with one triangle, more than two, or two wound against each other always are. A triangle without area takes part in no
/// average and keeps its neighbours' normal, if it has any.
///
/// Source   what is smooth: OpenMesh's calc_halfedge_normal; the weights: Thuermer and Wuethrich, "Computing Vertex Normals from Polygonal Facets",
///          Journal of Graphics Tools 3(1), 1998.
/// Error    the angle is compared with a slack of 1e-6 radian, the rounding of float vertices: the exact 90 of a cube is smooth at 90.
void set_crease_normals(Mesh& mesh, double crease_degrees);

}  // namespace alidade::topology
