// SPDX-License-Identifier: Apache-2.0
/// Surfaces whose topology is known on paper.
#pragma once

#include "importers/importer.h"
#include "scene/queries.h"
#include "scene/shape.h"

#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace alidade {

inline Mesh mesh_from(std::vector<Vec3> points, std::vector<Index3> triangles) {
    Mesh mesh;
    for (const Vec3& p : points) mesh.positions.emplace_back(p);
    mesh.triangles = std::move(triangles);
    return mesh;
}

/// The cube from 0 to 1, with 12 triangles wound outwards, moved by `by`.
Mesh cube(const Vec3& by = Vec3(0));

/// The octahedron with corners at distance 1.
Mesh octahedron();

/// The points at(u, v) of a grid of columns x rows cells of two triangles, u and v in [0, 1]. The grid has (columns + 1) x (rows + 1) vertices, of which
/// some may be at the same place: that is for welding to find. With texture coordinates (u, v) if asked for.
Mesh grid(int columns, int rows, const std::function<Vec3(double, double)>& at, bool with_uv = false);

/// A torus around z, radii 2 and 1; its seams meet exactly.
Mesh torus(int around, int across);

/// A sphere of radius 1 with poles on z, which repeat a vertex in each triangle of their outermost rows: `rows` of them are left out at the north.
Mesh sphere(int around, int rows, int left_out = 0);

/// A band with half a twist.
Mesh moebius(int around);

/// All triangles of both.
Mesh together(const Mesh& a, const Mesh& b);

/// The same triangles, none of them with a vertex in common with another: as STL files have them.
Mesh soup(const Mesh& mesh);

/// Random triangles over few vertices: every defect there is.
Mesh mess(uint32_t seed, int vertices, int triangles);

inline Vec3 corner_point(const Mesh& mesh, size_t triangle, int corner) { return Vec3(mesh.positions[mesh.triangles[triangle][corner]]); }

/// Calls body(path and shape's name, mesh) for each mesh of the assets, and of the shared data if it is here; returns how many. Files above `most_bytes` are left out.
size_t for_each_mesh_file(size_t most_bytes, const std::function<void(const std::string&, const Mesh&)>& body);

}  // namespace alidade
