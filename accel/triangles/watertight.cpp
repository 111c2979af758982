// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/watertight.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/triangles/watertight.cpp"
#include "hwy/foreach_target.h"
#include "accel/triangles/watertight-inl.h"

#if HWY_ONCE

namespace alidade {

namespace {

/// One triangle, the oracle of the vector versions: the same operations give the same bits.
template <class T> bool test_lane(const TriangleBlock<T>& block, uint32_t lane, const WatertightRay<T>& ray, bool near) {
    T x[3], y[3], z[3], m = 0;
    for (int c = 0; c < 3; ++c) {
        z[c] = block.v[3 * c + ray.axes.z][lane] - ray.origin[2];
        x[c] = (block.v[3 * c + ray.axes.x][lane] - ray.origin[0]) - ray.shear[0] * z[c];
        y[c] = (block.v[3 * c + ray.axes.y][lane] - ray.origin[1]) - ray.shear[1] * z[c];
        m = std::max(m, std::max(std::abs(z[c]), std::max(std::abs(x[c]), std::abs(y[c]))));
    }
    const T u = x[1] * y[2] - y[1] * x[2], v = x[2] * y[0] - y[2] * x[0], w = x[0] * y[1] - y[0] * x[1];
    if ((u > 0 || v > 0 || w > 0) && (u < 0 || v < 0 || w < 0)) return false;
    const T sum = (u + v) + w;
    if (near && is_behind(ray.ahead * ((u * z[0] + v * z[1]) + w * z[2]), sum, ray.behind_blur, m)) return false;
    if (!(std::abs(sum) > 0)) ray.unsure |= 1u << lane;
    return true;
}

template <class T> uint32_t watertight_scalar(const TriangleBlock<T>& block, const WatertightRay<T>& ray, bool near) {
    uint32_t bits = 0;
    ray.unsure = 0;
    for (uint32_t lane = 0; lane < kLanes; ++lane) bits |= uint32_t(test_lane(block, lane, ray, near)) << lane;
    return bits;
}

template <class T> constexpr IsaRow<WatertightTest<T>> kTests[] = {ALIDADE_ISA_ROWS(watertight_scalar<T>, watertight_block<T>)};

}  // namespace

template <> WatertightTest<float> watertight_test<float>(Isa isa) { return chosen(kTests<float>, isa); }
template <> WatertightTest<double> watertight_test<double>(Isa isa) { return chosen(kTests<double>, isa); }

}  // namespace alidade

#endif
