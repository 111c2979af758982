// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/transform.h"
#include "scene/shape.h"

namespace alidade {

/// The box of a quadric that is an ellipsoid along the axes; all space for others.
Bounds box_of_ellipsoid(Quadric q);
/// What the inequality of a quadric without products leaves of `box`, axis by axis.
Bounds reach(const Quadric& q, const Bounds& box);
/// The quadric moved by `t`; as it is where `t` has no inverse.
Quadric moved(const Quadric& q, const Transform& t);

}  // namespace alidade
