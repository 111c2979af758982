// SPDX-License-Identifier: Apache-2.0
/// The entry point that all structures share: the ray is moved, in double, to where it enters the bounds of the primitives.
#pragma once

#include "accel/slab.h"
#include "core/ray.h"

#include <optional>
#include <type_traits>

namespace alidade {

/// Coordinates of rays and of double vertices are rounded to multiples of 2^-300, so that exact signs (triangles/exact_sign.h) cannot underflow.
inline double quantized(double x) {
    constexpr double shift = 0x1.8p-248;   // its ulp is 2^-300
    return std::abs(x) < 0x1p-249 ? (x + shift) - shift : x;
}
inline Vec3 quantized(const Vec3& v) { return {quantized(v.x), quantized(v.y), quantized(v.z)}; }

/// More than a hit's t may be off, relatively (kDepthError of triangles/decide.cpp), and the roundings around it: a box that holds the exact hit is not culled by the computed one.
inline constexpr double kHitPad = 0x1p-29;

/// The ray that structures and leaves see. From here on (origin, dir) *is* the ray: every decision is about these numbers, exactly, and they
/// depend on the caller's ray and on the bounds alone, so that all structures decide the same.
struct LocalRay {
    Vec3 origin{0}, dir{0};             ///< dir is the caller's times a power of two: its largest component is in [1, 2)
    double shift = 0;                   ///< local t of the new origin, seen from the caller's origin
    double to_caller = 1, to_local = 1; ///< powers of two
    double tmin = 0, tmax = -1;         ///< local interval that holds all hits; empty if the ray misses the bounds
    double reach = 0;                   ///< bounds |t| in it
    std::optional<SlabRay<double>> slab;   ///< of origin, dir and reach; there if the bounds are not empty

    bool enters_box() const { return tmin <= tmax; }
    double caller_t(double t) const { return shift * to_caller + t * to_caller; }
    /// Not less than any local t whose caller_t is at most `caller`, and the same from below.
    double upper(double caller) const;
    double lower(double caller) const;
};

/// The ray for tests against boxes of type R.
template <class R> decltype(auto) slab_of(const LocalRay& ray) {
    if constexpr (std::is_same_v<R, double>) return (*ray.slab);
    else return SlabRay<R>(ray.origin, ray.dir, ray.reach);
}

/// Does `ray` have a direction, no NaN, and an origin within `largest` (kLargestCoordinate)? Others hit nothing.
bool can_hit(const Ray& ray, double largest);

/// `ray`, which can hit, made ready for primitives within `bounds` (finite or empty). `move`: to the entry into the bounds. Custom primitives
/// answer in the caller's t, so for them the ray stays where it is.
LocalRay local_ray(const Ray& ray, const Bounds& bounds, bool move);

}  // namespace alidade
