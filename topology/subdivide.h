// SPDX-License-Identifier: Apache-2.0
/// Finer meshes with smooth limits.
#pragma once

#include "scene/shape.h"

#include <tl/expected.hpp>

namespace alidade::topology {

inline constexpr int kMostLevels = 8;

/// `levels` times finer: by Catmull and Clark's rules if some face of the file had more than three corners, by Loop's if all are triangles. Vertices are
/// those of the refined net, not moved to the limit surface. Borders become cubic B-splines, at their corners too. Texture coordinates and colours
/// are interpolated linearly in each face, so that their seams stay where they were. Normals are left out: they want to be made anew; so are tangents.
/// A mesh that is not manifold, or is skinned or morphed, is refused with the reason, as a clause.
///
/// Source   C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987; Catmull and Clark, "Recursively generated B-spline surfaces on
///          arbitrary topological meshes", CAD 10(6), 1978; positions by OpenMesh.
tl::expected<Mesh, std::string> subdivide(const Mesh& mesh, int levels);

/// How many triangles that will have; levels are at most kMostLevels.
uint64_t subdivided_triangles(const Mesh& mesh, int levels);

}  // namespace alidade::topology
