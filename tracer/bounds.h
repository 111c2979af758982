// SPDX-License-Identifier: Apache-2.0
/// Which instances are missed by rays that miss what bounds them.
#pragma once

#include "eval/bounded_paths.h"
#include "tracer/compiled_scene.h"

namespace alidade {

/// Does POV-Ray look for objects by their boxes? By experiment: where it has three, with the lights.
bool has_hierarchy(const CompiledScene& scene);

/// Gives instances at the ends of paths tests that they may fail. By experiment: of a solid, of a union that is one object, of polynomials and of quadrics that have no box what bounds them itself counts, and of all
/// objects the box that POV-Ray keeps (eval/kept_boxes.h); but of shapes that cost little only where it makes a hierarchy of boxes. To be called when all instances and solids have their boxes.
void find_bounds(CompiledScene& scene, const BoundedPaths& bounded);

/// Gives objects the boxes that POV-Ray keeps of them. By experiment: a camera outside of that box is in no object. To be called when they have their boxes.
void bound_object_boxes(CompiledScene& scene, const BoundedPaths& bounded);

}  // namespace alidade
