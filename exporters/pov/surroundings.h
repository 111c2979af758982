// SPDX-License-Identifier: Apache-2.0
/// What surrounds the scene, and what holds for all of it.
#pragma once

#include "exporters/pov/textures.h"

namespace alidade::pov_export {

/// #version and global_settings.
void write_settings(const Scene& scene, Sdl& sdl);
/// Background, sky_sphere, fogs, media. `sky`: the radiance of a constant sky that lights, where there is one.
void write_surroundings(const Scene& scene, const std::optional<Color>& sky, Sdl& sdl, TextureWriter& textures, ImageWriter& images, Losses& losses);
/// The signals that the surroundings read.
std::vector<SignalId> pigments_of_surroundings(const Scene& scene);

}  // namespace alidade::pov_export
