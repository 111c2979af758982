// SPDX-License-Identifier: Apache-2.0
/// Surfaces of revolution.
#pragma once

#include "exporters/meshing/triangle_list.h"

namespace alidade::meshing {

/// A piece of a profile in the half plane (distance from the axis, height along it), outside on its right, and the normals at its ends.
struct ProfilePiece {
    Vec2 a, b, normal_a, normal_b;
};

/// Straight, with the normal of its right side.
ProfilePiece straight_piece(const Vec2& a, const Vec2& b);
/// `count` pieces of the circle about `center`, from one angle to another (radians, from the distance towards the height).
std::vector<ProfilePiece> arc_pieces(const Vec2& center, double radius, double from, double to, int count);

/// Turns a profile about the axis through `base`. Pieces that begin where the one before ends, and a last that ends where the first begins, share vertices.
void revolve(const std::vector<ProfilePiece>& profile, const Vec3& base, const Vec3& axis, int segments, TriangleList& out);

}  // namespace alidade::meshing
