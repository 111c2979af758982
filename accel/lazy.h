// SPDX-License-Identifier: Apache-2.0
/// Structures that are built when they are needed first: what no ray comes near costs its box alone.
#pragma once

#include "accel/accelerator.h"

namespace alidade {

/// As entry.over_triangles(mesh, options), built when the first ray enters the triangles' bounds, by the thread that has the ray; others that come there wait. Same hits,
/// same bounds, same triangles removed. What `mesh` views must live as long as the accelerator. Until it is built, its stats() tell of no structure, and take no time.
std::unique_ptr<Accelerator> over_triangles_lazily(const AcceleratorEntry& entry, const TriangleView& mesh, const AccelOptions& options);

/// What stands behind `accelerator`: itself, unless it waits for a ray, or null while it waits.
const Accelerator* built(const Accelerator& accelerator);

}  // namespace alidade
