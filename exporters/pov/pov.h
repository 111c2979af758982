// SPDX-License-Identifier: Apache-2.0
/// Scene -> POV-Ray's scene description language, as POV-Ray 3.7 reads it.
#pragma once

#include "exporters/losses.h"
#include "exporters/output_files.h"

namespace alidade {

/// One .pov file and its pictures. POV-Ray's own parts of a scene (solids, set operations, textures) are written as they are; metal-rough materials,
/// lights that fall by 1 / d^2 and skies that light become what POV-Ray has that is nearest, and what that changes is told to `losses`, a line for
/// each material. Skins and morph targets are written as they stand. Source   POV-Ray 3.7 reference manual.
tl::expected<void, std::string> write_pov(const Scene& scene, OutputFiles& files, Losses& losses);

}  // namespace alidade
