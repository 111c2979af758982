// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/edge_filter.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/triangles/edge_filter.cpp"
#include "hwy/foreach_target.h"
#include "accel/triangles/edge_filter-inl.h"

#if HWY_ONCE

namespace alidade {

namespace {

/// One triangle, the oracle of the vector versions that do not fuse: the same operations give the same bits.
template <class T> bool may_hit(const TriangleBlock<T>& block, uint32_t lane, const FilterRay<T>& ray, bool near) {
    using Error = EdgeError<T>;
    T x[3], y[3], z[3], m = 0, depth = 0;
    for (int c = 0; c < 3; ++c) {
        z[c] = ray.origin[2] - block.v[3 * c + ray.axes.z][lane];
        x[c] = (ray.origin[0] - block.v[3 * c + ray.axes.x][lane]) - ray.shear[0] * z[c];
        y[c] = (ray.origin[1] - block.v[3 * c + ray.axes.y][lane]) - ray.shear[1] * z[c];
        m = std::max(m, std::max(std::abs(x[c]), std::abs(y[c]))), depth = std::max(depth, std::abs(z[c]));
    }
    const T error = Error::bound(ray.origin_blur + ray.depth_blur * depth, m);
    const T u = x[1] * y[2] - y[1] * x[2], v = x[2] * y[0] - y[2] * x[0], w = x[0] * y[1] - y[0] * x[1];
    const bool positive = std::max(u, std::max(v, w)) > error, negative = std::min(u, std::min(v, w)) < -error;
    if (positive && negative) return false;   // where something overflowed, the error is infinite and nothing is rejected
    return !near || !is_behind(ray.ahead * ((u * z[0] + v * z[1]) + w * z[2]), (u + v) + w, ray.behind_blur, std::max(m, depth));
}

template <class T> uint32_t filter_scalar(const TriangleBlock<T>& block, const FilterRay<T>& ray, bool near) {
    uint32_t bits = 0;
    for (uint32_t lane = 0; lane < kLanes; ++lane) bits |= uint32_t(may_hit(block, lane, ray, near)) << lane;
    return bits;
}

template <class T> constexpr IsaRow<EdgeFilter<T>> kFilters[] = {ALIDADE_ISA_ROWS(filter_scalar<T>, filter_block<T>)};

}  // namespace

template <> EdgeFilter<float> edge_filter<float>(Isa isa) { return chosen(kFilters<float>, isa); }
template <> EdgeFilter<double> edge_filter<double>(Isa isa) { return chosen(kFilters<double>, isa); }

}  // namespace alidade

#endif
