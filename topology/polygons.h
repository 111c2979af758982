// SPDX-License-Identifier: Apache-2.0
/// A mesh as polygons with attributes at their corners: what subdivision works on.
#pragma once

#include "topology/weld.h"

namespace alidade::topology {

/// An attribute of corners. uvs use x and y.
struct Channel {
    std::vector<Vec4f> values;
    std::vector<uint32_t> corners;   ///< one a corner of the polygons
};

struct Polygons {
    std::vector<Vec3> points;
    std::vector<uint32_t> corners;     ///< into points, polygon by polygon
    std::vector<uint32_t> first{0};    ///< the first corner of each polygon, and one past the last corner
    std::vector<uint32_t> slots;       ///< empty, or one a polygon
    std::vector<Channel> channels;     ///< the mesh's texture coordinates, then its colours

    size_t count() const { return first.size() - 1; }
    bool all_triangles() const { return corners.size() == 3 * count(); }
};

/// The polygons that the file had, as far as Mesh::faces tells: the outline of the triangles of one face. Triangles whose outline is not one loop
/// (a polygon with a hole) stand for themselves; unsound ones are left out.
Polygons polygons_of(const Mesh& mesh, const Welded& surface);

/// A mesh of the polygons, each cut into a fan from its first corner. From `like` come the origin, and whether double precision is kept. Without normals
/// and tangents. Mesh::faces tells the polygons, unless all are triangles.
Mesh mesh_of(const Polygons& polygons, const Mesh& like);

}  // namespace alidade::topology
