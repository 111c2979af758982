// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/ray.h"
#include "tracer/interior_stack.h"
#include "tracer/sampler.h"

namespace alidade {

enum class RayKind { camera, reflection, refraction, shadow };

/// What travels with every ray.
struct RayState {
    InteriorStack inside;
    Color weight{1};        ///< what the ray's radiance will be multiplied by on its way to the pixel
    double importance = 1;  ///< POV-Ray's weight of the ray, which adc_bailout is compared with
    double travelled = 0;   ///< on its last straight piece, to the surface that is looked at
    double shows = 1;       ///< how much of what is behind the scene is seen, where pictures have alpha
    bool mirrored = false;  ///< it has been on its way from the camera
    int depth = 0;          ///< how many surfaces sent it on
    RayKind kind = RayKind::camera;
    SampleKey key;
    float time = 0;
};

}  // namespace alidade
