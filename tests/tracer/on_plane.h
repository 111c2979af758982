// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/shade_point.h"

namespace alidade::test {

/// A point of the plane y = 0 with these texture coordinates.
inline ClosedFormPoint on_plane(double u, double v) {
    static const ShapeGeometry plane = Plane();
    return {find_shape(plane), &plane, Vec3(u, 0, -v), 0};
}

}  // namespace alidade::test
