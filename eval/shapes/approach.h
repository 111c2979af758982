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

/// a - b as the rounded difference and what the rounding took away, exactly.
/// Source   D. E. Knuth, "The Art of Computer Programming", vol. 2, 3rd ed., theorem 4.2.2 B (TwoSum).
struct RoundedDifference {
    Vec3 rounded, rest;
    RoundedDifference(const Vec3& a, const Vec3& b) : rounded(a - b) {
        const Vec3 of_b = rounded - a, of_a = rounded - of_b;
        rest = (a - of_a) - (b + of_b);
    }
};

/// approach() with the instructions of the caller. For functions that are compiled for machines with a fused multiply-add, too: without it, std::fma is a call that does the same.
[[gnu::always_inline]] inline Approach approach_inline(const Vec3& center, const Ray& ray) {
    const double a = dot(ray.dir, ray.dir);
    const RoundedDifference from_center(ray.origin, center);
    Approach p;
    p.shift = -dot(from_center.rounded, ray.dir) / a;
    for (int i = 0; i < 3; ++i) p.nearest[i] = std::fma(p.shift, ray.dir[i], from_center.rounded[i]);
    p.nearest += from_center.rest;
    p.rest = -dot(p.nearest, ray.dir) / a;
    p.nearest += p.rest * ray.dir;
    return p;
}

#ifdef __x86_64__
inline const bool kHasFma = __builtin_cpu_supports("fma");
#endif

}  // namespace alidade
