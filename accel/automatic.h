// SPDX-License-Identifier: Apache-2.0
/// `auto`: an accelerator chosen by what the primitives are. Accelerator::why says which, and why.
#pragma once

#include "accel/accelerator.h"

namespace alidade {

/// The BVH, unless its boxes do not tell the triangles apart: then whichever of it and the octree probe rays get through with less work.
std::unique_ptr<Accelerator> over_triangles_auto(const TriangleView& mesh, const AccelOptions& options);
std::unique_ptr<Accelerator> over_set_auto(std::shared_ptr<const PrimitiveSet> set, const AccelOptions& options);

}  // namespace alidade
