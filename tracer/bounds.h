// SPDX-License-Identifier: Apache-2.0
/// Which instances are missed by rays that miss what bounds them.
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// An instance below a node that something bounds.
struct BoundedInstance {
    uint32_t instance = 0;
    std::vector<NodeId> path;      ///< from a root to its shape
};

/// Gives those of them tests that they may fail. By experiment: of a solid, of a union that is one object, of polynomials and of quadrics that have no box what bounds them itself counts; of other shapes
/// its box in the place of their own, if it is smaller, where no union moves them; and of those that cost little only where POV-Ray makes a hierarchy of boxes. To be called when all instances and solids have their boxes.
void find_bounds(CompiledScene& scene, const std::vector<BoundedInstance>& bounded);

}  // namespace alidade
