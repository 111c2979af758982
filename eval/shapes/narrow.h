// SPDX-License-Identifier: Apache-2.0
/// Boxes for shapes that have none by themselves: what is left of them in a box.
#pragma once

#include "core/bounds.h"
#include "scene/shape.h"

namespace alidade {

/// A box around all points of `box`, whose sides may be infinite, with f(p) <= 0 (`outside`: >= 0); empty if there are none. Each side is brought in once:
/// where one was, calling again can bring in the others further.
/// Method   along an axis f is a quadratic whose coefficients are intervals over the other two; the farthest of their roots bounds the side.
Bounds narrowed(const Quadric& f, bool outside, const Bounds& box);

/// The same for a polynomial: of a finite box the parts are left, as boxes of a lattice, where intervals do not rule the points out. A box without end stays as
/// it is, unless the terms of the highest degree say how far the points can be.
Bounds narrowed(const Polynomial& f, bool outside, const Bounds& box);

}  // namespace alidade
