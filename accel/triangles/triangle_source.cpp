// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/triangle_source.h"

#include "accel/triangles/exact_sign.h"

#include <algorithm>
#include <limits>

namespace alidade {

namespace {

template <class R> bool usable(const Vec3& p) { return std::abs(p.x) <= kLargestCoordinate<R> && std::abs(p.y) <= kLargestCoordinate<R> && std::abs(p.z) <= kLargestCoordinate<R>; }

/// Surely not collinear: quicker than collinear(), in float. What underflow takes from products is less than the last term.
bool spans_area(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    constexpr float rounding = 8 * std::numeric_limits<float>::epsilon(), least = 16 * std::numeric_limits<float>::min();
    const Vec3f e = b - a, f = c - a;
    const auto differ = [&](float left, float right) { return std::abs(left - right) > rounding * (std::abs(left) + std::abs(right)) + least; };
    return differ(e.x * f.y, e.y * f.x) || differ(e.y * f.z, e.z * f.y) || differ(e.z * f.x, e.x * f.z);
}

}  // namespace

template <class R> TriangleSource<R>::TriangleSource(const TriangleView& mesh) : mesh_(mesh) {
    for (uint32_t i = 0; i < mesh.positions.size() && all_usable_; ++i) all_usable_ = usable<R>(position(i));
}

template <class R> PrimitiveKind TriangleSource<R>::kind(uint32_t id) const {
    const Index3& t = mesh_.triangles[id];
    if (std::max({t.x, t.y, t.z}) >= mesh_.positions.size()) return PrimitiveKind::removed;
    if constexpr (std::is_same_v<R, float>) {
        if (all_usable_ && spans_area(mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z])) return PrimitiveKind::bounded;
    }
    const Corners c = corners(id);
    if (!all_usable_ && !std::all_of(c.begin(), c.end(), usable<R>)) return PrimitiveKind::removed;
    return collinear(c[0], c[1], c[2]) ? PrimitiveKind::removed : PrimitiveKind::bounded;
}

template <class R> Bounds TriangleSource<R>::clipped_bounds(uint32_t id, const Bounds& box) const {
    const Corners c = corners(id);
    const Bounds common = intersection(bounds(id), box);
    if (common.empty()) return common;
    const Vec3 e = c[1] - c[0], f = c[2] - c[0], normal = cross(e, f);
    const Vec3 center = common.center(), half = common.max - center, q = center - c[0];
    double reach = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double rounding = gamma_bound(12) * (std::abs(e[j] * f[k]) + std::abs(e[k] * f[j]));
        reach += (std::abs(normal[i]) + rounding) * std::max(half[i], center[i] - common.min[i]) + rounding * std::abs(q[i]) +
                 gamma_bound(12) * std::abs(normal[i]) * (std::abs(center[i]) + std::abs(c[0][i]));
    }
    return std::abs(dot(normal, q)) > reach ? Bounds() : common;
}

template class TriangleSource<float>;
template class TriangleSource<double>;

}  // namespace alidade
