// SPDX-License-Identifier: Apache-2.0
/// The rays that accelerators are measured with.
#pragma once

#include "stress/scene.h"

namespace alidade {

/// In float, as most ray tracers take them.
struct StressRay {
    Vec3f origin, dir;
    float tmin, tmax;

    Ray ray() const;
};

struct StressRays {
    std::vector<StressRay> primary;   ///< side x side, from the eye, line by line
    std::vector<StressRay> shadow;    ///< from what those hit to the lamp, in the same order; t = 1 is the lamp
    std::vector<StressRay> diffuse;   ///< from what those hit, by the cosine about the normal
};

/// `accelerator` stands over the scene: over the instances, where it has some.
StressRays make_stress_rays(const StressScene& scene, const Accelerator& accelerator, size_t side, uint64_t seed);

}  // namespace alidade
