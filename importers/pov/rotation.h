// SPDX-License-Identifier: Apache-2.0
/// Rotations as POV-Ray's words mean them: in its left-handed world, angles in degrees.
#pragma once

#include "core/vec.h"

namespace alidade::pov {

/// About x, then y, then z: x turns y to z, y turns z to x, z turns x to y.
Mat3 rotation(const Vec3& degrees);
/// About any axis (its length does not matter).
Mat3 axis_rotation(const Vec3& axis, double degrees);

}  // namespace alidade::pov
