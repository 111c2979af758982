// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"
#include "tracer/ray_state.h"

namespace alidade {

/// What is left of light on `length` world units inside the innermost solid of `inside` (Beer's law with KHR_materials_volume's parameters).
/// The same for camera, secondary and shadow rays.
Color transmittance(const CompiledScene& scene, const InteriorStack& inside, double length);

}  // namespace alidade
