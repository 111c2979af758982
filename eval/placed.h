// SPDX-License-Identifier: Apache-2.0
/// Shapes under a transform: a ray is brought into a shape's own space, where t means the same.
#pragma once

#include "core/transform.h"
#include "eval/shapes/shape_ops.h"
#include "eval/shapes/twice.h"

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
    /// Do roundings of local rays cost three digits or more? So where a shape is stretched, or stands a thousand times its size from the origin.
    bool cost_digits() const { return to_world * to_local > 1e3 || local_shift > 1e3; }
    PlacedNorms(const Transform& world, const Transform& local) : to_world(world.norm()), to_local(local.norm()), local_shift(length(local.translation)) {}
};

/// `near`, the rounded image of `world` in local space, brought to the exact one: what is left of `world` once `near` is mapped back is known to twice the digits. `shift`: that of to_world, or 0 for directions.
inline Vec3 corrected(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near) {
    TwiceVec rest = TwiceVec::difference(world, shift);
    for (int column = 0; column < 3; ++column) rest = rest.moved(Twice(-near[column]), TwiceVec(to_world[column]));
    return near + to_local * Vec3(rest.v[0].value(), rest.v[1].value(), rest.v[2].value());
}

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
