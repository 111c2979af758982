// SPDX-License-Identifier: Apache-2.0
/// Meshes bent by morph targets and by joints. Vertices move in double precision; each function leaves attributes that the mesh does not have absent.
#pragma once

#include "scene/scene.h"

#include <span>

namespace alidade {

/// Adds `weights[i]` times target i to positions, normals and tangents; both directions come out as unit vectors.
/// Source   glTF 2.0, section 3.7.2.2 "Morph Targets".
void morph(Mesh& mesh, std::span<const MorphTarget> targets, std::span<const double> weights);

/// Linear blend skinning: each vertex goes by the average of its joints' matrices, weighted by its weights over their sum; normals by the transpose of
/// the average's inverse. A vertex without weights stays; a front stays a front where joints mirror. The mesh is then in the space that `joints` lead to, relative to an origin of its own.
/// Source   glTF 2.0, section 3.7.3 "Skins"; N. Magnenat-Thalmann et al., "Joint-dependent local deformations", Graphics Interface 1988.
void skin(Mesh& mesh, std::span<const JointSet> sets, std::span<const Transform> joints);

}  // namespace alidade
