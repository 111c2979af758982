// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/shape.h"

namespace alidade {

/// The tangents that normal maps without tangents of their own are baked for, one for each corner of each triangle: along growing u, unit length,
/// perpendicular to the corner's normal; w is +1 where cross(normal, tangent) points to falling v (v grows downwards), else -1.
/// A corner's tangent is the average of the directions of u on the triangles around it, each in the plane of the normal and weighted by the angle at
/// the corner. Triangles share it that meet in edges with equal positions, normals and texture coordinates at both ends and are not mirrored against
/// each other in the texture. A mesh without normals is flat. Where u has no direction, any tangent is given. `uv_set` must be present.
/// Source   M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", thesis, University of Copenhagen 2008, sections 2.4 and 3; written from the
///          text. glTF 2.0, section 3.7.2.1, names this method as the default.
Attribute<Vec4f> make_tangents(const Mesh& mesh, uint32_t uv_set);

}  // namespace alidade
