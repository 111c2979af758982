// SPDX-License-Identifier: Apache-2.0
/// Triangle meshes made from numbers, for tests and benchmarks of accelerators.
#pragma once

#include "accel/accelerator.h"

#include <string>
#include <vector>

namespace alidade::numerics {

/// Triangles over shared vertices, kept twice: `vertices` in double and `positions`, the same rounded to float.
struct TriangleMesh {
    std::string name;
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    Bounds inside;  ///< a box of points that the surface encloses; empty where it encloses none
    std::vector<Vec3f> positions;

    TriangleMesh(std::string mesh_name, std::vector<Vec3> mesh_vertices, std::vector<Index3> mesh_triangles, const Bounds& enclosed = {});

    TriangleView view() const { return {positions, vertices, triangles}; }
    Bounds bounds() const;
    const Vec3& corner(size_t triangle, int k) const { return vertices[triangles[triangle][k]]; }
    /// The mesh that an accelerator of that precision sees: in float, the vertices are rounded. Rays must be aimed at this one.
    TriangleMesh read_at(Precision precision) const;
};

/// The icosahedron, each of its faces cut into frequency^2, on the unit sphere: 20 frequency^2 triangles, closed. The radius is 1 + bump sin sin sin.
TriangleMesh geodesic_sphere(int frequency, double bump = 0);
/// The surface of [-1, 1]^3, each side n x n squares: 12 n^2 triangles, closed.
TriangleMesh cube(int n);
/// Radii 1 and 1/4: 2 around * across triangles, closed, not convex.
TriangleMesh torus(int around, int across);
/// Regular tetrahedra of any orientation in [-1, 1]^3, overlapping: 4 count triangles, closed.
TriangleMesh tetrahedra(int count, uint64_t seed);
/// nx ny nz unit cubes side by side: faces coincide, so that most hits are ties. 12 nx ny nz triangles, each cube closed.
TriangleMesh cube_lattice(int nx, int ny, int nz);
/// Triangles with centres anywhere in [-1, 1]^3 and corners within `size` of them.
TriangleMesh soup(int count, double size, uint64_t seed);
/// Triangles with corners of any magnitude that float knows, from denormal to 1e38.
TriangleMesh wild_soup(int count, uint64_t seed);
/// Slivers: from one side of [-1, 1]^3 to the other, `width` wide, in any direction.
TriangleMesh slivers(int count, double width, uint64_t seed);
/// Pairs of long thin triangles, side by side askew, as battens of a rotated building: most of their boxes is empty, and spatial splits pay. 4 count triangles.
TriangleMesh battens(int count);
/// A sphere of size 1/1000 in the middle of one of size 1: what uniform structures cannot adapt to.
TriangleMesh stadium(int inner_frequency, int outer_frequency);

/// Each vertex v becomes scale * v + offset, computed in double.
TriangleMesh moved(const TriangleMesh& mesh, const Vec3& scale, const Vec3& offset, const std::string& name);
TriangleMesh scaled(const TriangleMesh& mesh, double scale);
/// Turned about the origin, which it must enclose.
TriangleMesh turned(const TriangleMesh& mesh, const std::string& name);

/// Of at most 320 triangles, of every kind above: brute force can follow.
std::vector<TriangleMesh> small_meshes();
/// Closed ones: sizes 1e-15 to 1e15, flat, needle-like, askew, far from the origin with their offset baked into float vertices.
const std::vector<TriangleMesh>& closed_meshes();

/// Is every directed edge matched by exactly one opposite one?
bool is_closed(const TriangleMesh& mesh);

}  // namespace alidade::numerics
