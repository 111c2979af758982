// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/ray_state.h"

#include <vector>

namespace alidade {

/// A discrete direction in which a surface sends light on, and what it multiplies it by.
struct Secondary {
    Vec3 dir{0};
    Color weight{0};
    RayKind kind = RayKind::reflection;
    InteriorStack inside;   ///< of the new ray
    double importance = -1; ///< the new ray's, as a factor of the old one's; below 0: the new ray's weight is its importance
    bool straight = false;  ///< it goes on as it came, and is no deeper
    double shows = 1;       ///< factor of RayState::shows
    double exponent = 1;    ///< to which its radiance is raised before it is weighted
};

/// A mirror ray, a refracted ray and a mirror ray of the coat; of POV-Ray's texture maps and layers there can be more. (What passes straight through alpha is no ray of its own: the integrator goes on.)
using Secondaries = std::vector<Secondary>;

}  // namespace alidade
