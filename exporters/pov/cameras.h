// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/losses.h"
#include "exporters/pov/patterns.h"

namespace alidade::pov_export {

/// The scene's cameras in world space, or one that frames what can be seen.
struct Cameras {
    std::vector<Camera> all;   ///< never empty
    const Camera& first() const { return all.front(); }
};
Cameras cameras_of(const Scene& scene, Losses& losses);

/// The first, which POV-Ray looks through, and the others as declarations: `camera { Camera_2 }` behind the scene looks through another. Vectors are written as they are, so that a right-handed world needs no turning; a window that is not stretched over the picture follows
/// its shape by image_width and image_height.
void write_cameras(const Cameras& cameras, const RenderSettings& settings, Sdl& sdl, PatternWriter& patterns);

}  // namespace alidade::pov_export
