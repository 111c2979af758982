// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/ray.h"

namespace alidade {

/// Where the line of a ray comes nearest to a point: at t = shift + rest, at `nearest` relative to that point.
struct Approach {
    double shift, rest;
    Vec3 nearest;
};

/// Re-centred twice: the first shift is rounded, and what is left of dot(nearest, dir) measures by how much. Neither a far origin nor a far centre
/// costs digits: the difference origin - centre is carried exactly, and the fused multiply-add rounds only its small result. Not finite if the ray has
/// no direction.
Approach approach(const Vec3& center, const Ray& ray);

}  // namespace alidade
