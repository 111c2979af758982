// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/ray.h"
#include "scene/camera.h"

namespace alidade {

/// The ray of POV-Ray's cameras whose window is not flat, at `s` and `t` in -1/2 .. 1/2 to the right and up. Where such a camera has none, outside of a
/// round picture, its tmax is below its tmin.
/// Source   POV-Ray 3.7 reference, 3.4.2.2 "Camera Types"; where it is silent, what probing found.
Ray curved_ray(const Camera& camera, double s, double t);
/// Where the normal of any camera is looked up for that ray, in the plane z = 0: at (s, t) of flat windows, else at the angles, in radians, that make the ray.
Vec2 bent_at(const Camera& camera, double s, double t);

}  // namespace alidade
