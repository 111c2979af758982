// SPDX-License-Identifier: Apache-2.0
/// What planes enclose: a tetrahedron between four of them has a box, though none of them has one and no two of them make one.
#pragma once

#include "core/bounds.h"

#include <span>

namespace alidade {

/// The points with dot(normal, p) <= offset.
struct HalfSpace {
    Vec3 normal{0, 1, 0};
    double offset = 0;
};

/// A box around what all of them have in common; all of space where that has no end, where it reaches a million times farther than the planes are from the origin, and where roundings leave that open.
/// Method   the corners: where three planes meet in a point that no other plane cuts off. O(n^4), so more than 32 are not asked.
Bounds box_of_corners(std::span<const HalfSpace> half_spaces);

}  // namespace alidade
