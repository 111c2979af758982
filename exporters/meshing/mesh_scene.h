// SPDX-License-Identifier: Apache-2.0
/// For formats that hold meshes alone: everything else as a mesh.
#pragma once

#include "exporters/losses.h"

#include <tl/expected.hpp>

namespace alidade::meshing {

/// An error beyond: the scene asks for more triangles than a reader would want.
inline constexpr size_t kMostMadeTriangles = 20'000'000;

/// Does the scene show shapes that are no meshes, or solids made of several?
bool needs_meshes(const Scene& scene);

/// The scene with a mesh in place of each closed form and of each solid (set operations, clips). `segments` make a full circle; solids, quadrics and polynomials are
/// sampled with as many cells along their longest side. Endless shapes are cut near what is bounded. All this is told to `losses`. An error is one sentence.
/// Ids of nodes change where parts of solids are left out.
tl::expected<Scene, std::string> mesh_scene(const Scene& scene, int segments, Losses& losses);

}  // namespace alidade::meshing
