// SPDX-License-Identifier: Apache-2.0
/// Where a line is inside a box, as computed in double by every accelerator: the rule that makes them agree (docs/numerics.md).
#pragma once

#include "core/bounds.h"
#include "core/ray.h"

namespace alidade {

/// The part of the line of a ray inside a box: all t with entry <= t <= exit, none if entry > exit.
struct LineInterval {
    double entry = -kInf, exit = kInf;
    bool empty() const { return !(entry <= exit); }
};
/// As computed in double: (plane - origin) / dir on each axis, a division, since a multiplication with the rounded 1 / dir would add a rounding.
LineInterval inside_bounds(const Ray& ray, const Bounds& bounds);
/// The same bits on any machine, axis by axis.
LineInterval inside_bounds_plainly(const Ray& ray, const Bounds& bounds);

/// Clamps `t` into the interval in which the line of `ray` is inside `bounds`. Returns `t` itself if the line misses the box.
double clamp_to_bounds(double t, const Ray& ray, const Bounds& bounds);

/// What rounding in the transform of a ray into an instance may move a t by, generously: candidates this far behind the best are still asked for, so that
/// the clamp decides between them, and not the order in which instances are visited.
inline double instance_slack(const Ray& ray, double t) { return 1e-9 * (std::abs(t) + max_abs(ray.origin) / max_abs(ray.dir)); }

}  // namespace alidade
