// SPDX-License-Identifier: Apache-2.0
/// The parameters that stand at the beginning of an object's block -> its geometry.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// A geometry, and the textures of its material slots behind the first (a mesh's own).
struct BuiltShape {
    ShapeGeometry geometry;
    std::vector<std::optional<MaterialId>> slots;
};

/// Reads the parameters of the solid `word` from `at`, which is left at the first modifier; nothing if the word names no shape that is modelled.
std::optional<BuiltShape> build_shape(Build& build, WordId word, Cursor& at);

/// Polynomials of order 2, 3, 4, and any.
BuiltShape build_quadric(Build& build, Cursor& at);
BuiltShape build_cubic(Build& build, Cursor& at);
BuiltShape build_quartic(Build& build, Cursor& at);
BuiltShape build_poly(Build& build, Cursor& at);
/// `polynomial { order, xyz(1, 0, 2): 3, ... }`: of a power that comes twice the last counts.
BuiltShape build_polynomial(Build& build, Cursor& at);
/// `polygon { number of points, points }`: a loop ends where its first point comes again.
BuiltShape build_polygon(Build& build, Cursor& at);

/// `mesh { triangle { } smooth_triangle { } ... }` and `mesh2 { vertex_vectors { } face_indices { } ... }`.
BuiltShape build_mesh(Build& build, Cursor& at);
BuiltShape build_mesh2(Build& build, Cursor& at);
/// `uv_mapping` of a mesh that was moved by `before`: that has moved the textures of its triangles, too, what is done later does not.
void map_triangles(Build& build, const Node& mesh, const Transform& before);
BuiltShape build_triangle(Build& build, Cursor& at);
BuiltShape build_smooth_triangle(Build& build, Cursor& at);

}  // namespace alidade::pov
