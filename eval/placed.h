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
Vec3 corrected(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near);
/// The same bits on any machine, component by component.
Vec3 corrected_plainly(const Mat3& to_world, const Mat3& to_local, const Vec3& shift, const Vec3& world, const Vec3& near);

/// How far a transformed ray may be from the exact image of `ray` at t, in local space: gamma_5 of each product and sum in the transform.
inline double mapped_error(const PlacedNorms& norms, const Ray& ray, double t) {
    return gamma_bound(5) * (norms.to_local * (length(ray.origin) + std::abs(t) * length(ray.dir)) + norms.local_shift);
}

/// The same of a corrected one, `local`: its own roundings, and what the correction leaves, a relative error of the second order.
inline double corrected_error(const PlacedNorms& norms, const Ray& ray, const Ray& local, double t) {
    const double mapped = mapped_error(norms, ray, t), left = gamma_bound(5) * norms.to_world * norms.to_local;
    return gamma_bound(2) * (length(local.origin) + std::abs(t) * length(local.dir)) + std::min(1.0, left * left / gamma_bound(5)) * mapped;
}

/// How far the true surface may be from `position`, a hit that was found with a transformed ray, in the space of the ray; `own` is the bound of the shape's
/// own space, `local` how far the transformed ray may be off in it.
///
/// Mapped back, both grow by at most the norm of to_world. Ray::at() adds gamma_3.
inline double placed_error(const PlacedNorms& norms, const ErrorBound& own, double local, const Ray& ray, double t, const Vec3& position) {
    const double reach = length(ray.origin) + std::abs(t) * length(ray.dir);
    return norms.to_world * (own.along_normal + local) + gamma_bound(5) * (reach + length(position));
}

}  // namespace alidade
