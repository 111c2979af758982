// SPDX-License-Identifier: Apache-2.0
/// texture, pigment, finish -> PovFinish layers.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// A texture's layers from the bottom up.
using TextureLayers = std::vector<PovFinish>;

/// What stands where a scene says nothing: POV-Ray's own values, changed by the first `count` blocks of #default.
PovFinish default_texture(Build& build, uint32_t count);
/// `texture { ... }`.
TextureLayers build_texture(Build& build, const Block& block);
/// `pigment { ... }` over what `layer` has.
void build_pigment(Build& build, const Block& block, PovFinish& layer);
/// `finish { ... }` over what `layer` has. Source   POV-Ray 3.7 reference, 3.4.3.3 "Finish".
void build_finish(Build& build, const Block& block, PovFinish& layer);

MaterialId add_material(Build& build, TextureLayers layers, Place at);
/// The default texture as a material, made once.
MaterialId default_material(Build& build, uint32_t count);

}  // namespace alidade::pov
