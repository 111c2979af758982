// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/rotation.h"

#include <cmath>
#include <numbers>

namespace alidade::pov {

namespace {

double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }

}  // namespace

Mat3 rotation(const Vec3& degrees) {
    const double cx = std::cos(radians(degrees.x)), sx = std::sin(radians(degrees.x));
    const double cy = std::cos(radians(degrees.y)), sy = std::sin(radians(degrees.y));
    const double cz = std::cos(radians(degrees.z)), sz = std::sin(radians(degrees.z));
    const Mat3 about_x{{1, 0, 0}, {0, cx, sx}, {0, -sx, cx}};      // columns: where x, y and z go
    const Mat3 about_y{{cy, 0, -sy}, {0, 1, 0}, {sy, 0, cy}};
    const Mat3 about_z{{cz, sz, 0}, {-sz, cz, 0}, {0, 0, 1}};
    return about_z * about_y * about_x;
}

Mat3 axis_rotation(const Vec3& axis, double degrees) {
    const double length = std::sqrt(dot(axis, axis));
    if (length == 0) return Mat3{1.0};
    const Vec3 k = axis / length;
    const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees)), d = 1 - c;
    return {{c + k.x * k.x * d, k.x * k.y * d + k.z * s, k.x * k.z * d - k.y * s},
            {k.x * k.y * d - k.z * s, c + k.y * k.y * d, k.y * k.z * d + k.x * s},
            {k.x * k.z * d + k.y * s, k.y * k.z * d - k.x * s, c + k.z * k.z * d}};
}

}  // namespace alidade::pov
