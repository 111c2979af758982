// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accel/accelerator.h"
#include "core/transform.h"

namespace alidade {

/// Boxes that hold the triangles of a mesh, by the cell of a 4 x 4 x 4 grid that a triangle's middle is in. The box of a turned box has room for what is not
/// there: in a forest of turned trees, the boxes of the turned cells make top nodes that one ray in ten need not enter.
std::vector<Bounds> cell_boxes(const TriangleView& mesh);

/// The box of a mesh that is placed: its box and its cells', each as it is moved, hold it.
Bounds placed_bounds(const Transform& to_world, const Bounds& bounds, std::span<const Bounds> cells);

}  // namespace alidade
