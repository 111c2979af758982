// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"
#include "tracer/ray_state.h"

namespace alidade {

/// What is left of light on `length` world units inside the innermost solid of `inside` (Beer's law with KHR_materials_volume's parameters).
/// The same for camera, secondary and shadow rays.
Color transmittance(const CompiledScene& scene, const InteriorStack& inside, double length);

/// The index of refraction where `inside` is: 1 outside of everything.
double ior_in(const CompiledScene& scene, const InteriorStack& inside);

/// Is there fog where `inside` is: in nothing but what is hollow?
bool fog_reaches(const CompiledScene& scene, const InteriorStack& inside);

/// POV-Ray's fade_distance, fade_power and fade_color over `length` world units.
/// Source   POV-Ray 3.7 reference, 3.4.5.3 "Attenuation"; verified by probing.
Color pov_fade(const Interior& interior, double length);

}  // namespace alidade
