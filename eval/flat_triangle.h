// SPDX-License-Identifier: Apache-2.0
/// Triangles of POV-Ray's meshes that are drawn flat though they have normals.
#pragma once

#include "core/vec.h"

#include <array>

namespace alidade {

/// POV-Ray takes normals that lie no farther than this from the first one for the same.
inline constexpr double kSameNormal = 1e-5;

/// A triangle's own unit normal, on the side of `n`.
inline Vec3 own_normal(const std::array<Vec3, 3>& corners, const Vec3& n) {
    const Vec3 own = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    return dot(own, n) < 0 ? -own : own;
}

/// Are the three normals of a triangle one, and not its own? POV-Ray draws such triangles of `mesh` and `mesh2` flat, as if they had no normals; those that stand alone keep them.
/// It makes normals unit first; those without direction are none. A difference of less than a milliradian shows nowhere and counts as none.
/// Source   probing POV-Ray 3.7 with normals that differ by 1e-12 to 1e-3, in all three places, and with normals of length 2.
inline bool is_drawn_flat(const std::array<Vec3, 3>& corners, std::array<Vec3, 3> normals) {
    constexpr double kVisible = 1e-3;
    for (Vec3& n : normals) {
        if (!(length(n) > 0)) return false;
        n = normalized(n);
    }
    if (length(normals[1] - normals[0]) > kSameNormal || length(normals[2] - normals[0]) > kSameNormal) return false;
    return length(own_normal(corners, normals[0]) - normals[0]) > kVisible;   // no triangle without extent
}

}  // namespace alidade
