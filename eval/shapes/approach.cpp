// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"

namespace alidade {

namespace {

/// a - b as the rounded difference and what the rounding took away, exactly.
/// Source   D. E. Knuth, "The Art of Computer Programming", vol. 2, 3rd ed., theorem 4.2.2 B (TwoSum).
struct Difference {
    Vec3 rounded, rest;
    Difference(const Vec3& a, const Vec3& b) : rounded(a - b) {
        const Vec3 of_b = rounded - a, of_a = rounded - of_b;
        rest = (a - of_a) - (b + of_b);
    }
};

[[gnu::always_inline]] inline Approach recentred_twice(const Vec3& center, const Ray& ray) {
    const double a = dot(ray.dir, ray.dir);
    const Difference from_center(ray.origin, center);
    Approach p;
    p.shift = -dot(from_center.rounded, ray.dir) / a;
    for (int i = 0; i < 3; ++i) p.nearest[i] = std::fma(p.shift, ray.dir[i], from_center.rounded[i]);
    p.nearest += from_center.rest;
    p.rest = -dot(p.nearest, ray.dir) / a;
    p.nearest += p.rest * ray.dir;
    return p;
}

#ifdef __x86_64__
/// The same numbers: without the instruction, std::fma is a call that does the same.
[[gnu::target("fma")]] Approach with_fma(const Vec3& center, const Ray& ray) { return recentred_twice(center, ray); }
const bool kHasFma = __builtin_cpu_supports("fma");
#endif

}  // namespace

Approach approach(const Vec3& center, const Ray& ray) {
#ifdef __x86_64__
    if (kHasFma) return with_fma(center, ray);
#endif
    return recentred_twice(center, ray);
}

}  // namespace alidade
