// SPDX-License-Identifier: Apache-2.0
/// What is wrong with a surface, and what kind of surface it is.
#pragma once

#include "scene/shape.h"

#include <optional>

namespace alidade::topology {

/// Counted after welding (topology/weld.h), over all triangles that have three different finite vertices. None of it changes a picture.
struct SurfaceReport {
    size_t triangles = 0;               ///< of the mesh, all of them
    size_t vertices = 0, edges = 0;     ///< of the welded surface
    size_t components = 0;              ///< pieces that hang together, be it at a single vertex
    size_t holes = 0;                   ///< closed runs of edges with one triangle; a run that ends at a non-manifold edge counts too
    size_t hole_edges = 0;              ///< edges with one triangle
    double hole_length = 0;             ///< of all of these, in the mesh's units
    size_t non_manifold_edges = 0;      ///< with more than two triangles
    size_t non_manifold_vertices = 0;   ///< on such an edge, or with more than one fan of triangles around
    size_t inconsistent_edges = 0;      ///< with two triangles that are wound against each other
    size_t degenerate = 0;              ///< triangles left out of all this: they repeat a vertex, or one is not finite
    size_t without_area = 0;            ///< triangles of three different vertices in a line
    size_t duplicates = 0;              ///< triangles with the vertices of an earlier one, in any order
    size_t refused = 0;                 ///< triangles that a half-edge mesh cannot hold; --subdivide and --decimate leave such a mesh alone

    bool closed() const { return edges > 0 && hole_edges == 0 && non_manifold_edges == 0; }
    int64_t euler() const { return int64_t(vertices) - int64_t(edges) + int64_t(triangles - degenerate); }
    /// The number of handles, over all components; of surfaces that are closed, manifold and wound consistently.
    std::optional<int64_t> genus() const;
};

/// About one second a million triangles.
SurfaceReport examine(const Mesh& mesh);

}  // namespace alidade::topology
