// SPDX-License-Identifier: Apache-2.0
/// What a camera's rays are in when they begin: it is left where they come to its surface, and what is not hollow keeps fog out.
#pragma once

#include "tracer/compiled_scene.h"
#include "tracer/interior_stack.h"

namespace alidade {

/// Fills in CompiledScene::around_cameras. After CompiledScene::all_air is known.
void find_what_is_around_cameras(CompiledScene& scene);

/// The bodies that hold the origin of a camera's ray, in the order of the scene. By experiment: POV-Ray counts those that a camera does not see, too.
InteriorStack start_inside(const CompiledScene& scene, const Vec3& origin);

}  // namespace alidade
