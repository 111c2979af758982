// SPDX-License-Identifier: Apache-2.0
/// Scenes made from a kind, a number and a seed, on which accelerators are measured.
#pragma once

#include "accel/accelerator.h"
#include "core/transform.h"

#include <span>
#include <string_view>
#include <vector>

namespace alidade {

/// One mesh, where a camera and a lamp stand, and for instanced scenes where the mesh stands.
struct StressScene {
    std::vector<Vec3f> positions;
    std::vector<Index3> triangles;
    std::vector<Transform> instances;   ///< empty: the mesh as it is, once
    Vec3 eye{0, 0, 4}, target{0};
    double window = 0.5;                ///< half the width of what the camera sees, at distance 1
    Vec3 lamp{5, 5, 5};

    TriangleView view() const { return {positions, {}, triangles}; }
    Bounds bounds() const;              ///< of the mesh
};

struct StressKind {
    const char* name;
    const char* doc;
    size_t triangles;                                       ///< when nobody asks for another number
    StressScene (*make)(size_t triangles, uint64_t seed);   ///< of about so many triangles; the same for the same arguments
};

std::span<const StressKind> stress_kinds();
/// The row of that name, or null.
const StressKind* find_stress_kind(std::string_view name);

}  // namespace alidade
