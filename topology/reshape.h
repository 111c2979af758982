// SPDX-License-Identifier: Apache-2.0
/// What a user may ask of all meshes of a scene: finer, coarser, smooth.
#pragma once

#include "core/diagnostics.h"
#include "scene/scene.h"

#include <optional>

namespace alidade {

inline constexpr double kLeastRatio = 1e-6;

struct ReshapeOptions {
    int subdivide = 0;                      ///< levels, at most topology::kMostLevels
    double decimate = 1;                    ///< the part of the triangles that is kept, from kLeastRatio
    std::optional<double> crease_degrees;   ///< 0 to 180; absent: a mesh without normals is flat
    uint64_t most_triangles = uint64_t(1) << 24;   ///< that subdivision may make of all meshes together: 200 bytes each while it works

    bool any() const { return subdivide > 0 || decimate < 1 || crease_degrees; }
};

/// Subdivides, then decimates, then makes normals, of every mesh. A mesh that cannot be treated stays as it is, with a warning. Meshes that have lost
/// their normals get new ones: with the crease angle if one is given; else smooth everywhere after subdivision, and, if they had any, with creases
/// beyond 60 degrees after decimation. Morphed meshes, and those that mix textures over triangles, are left alone. An error, and nothing done, if subdivision would make too many triangles.
void reshape(Scene& scene, const ReshapeOptions& options, Diagnostics& said);

}  // namespace alidade
