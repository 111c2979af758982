// SPDX-License-Identifier: Apache-2.0
/// A mesh as a surface: vertices at the same point are one vertex, whatever normals and texture coordinates the file gives them. Without this
/// every seam of a texture would be a hole.
#pragma once

#include "scene/shape.h"

#include <array>
#include <span>

namespace alidade::topology {

inline constexpr uint32_t kNone = ~uint32_t(0);

struct Welded {
    std::vector<Vec3> points;                ///< relative to Mesh::origin, numbered in the order of the first triangle that uses them
    std::vector<Index3> triangles;           ///< into points, one for each of the mesh, in its order
    std::vector<uint8_t> sound;              ///< for each triangle: it has three different vertices, all finite
    std::vector<uint32_t> position_of;       ///< for each point: a position of the mesh that stands there

    size_t sound_count() const;
};

/// Joins positions whose coordinates are equal as numbers (exact ones, where the mesh has them); 0 and -0 are equal. Points that only unsound
/// triangles use come last. Time n log n.
Welded weld(const Mesh& mesh);

/// Number `i` of the mesh's positions, with all digits that it has.
inline Vec3 position(const Mesh& mesh, uint32_t i) { return mesh.exact_positions.empty() ? Vec3(mesh.positions[i]) : mesh.exact_positions[i]; }

/// The corner after `corner` in its triangle, and the one before; corners are counted 3 * triangle + 0, 1, 2.
inline uint32_t next_corner(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
inline uint32_t previous_corner(uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

}  // namespace alidade::topology
