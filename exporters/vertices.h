// SPDX-License-Identifier: Apache-2.0
/// Meshes whose corners have indices of their own for each attribute, as formats want them that have one index a vertex.
#pragma once

#include "scene/shape.h"

#include <span>

namespace alidade {

/// The vertices of some triangles of a mesh: one for each different combination of a position and what its corner has else.
struct Vertices {
    std::vector<uint32_t> positions;    ///< of each vertex: an index into Mesh::positions
    std::vector<uint32_t> corners;      ///< of each vertex: a corner (3 x triangle + number) that has it; empty if no attribute has corners of its own
    std::vector<Index3> triangles;      ///< into the vertices

    size_t size() const { return positions.size(); }
    template <class T> const T& value(const Attribute<T>& attribute, size_t vertex) const {
        return attribute.values[attribute.corners.empty() ? positions[vertex] : attribute.corners[corners[vertex]]];
    }
};

/// The vertices of the triangles `which`. Where no attribute has corners of its own, vertices keep the mesh's order; and if `which` are all triangles,
/// all vertices are there, used or not.
Vertices collect_vertices(const Mesh& mesh, std::span<const uint32_t> which);

/// The triangles with three finite vertices, in order.
std::vector<uint32_t> finite_triangles(const Mesh& mesh);

/// Numbers pairs (a[i], b[i]) in the order in which they first stand there; a[i] becomes the number.
void number_pairs(std::vector<uint32_t>& a, std::span<const uint32_t> b);

}  // namespace alidade
