// SPDX-License-Identifier: Apache-2.0
/// Shapes under a transform: a ray is brought into a shape's own space, where t means the same.
#pragma once

#include "core/transform.h"
#include "eval/shapes/shape_ops.h"

namespace alidade {

/// A crossing of a closed form, as a hit.
inline Hit hit_of(const Crossing& crossing, uint32_t instance) {
    Hit hit;
    hit.t = crossing.t;
    hit.instance = instance;
    hit.primitive = 0;
    hit.part = crossing.part;
    return hit;
}

/// What transforms do to lengths at the most.
struct PlacedNorms {
    double to_world = 1, to_local = 1, local_shift = 0;
    PlacedNorms() = default;
    PlacedNorms(const Transform& world, const Transform& local) : to_world(world.norm()), to_local(local.norm()), local_shift(length(local.translation)) {}
};

/// How far the true surface may be from `position`, a hit that was found with a transformed ray, in the space of the ray; `own` is the bound of the shape's
/// own space.
///
/// The local ray is the exact image of the ray up to gamma_4 of each product and sum in the transform; mapped back, that and the hit's own bound
/// grow by at most the norm of to_world. Ray::at() adds gamma_3.
inline double placed_error(const PlacedNorms& norms, const ErrorBound& own, const Ray& ray, double t, const Vec3& position) {
    const double reach = length(ray.origin) + std::abs(t) * length(ray.dir);
    const double local_size = norms.to_local * reach + norms.local_shift;
    return norms.to_world * (own.along_normal + gamma_bound(5) * local_size) + gamma_bound(5) * (reach + length(position));
}

}  // namespace alidade
