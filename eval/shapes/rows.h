// SPDX-License-Identifier: Apache-2.0
/// The rows of the table of shapes, each defined in the file of its shape.
#pragma once

#include "core/clamp.h"
#include "eval/shapes/shape_ops.h"

namespace alidade {

extern const ShapeOps kSphereOps, kPlaneOps, kBoxOps, kDiscOps, kCylinderOps, kConeOps, kTorusOps, kQuadricOps, kPolynomialOps, kPolygonOps, kExtrusionOps;

inline bool always_solid(const ShapeGeometry&) { return true; }

/// The index of the shape `T` in ShapeGeometry.
template <class T, size_t I = 0> constexpr size_t kind_of() {
    if constexpr (std::is_same_v<std::variant_alternative_t<I, ShapeGeometry>, T>) return I;
    else return kind_of<T, I + 1>();
}

/// False for the rays that hit nothing (core/ray.h), but for a zero direction, which no shape's equation has a solution for.
inline bool is_finite(const Ray& ray) {
    const Vec3 nothing = (ray.origin - ray.origin) + (ray.dir - ray.dir);   // or NaN, without a branch for each number
    return nothing.x + nothing.y + nothing.z == 0;
}

/// std::hypot, whose last half of a unit costs ten times as much, where nothing overflows or vanishes. Within 1 unit of 2^-52.
inline double planar_length(double x, double y) {
    const double square = x * x + y * y;
    return square > 1e-280 && square < 1e280 ? std::sqrt(square) : std::hypot(x, y);
}

/// Bounds the rounding of one component of ray.at(t), whether or not the compiler fuses it.
inline double at_rounding(const Ray& ray, double t, int axis) { return gamma_bound(2) * (std::abs(ray.origin[axis]) + std::abs(t * ray.dir[axis])); }
/// Bounds how far the rounding of ray.at(t) moves the point, in any direction.
inline double at_rounding(const Ray& ray, double t) { return gamma_bound(5) * (max_abs(ray.origin) + std::abs(t) * max_abs(ray.dir)); }   // 5 > 2 sqrt(3) + 1

}  // namespace alidade
