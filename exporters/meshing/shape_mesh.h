// SPDX-License-Identifier: Apache-2.0
/// Closed-form shapes as meshes.
#pragma once

#include "exporters/meshing/triangle_list.h"

#include <optional>

namespace alidade::meshing {

/// The surface of a shape, its vertices on it and its normals the surface's; `segments` (at least 3) make a full circle, and an endless plane is cut to a square around
/// `region`. Nothing for shapes that have no such form: quadrics and polynomials (dual_contouring.h), and faces of too many points (fill.h).
///
/// Error    flat parts are exact; a circle of radius r is missed by at most r (1 - cos(pi / segments)).
std::optional<TriangleList> shape_mesh(const ShapeGeometry& shape, int segments, const Bounds& region);

}  // namespace alidade::meshing
