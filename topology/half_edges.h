// SPDX-License-Identifier: Apache-2.0
/// A surface as an OpenMesh half-edge mesh, with the way back. The only header that includes OpenMesh.
///
/// A half-edge mesh holds only surfaces that are manifold and wound consistently; what it refuses is told, and is rendered all the same, because
/// the triangles of a picture come from the mesh's own arrays, never from here.
#pragma once

#include "topology/weld.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace alidade::topology {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using TriangleHalfEdges = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using PolygonHalfEdges = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

inline OpenMesh::Vec3d to_openmesh(const Vec3& p) { return {p.x, p.y, p.z}; }
inline Vec3 from_openmesh(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }

/// Half-edges over the sound triangles. Vertex handles are numbers of Welded::points.
struct HalfEdges {
    TriangleHalfEdges mesh;
    std::vector<uint32_t> triangle_of;   ///< by face handle: the triangle that it came from
    std::vector<uint32_t> refused;       ///< triangles that do not fit: at an edge that is full, at a vertex whose fan is closed, or that is too crowded
    bool manifold = true;                ///< nothing is refused, and around each vertex there is one fan
};
HalfEdges half_edges(const Welded& surface);

/// How many steps it takes to walk around every vertex once from each of its corners: the sum of valence^power. OpenMesh looks edges up by such
/// walks, so a file of a million triangles around one vertex would keep it busy for days.
double crowding(std::span<const uint32_t> corners, size_t vertices, int power);
inline constexpr double kMostSteps = 1e9;   ///< some seconds

/// OpenMesh writes about refused faces to stderr, which belongs to the program's own messages: this silences it, once.
void silence_openmesh();

}  // namespace alidade::topology
