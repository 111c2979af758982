// SPDX-License-Identifier: Apache-2.0
/// Which instances are missed by rays that miss what bounds them.
#pragma once

#include "eval/bounded_paths.h"
#include "tracer/compiled_scene.h"

namespace alidade {

/// Gives instances at the ends of paths tests that they may fail. By experiment: of a solid, of a union that is one object, of polynomials and of quadrics that have no box what bounds them itself counts; of other shapes
/// its box in the place of their own, if it is smaller, where no union moves them; and of those that cost little only where POV-Ray makes a hierarchy of boxes. To be called when all instances and solids have their boxes.
void find_bounds(CompiledScene& scene, const BoundedPaths& bounded);

/// Gives objects the boxes of what bounds them in the place of their own, where those are smaller. By experiment: a camera outside of that box is in no object. To be called when they have their boxes.
void bound_object_boxes(CompiledScene& scene, const BoundedPaths& bounded);

}  // namespace alidade
