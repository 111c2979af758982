// SPDX-License-Identifier: Apache-2.0
/// Rays and hits: all that accelerators, shapes and integrators say to each other.
#pragma once

#include "core/error_bound.h"
#include "core/vec.h"

#include <cstdint>

namespace alidade {

/// Which instances a ray may see: an instance is tested when (its mask & the ray's) is not 0.
using Mask = uint32_t;
inline constexpr Mask kMaskCamera = 1, kMaskShadow = 2, kMaskReflection = 4, kMaskAll = ~Mask(0);

/// The points origin + t dir with tmin <= t <= tmax. `dir` need not be a unit vector: t counts its multiples.
/// tmin may be -infinity (the whole line). A ray with a NaN, or with a zero or infinite direction, hits nothing.
struct Ray {
    Vec3 origin{0}, dir{0, 0, 1};
    double tmin = 0, tmax = kInf;
    float time = 0;
    Mask mask = kMaskAll;

    Vec3 at(double t) const { return origin + t * dir; }
};

inline constexpr uint32_t kNoId = ~uint32_t(0);

/// A crossing. `instance` and `primitive` are indices of the source arrays; `part` names a part of a shape (a face of a box, a side of a
/// cylinder, a part of a CSG solid); (u, v) are barycentric for triangles: the point is (1-u-v) p0 + u p1 + v p2.
struct Hit {
    double t = kInf;
    uint32_t instance = kNoId, primitive = kNoId, part = 0;
    float u = 0, v = 0;
    ErrorBound error;   ///< of triangles; closed forms are asked for theirs (eval/shapes/shape_ops.h)

    bool valid() const { return primitive != kNoId; }
};

/// The order of hits: nearer first (of POV scenes InstanceSet has another one for those in one place); at equal distance the lower instance, then the lower primitive.
inline bool comes_before(double t, uint32_t instance, uint32_t primitive, const Hit& hit) {
    if (t != hit.t) return t < hit.t;
    if (instance != hit.instance) return instance < hit.instance;
    return primitive < hit.primitive;
}

}  // namespace alidade
