// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace alidade::pov {

/// Moves what finishes of POV-Ray 3.0 say of interiors (PovFinish::ior ...) into the interiors of the scene's objects, which get one where they have none.
/// By experiment: parts of sets without an `interior` of their own share that of the nearest set around them that has one, or else of the object as a whole.
/// Sets before their parts, and parts in their order, each writes what the finish on top of its texture says into it: an ior and caustics where they are given,
/// and a refraction always (1, if nothing is said). Maps of textures, and textures of triangles, of components and of insides, write nothing.
void fill_interiors_by_finishes(Scene& scene);

}  // namespace alidade::pov
