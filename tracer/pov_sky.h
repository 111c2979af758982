// SPDX-License-Identifier: Apache-2.0
/// What stands around a POV-Ray scene: its sky_sphere, and the rainbows and fogs on the way.
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// The colour in the unit direction `direction`: the sky's pigments over the background, which shines through where they let it.
/// Source   POV-Ray 3.7 reference, 3.4.5.5 "Sky Sphere"; by experiment: scenes before version 3.7 mix several pigments in another way.
Color pov_sky(const CompiledScene& scene, const Vec3& direction);

/// The same where pictures have alpha: the colour over what is behind the scene, and how much of that shows through; `mirrored`: where nothing may, in a mirror, which shows all of the background's colour.
struct SkyOver {
    Color color{0};
    double shows = 1;
};
SkyOver pov_sky_over(const CompiledScene& scene, const Vec3& direction, bool mirrored);

/// What is seen through rainbows and fogs: `added` + `kept` times what lies behind it.
struct Haze {
    Color added{0}, kept{1};
    double shows = 1;   ///< factor of RayState::shows
};

/// All rainbows, behind all fogs, along a ray of the unit direction `direction` over `distance`, which may be infinite.
/// Source   POV-Ray 3.7 reference, 3.4.5.3 "Fog"; by experiment: the colour of a fog is not dimmed by those in front of it;
/// of rainbows that meet, the mean is seen.
Haze haze(const CompiledScene& scene, const Vec3& origin, const Vec3& direction, double distance);

}  // namespace alidade
