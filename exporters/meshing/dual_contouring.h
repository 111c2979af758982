// SPDX-License-Identifier: Apache-2.0
/// Any surface that lines can be asked to meet, as a mesh.
#pragma once

#include "exporters/meshing/triangle_list.h"

#include <functional>

namespace alidade::meshing {

/// Where a line meets the surface.
struct LineCrossing {
    double t = 0;               ///< from 0 at the line's origin to 1 at its end
    Vec3 normal{0, 0, 1};       ///< unit, outwards
    uint32_t slot = 0;          ///< of the material
};

/// All crossings of the line from `origin` to `origin + span`, in order.
using CrossingsOfLine = std::function<std::vector<LineCrossing>(const Vec3& origin, const Vec3& span)>;

/// The surface in `box`, found on a lattice of `cells` cells along the longest side. What is thinner than a cell may be missed; edges and corners are kept.
///
/// Method   dual contouring: each edge of the lattice that the surface crosses becomes a face between the vertices of its four cells, each where it fits best to the
///          planes that touch the surface at the crossings of its cell. T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual contouring of Hermite data", SIGGRAPH 2002.
/// Error    falls with the square of the size of a cell on smooth surfaces; a cell at the rims of open ones.
TriangleList dual_contour(const Bounds& box, int cells, const CrossingsOfLine& crossings);

}  // namespace alidade::meshing
