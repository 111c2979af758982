// SPDX-License-Identifier: Apache-2.0
/// The watertight test: eight triangles at once in the precision of the mesh, or, of what passed the edge filter, one in double.
#pragma once

#include "accel/triangles/behind.h"
#include "accel/triangles/decide.h"

namespace alidade {

/// A ray in T, as the shear wants it, and which of the lanes that were returned are to be asked again. `asked`: begins_at_origin().
template <class T> struct WatertightRay {
    [[gnu::always_inline]] inline WatertightRay(const LocalRay& ray, bool asked) : axes(ray.dir), origin{T(component(ray.origin, axes.x)), T(component(ray.origin, axes.y)), T(component(ray.origin, axes.z))} {
        const double inverse = component(ray.inverse, axes.z);
        shear[0] = T(component(ray.dir, axes.x) * inverse), shear[1] = T(component(ray.dir, axes.y) * inverse);
        ahead = inverse < 0 ? T(-1) : T(1), behind_blur = BehindError<T>::blur(origin, asked);
    }

    ShearAxes axes;
    T origin[3], shear[2];
    T ahead, behind_blur;   ///< which way depths are ahead
    mutable uint32_t unsure = 0;
};

/// How far, per axis, the hit of a lane may be from the exact ray, and a box as computed from the exact box: what of it grows with the ray's origin is added to that, what grows with the coordinates of the
/// triangles below a box, to the box, when the tree is built (bvh/watertight_boxes.h). Derived in docs/numerics.md, "Watertight in lanes".
template <class R> R watertight_origin_pad(const LocalRay& ray) { return 24 * kUnitRoundoff<R> * R(max_abs(ray.origin)) + kOriginPad<R>; }
template <class R> R watertight_box_pad(R largest) { return 24 * kUnitRoundoff<R> * largest + kOriginPad<R>; }
template <class R> R largest_coordinate(const BoundsT<R>& box) { return std::max(max_abs(box.min), max_abs(box.max)); }

/// Bit i is set if triangle i of the block may be hit by the line of the ray: surely if it is not set in `unsure`. Neighbours never both reject a line between them: corners that they share are sheared
/// to the same numbers, the function of an edge is for one the negative of what it is for the other, rounding does not turn its sign, and 0 counts as inside.
///
/// If `near`, lanes that is_behind() tells are left out.
///
/// Method   Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013; nothing may be contracted into fused operations.
template <class T> using WatertightTest = uint32_t (*)(const TriangleBlock<T>&, const WatertightRay<T>&, bool near);

/// The test for these instructions, as edge_filter() chooses. All give the same bits.
template <class T> WatertightTest<T> watertight_test(Isa isa);
template <> WatertightTest<float> watertight_test<float>(Isa isa);
template <> WatertightTest<double> watertight_test<double>(Isa isa);

/// A lane that was unsure, because its functions underflow or overflow, or all vanish: they are taken of the same sheared corners in double, where products of floats are exact.
template <class T> bool is_met(const TriangleBlock<T>& block, uint32_t lane, const WatertightRay<T>& ray) {
    double x[3], y[3];
    for (int c = 0; c < 3; ++c) {
        const T z = block.v[3 * c + ray.axes.z][lane] - ray.origin[2];
        x[c] = double((block.v[3 * c + ray.axes.x][lane] - ray.origin[0]) - ray.shear[0] * z);
        y[c] = double((block.v[3 * c + ray.axes.y][lane] - ray.origin[1]) - ray.shear[1] * z);
    }
    const double u = x[1] * y[2] - y[1] * x[2], v = x[2] * y[0] - y[2] * x[0], w = x[0] * y[1] - y[0] * x[1];
    return (u > 0 || v > 0 || w > 0) != (u < 0 || v < 0 || w < 0);   // else on both sides, or edge-on
}

/// Where the line of a ray that meets the triangle, or nearly does, meets it: within the triangle, whatever the angle. Moeller and Trumbore's weights in double.
[[gnu::always_inline]] inline TriangleCrossing crossing_within(const LocalRay& ray, int z, const Corners& corners) {
    const Vec3 e = corners[1] - corners[0], f = corners[2] - corners[0], s = ray.origin - corners[0];
    const Vec3 p = cross(ray.dir, f), q = cross(s, e);
    const double whole = 1 / dot(e, p), u = dot(s, p) * whole, v = dot(ray.dir, q) * whole;
    const double b = u > 0 ? std::min(u, 1.0) : 0, c = v > 0 ? std::min(v, 1 - b) : 0;   // NaN: edge-on
    return {(b * component(e, z) + c * component(f, z) - component(s, z)) * component(ray.inverse, z), b, c};
}

/// As decide(), with the signs that double arithmetic gives: watertight for the same reasons as the lanes.
inline std::optional<TriangleCrossing> decide_watertight(const DecideRay& ray, const Corners& corners) {
    double x[3], y[3], z[3];
    for (size_t c = 0; c < 3; ++c) {
        const Vec3 p = corners[c] - ray.origin;
        z[c] = component(p, ray.axes.z);
        x[c] = component(p, ray.axes.x) - ray.shear_x * z[c];
        y[c] = component(p, ray.axes.y) - ray.shear_y * z[c];
    }
    const double u = x[1] * y[2] - y[1] * x[2], v = x[2] * y[0] - y[2] * x[0], w = x[0] * y[1] - y[0] * x[1];
    const bool positive = u > 0 || v > 0 || w > 0, negative = u < 0 || v < 0 || w < 0;
    if (positive == negative) return std::nullopt;   // on both sides, or edge-on
    const double whole = 1 / (u + v + w), b = v * whole, c = w * whole;
    return TriangleCrossing{(u * whole * z[0] + b * z[1] + c * z[2]) / ray.dir_z, b, c};
}

}  // namespace alidade
