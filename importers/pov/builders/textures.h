// SPDX-License-Identifier: Apache-2.0
/// texture, finish -> the layers of a material.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// A texture's layers from the bottom up: of one with a texture_map, a single one.
using TextureLayers = decltype(Material::layers);

/// What stands where a scene says nothing: POV-Ray's own values, changed by the first `count` blocks of #default.
PovFinish default_texture(Build& build, uint32_t count);
/// `texture { ... }`: its items behind the first `skipped`.
TextureLayers build_texture(Build& build, const Block& block, size_t skipped = 0);
/// Takes a pigment, a normal or a finish that comes next into the layer on top; false where none of them stands. `since`: how the layers will be moved by what
/// stood before, which does not move the new part.
bool take_layer_part(Build& build, Cursor& at, TextureLayers& layers, const Transform& since = {});
/// Puts `more` over `layers`, where the language is that of `version`: up to 3.1 what passes the new ones, but the lowest of all and those of pictures, is not coloured.
void add_layers(const Build& build, TextureLayers& layers, TextureLayers more, float version);
/// Moves layers behind all that they have; what is uv_mapped already stays with its surface.
void move_layers(Build& build, TextureLayers& layers, const Transform& t);
/// What bumps on texture coordinates do when the object is moved (by experiment).
enum class Bumps { stay, turn };
/// `uv_mapping` in a texture: its bumps turn. Beside a texture, even such a one: they stay as they are then. (Around an object that has its own it is no matter of layers: NodeFlags.)
void set_uv_mapped(Build& build, TextureLayers& layers, Bumps bumps);
/// `finish { ... }` over what `layer` has. Source   POV-Ray 3.7 reference, 3.4.3.3 "Finish".
void build_finish(Build& build, const Block& block, PovFinish& layer);
/// All of the layer but its pigment and normal becomes that of a declared finish, which begins with the default one where it was declared.
void take_declared_finish(Build& build, const Block& block, PovFinish& layer);

MaterialId add_material(Build& build, TextureLayers layers, Place at);
/// The default texture as a material, made once.
MaterialId default_material(Build& build, uint32_t count);

}  // namespace alidade::pov
