// SPDX-License-Identifier: Apache-2.0
/// Corners that are alike: what stays of a mesh's attributes when its vertices are welded.
#pragma once

#include "topology/weld.h"

namespace alidade::topology {

/// A wedge: corners at one point, of triangles of one material slot, with equal texture coordinates and colours. A point inside a smooth piece has one,
/// on a seam two or more.
struct Wedges {
    std::vector<uint32_t> of_corner;   ///< by corner of the mesh; kNone for those of unsound triangles
    std::vector<uint32_t> corner;      ///< by wedge: one of its corners
    std::vector<uint32_t> point;       ///< by wedge: in Welded::points
};
Wedges wedges_of(const Mesh& mesh, const Welded& surface);

}  // namespace alidade::topology
