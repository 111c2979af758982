// SPDX-License-Identifier: Apache-2.0
/// KHR_lights_punctual's spot as a sum of POV-Ray's spotlights.
#pragma once

#include "scene/light.h"

#include <vector>

namespace alidade::pov_export {

/// One spotlight: `share` of the spot's light times cos(a)^tightness, from `radius` to `falloff` (radians) falling by 3u^2 - 2u^3 of the cosine.
struct RimPart {
    double share, radius, falloff, tightness = 0;
};

struct SpotRim {
    std::vector<RimPart> parts;
    double off;   ///< the most by which their sum differs from the rim, of the spot's light
};

/// With c = cos(a), glTF's rim is ((c - outer) / ramp)^2 between two cosines. Multiplied out, it is three spotlights of tightness 2, 1 and 0 that end hard at the outer
/// angle; three more at the inner angle take from it what goes beyond 1. That is exact but for POV-Ray's colours, which are floats: they are great where the ramp is
/// short, and their difference is rounded. There the rim is fitted by up to three smooth ones instead.
SpotRim spot_rim(const SpotLight& spot);

}  // namespace alidade::pov_export
