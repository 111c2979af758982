// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace alidade::pov {

/// From this on quick_color is nothing, and what is behind a surface is seen.
inline constexpr int kWholePigments = 6;

/// Takes out of a scene what POV-Ray leaves out at a quality of `+Q`: media, fogs and rainbows below 9; reflection and normals below 8; what is seen through surfaces below 6 (and a pigment with a quick_color is that colour, which the reader
/// sees to); the extent of lights below 5; shadows below 4; all but the colour of the last layer that is reached below 2. Where the manual (3.2.8.3.1 "Quality Settings") says otherwise, POV-Ray's pictures decided.
void reduce(Scene& scene, int quality);

}  // namespace alidade::pov
