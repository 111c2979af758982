// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/transform.h"
#include "scene/shape.h"

namespace alidade {

/// Of two coordinates, but for roundings: its axes are not those of space.
bool has_products(const Quadric& q);
/// The box of a quadric that is an ellipsoid along the axes; all space for others.
Bounds box_of_ellipsoid(Quadric q);
/// What POV-Ray thinks that the inequality of a quadric leaves of `box`, axis by axis. By experiment it does not ask all quadrics, and some for another constant: it loses parts of them.
Bounds reach(const Quadric& q, const Bounds& box);
/// May it have points outside of its reach, where it is or moved? Paraboloids, and hyperboloids with a wide waist.
bool may_outgrow_reach(const Quadric& q);
/// The quadric moved by `t`; as it is where `t` has no inverse.
Quadric moved(const Quadric& q, const Transform& t);

}  // namespace alidade
