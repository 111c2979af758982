// SPDX-License-Identifier: Apache-2.0
/// Axis-aligned boxes.
#pragma once

#include "core/vec.h"

namespace alidade {

/// The closed box [min, max]; the default one is empty (min > max).
template <class R> struct BoundsT {
    Vec3T<R> min{std::numeric_limits<R>::infinity()};
    Vec3T<R> max{-std::numeric_limits<R>::infinity()};

    void extend(const Vec3T<R>& p) { min = glm::min(min, p), max = glm::max(max, p); }
    void extend(const BoundsT& b) { min = glm::min(min, b.min), max = glm::max(max, b.max); }
    bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    bool finite() const { return is_finite(min) && is_finite(max); }
    Vec3T<R> center() const { return min * R(0.5) + max * R(0.5); }
    Vec3T<R> extent() const { return max - min; }

    /// Half the surface area, the measure that the surface area heuristic needs; 0 for an empty box.
    R half_area() const {
        if (empty()) return 0;
        const Vec3T<R> e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
    bool overlaps(const BoundsT& b) const {
        return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y && min.z <= b.max.z && b.min.z <= max.z;
    }
    bool contains(const Vec3T<R>& p) const {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && min.z <= p.z && p.z <= max.z;
    }
};

using Bounds = BoundsT<double>;
using BoundsF = BoundsT<float>;

template <class R> BoundsT<R> intersection(const BoundsT<R>& a, const BoundsT<R>& b) {
    return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

}  // namespace alidade
