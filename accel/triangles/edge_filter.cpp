// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/edge_filter.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/triangles/edge_filter.cpp"
#include "hwy/foreach_target.h"
#include "accel/triangles/edge_filter-inl.h"

#if HWY_ONCE

namespace alidade {

namespace {

/// One triangle, the oracle of the vector versions: the same operations give the same bits.
template <class T> bool may_hit(const TriangleBlock<T>& block, uint32_t lane, const FilterRay<T>& ray) {
    using Error = EdgeError<T>;
    T x[3], y[3], mx = 0, my = 0, depth = 0;
    for (int c = 0; c < 3; ++c) {
        const T z = block.v[3 * c + ray.axes.z][lane] - ray.origin[2];
        x[c] = (block.v[3 * c + ray.axes.x][lane] - ray.origin[0]) - ray.shear[0] * z;
        y[c] = (block.v[3 * c + ray.axes.y][lane] - ray.origin[1]) - ray.shear[1] * z;
        mx = std::max(mx, std::abs(x[c])), my = std::max(my, std::abs(y[c])), depth = std::max(depth, std::abs(z));
    }
    const T dx = Error::corner(ray.farthest[0], ray.slope[0], mx, depth), dy = Error::corner(ray.farthest[1], ray.slope[1], my, depth);
    const T error = Error::edge(dx, dy, mx, my);
    const T u = x[1] * y[2] - y[1] * x[2], v = x[2] * y[0] - y[2] * x[0], w = x[0] * y[1] - y[0] * x[1];
    const bool positive = u > error || v > error || w > error, negative = u < -error || v < -error || w < -error;
    return !(positive && negative);   // where something overflowed, the error is infinite and nothing is rejected
}

template <class T> uint32_t filter_scalar(const TriangleBlock<T>& block, const FilterRay<T>& ray) {
    uint32_t bits = 0;
    for (uint32_t lane = 0; lane < kLanes; ++lane) bits |= uint32_t(may_hit(block, lane, ray)) << lane;
    return bits;
}

template <class T> struct FilterEntry {
    Isa isa;
    EdgeFilter<T> filter;
};

/// What was compiled, from the plainest to the widest.
template <class T> constexpr FilterEntry<T> kFilters[] = {
    {Isa::scalar, filter_scalar<T>},
#if HWY_TARGETS & HWY_SSE4
    {Isa::sse4, N_SSE4::filter_block<T>},
#endif
#if HWY_TARGETS & HWY_AVX2
    {Isa::avx2, N_AVX2::filter_block<T>},
#endif
#if HWY_TARGETS & HWY_AVX3
    {Isa::avx512, N_AVX3::filter_block<T>},
#endif
};

}  // namespace

template <> EdgeFilter<float> edge_filter<float>(Isa isa) { return chosen(kFilters<float>, isa).filter; }
template <> EdgeFilter<double> edge_filter<double>(Isa isa) { return chosen(kFilters<double>, isa).filter; }

}  // namespace alidade

#endif
