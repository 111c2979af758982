// SPDX-License-Identifier: Apache-2.0
/// Shapes -> the beginnings of object blocks.
#pragma once

#include "exporters/pov/node_facts.h"
#include "exporters/pov/textures.h"

namespace alidade::pov_export {



/// What a shape may need besides its numbers.
struct ShapeContext {
    const Scene& scene;
    Sdl& sdl;
    TextureWriter& textures;
    Losses& losses;
};

/// Has the shape a surface that POV-Ray takes? It refuses what has no extent.
bool can_be_seen(const ShapeGeometry& geometry);

/// `sphere {` and its parameters: the block is left open for modifiers. `slots`: materials of a mesh's triangles; that of slot 0 is the object's own and
/// is not written. The shape can be seen.
void begin_shape(const ShapeGeometry& geometry, const SlotMaterials& slots, const ShapeContext& context);

void begin_mesh(const Mesh& mesh, const SlotMaterials& slots, const ShapeContext& context);

}  // namespace alidade::pov_export
