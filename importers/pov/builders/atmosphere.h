// SPDX-License-Identifier: Apache-2.0
/// background, sky_sphere, fog, rainbow -> what surrounds the scene.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

void read_background(Build& build, const Block& block);
/// The last sky_sphere of a scene counts. Source   POV-Ray 3.7 reference, 3.4.5.5 "Sky Sphere".
void read_sky_sphere(Build& build, const Block& block);
/// All fogs of a scene count. Source   POV-Ray 3.7 reference, 3.4.5.3 "Fog".
void read_fog(Build& build, const Block& block);
/// All rainbows of a scene count. Source   POV-Ray 3.7 reference, 3.4.5.4 "Rainbow".
void read_rainbow(Build& build, const Block& block);

}  // namespace alidade::pov
