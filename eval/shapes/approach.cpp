// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"

namespace alidade {

namespace {

#ifdef __x86_64__
[[gnu::target("fma")]] Approach with_fma(const Vec3& center, const Ray& ray) { return approach_inline(center, ray); }
#endif

}  // namespace

Approach approach(const Vec3& center, const Ray& ray) {
#ifdef __x86_64__
    if (kHasFma) return with_fma(center, ray);
#endif
    return approach_inline(center, ray);
}

}  // namespace alidade
