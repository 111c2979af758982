// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/losses.h"
#include "exporters/pov/patterns.h"

namespace alidade::pov_export {

/// The scene's first camera in world space, or one that frames what can be seen.
Camera chosen_camera(const Scene& scene, Losses& losses);

/// `camera { }`. Its vectors are written as they are, so that a right-handed world needs no turning; a window that is not stretched over the picture follows
/// its shape by image_width and image_height.
void write_camera(const Camera& camera, const RenderSettings& settings, Sdl& sdl, PatternWriter& patterns);

}  // namespace alidade::pov_export
