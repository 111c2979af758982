// SPDX-License-Identifier: Apache-2.0
#include "core/clamp.h"

#include <cmath>

namespace alidade {

/// Divided by one instruction: what this function takes is mostly the time of its divisions.
using Pair [[gnu::vector_size(16)]] = double;

LineInterval inside_bounds(const Ray& ray, const Bounds& bounds) {
    LineInterval inside;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.dir[axis];
        if (d == 0) {   // 0 / 0 says nothing: parallel to the slab, the line is in it as a whole or not at all; its faces belong to it
            if (!(bounds.min[axis] <= o && o <= bounds.max[axis])) return {kInf, -kInf};
            continue;
        }
        const Pair ends = (Pair{bounds.min[axis], bounds.max[axis]} - o) / d;
        if (std::isnan(ends[0]) || std::isnan(ends[1])) return {kInf, -kInf};
        inside.entry = std::max(inside.entry, std::min(ends[0], ends[1]));
        inside.exit = std::min(inside.exit, std::max(ends[0], ends[1]));
    }
    return inside;
}

double clamp_to_bounds(double t, const Ray& ray, const Bounds& bounds) {
    if (bounds.min == Vec3(-kInf) && bounds.max == Vec3(kInf)) return t;
    const LineInterval inside = inside_bounds(ray, bounds);
    return inside.empty() ? t : std::clamp(t, inside.entry, inside.exit);
}

}  // namespace alidade
