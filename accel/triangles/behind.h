// SPDX-License-Identifier: Apache-2.0
/// Triangles that are surely behind a ray which begins where its caller's does. What is spawned on a surface meets the line of that surface's triangle at its origin or behind it, and most often nothing else. Where a ray begins
/// in a leaf, all lanes are asked: a branch that only that triangle's lane took would be foreseen by no processor, and cost more than the whole test.
#pragma once

#include "accel/local_ray.h"

#include <limits>

namespace alidade {

/// Is all that is before the local ray's origin before the caller's interval?
inline bool begins_at_origin(const Ray& ray, const LocalRay& local) { return local.shift == 0 && ray.tmin >= 0; }

/// How far below 0 the sum of edge functions times depths, of the sign of the functions, must be that the hit is behind: that of the exact triangle, and the point to which the watertight test cuts it off. Derived in
/// docs/numerics.md, "Behind the origin".
template <class T> struct BehindError {
    static constexpr T u = kUnitRoundoff<T>;
    static constexpr T kOrigin = 40 * u, kCubes = 64 * u, kTiny = 64 * std::numeric_limits<T>::min();

    /// Once a ray, of its origin in sheared axes; infinite for one that is not to be asked.
    static T blur(const T (&origin)[3], bool asked) { return asked ? kOrigin * (std::max(std::abs(origin[0]), std::abs(origin[1])) + std::abs(origin[2])) : std::numeric_limits<T>::infinity(); }
    /// `m`: the largest coordinate of the sheared corners, depths too. Infinite where the sum, which is below 8 m^3, may overflow.
    static T bound(T blur, T m) { return ((m * m) * blur + ((8 * m) * (m * m)) * kCubes) + kTiny; }
};

/// `depths`: positive ahead of the ray. `sum`: of the functions.
template <class T> bool is_behind(T depths, T sum, T blur, T m) { return (std::signbit(sum) ? -depths : depths) < -BehindError<T>::bound(blur, m); }

}  // namespace alidade
