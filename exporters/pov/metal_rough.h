// SPDX-License-Identifier: Apache-2.0
/// glTF's metal-rough surfaces -> the nearest texture.
#pragma once

#include "exporters/pov/images.h"

namespace alidade::pov_export {

/// Which mirror images are written. POV-Ray follows those of all textures that are mixed at a point, so that with weak ones rays multiply for nothing.
enum class MirrorImages { all, strong };

/// `texture { }`, one or several layers. Diffuse light, Schlick's reflection, glass, emission, alpha and the base colour's picture are those of the
/// surface; `sky` lights it from all sides; highlights are Blinn's instead of GGX's, and what else POV-Ray has no word for is told with the material's name.
void write_metal_rough(const std::string& name, const PlainSurface& surface, const Color& sky, Sdl& sdl, ImageWriter& images, Losses& losses,
                       MirrorImages mirrors = MirrorImages::all);

/// Beer's law of KHR_materials_volume in POV-Ray's words: with fade_power above 1000 light falls by exp(-(1 - fade_color) x / fade_distance).
void set_beer(Interior& in);

}  // namespace alidade::pov_export
