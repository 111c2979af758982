// SPDX-License-Identifier: Apache-2.0
/// glTF's metal-rough surfaces -> the nearest texture.
#pragma once

#include "exporters/pov/highlight.h"
#include "exporters/pov/images.h"

namespace alidade::pov_export {

/// Which mirror images are written. POV-Ray follows those of all textures that are mixed at a point, so that with weak ones rays multiply for nothing.
enum class MirrorImages { all, strong };

/// Where textures are written to.
struct TextureOutput {
    Sdl& sdl;
    ImageWriter& images;
    Losses& losses;
    HighlightFits& highlights;
};

/// `#declare name = texture { }`, one or several layers; without a name, the texture where it stands. Diffuse light, Schlick's reflection, glass, emission, alpha and the base colour's picture are those of the
/// surface; `sky` lights it from all sides; highlights are the lobes nearest to GGX's, and what else POV-Ray has no word for is told with the material's name.
void write_metal_rough(const MaterialRef& material, const PlainSurface& surface, const Color& sky, const TextureOutput& out, const std::string& name, MirrorImages mirrors = MirrorImages::all);

/// Beer's law of KHR_materials_volume in POV-Ray's words: with fade_power above 1000 light falls by exp(-(1 - fade_color) x / fade_distance).
void set_beer(Interior& in);

}  // namespace alidade::pov_export
