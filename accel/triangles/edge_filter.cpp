// SPDX-License-Identifier: Apache-2.0
#include "accel/triangles/edge_filter.h"

// This file is compiled once for each of these targets, by including itself.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/triangles/edge_filter.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// may_hit() below, on as many lanes as `d` has: multiplications, additions and comparisons in the same order.
template <class T, class D> HWY_ATTR auto may_hit_lanes(D d, const TriangleBlock<T>& block, uint32_t lane, const FilterRay<T>& ray) {
    using V = hn::Vec<D>;
    using Error = EdgeError<T>;
    const auto all = [&](T value) HWY_ATTR { return hn::Set(d, value); };
    const auto load = [&](int corner, int axis, int origin) HWY_ATTR { return hn::Sub(hn::Load(d, &block.v[3 * corner + axis][lane]), all(ray.origin[origin])); };
    const auto sheared = [&](int corner, int axis, int i, V z) HWY_ATTR { return hn::Sub(load(corner, axis, i), hn::Mul(all(ray.shear[i]), z)); };
    const auto largest = [&](V a, V b, V c) HWY_ATTR { return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c)); };
    const V z0 = load(0, ray.axes.z, 2), z1 = load(1, ray.axes.z, 2), z2 = load(2, ray.axes.z, 2);
    const V x0 = sheared(0, ray.axes.x, 0, z0), x1 = sheared(1, ray.axes.x, 0, z1), x2 = sheared(2, ray.axes.x, 0, z2);
    const V y0 = sheared(0, ray.axes.y, 1, z0), y1 = sheared(1, ray.axes.y, 1, z1), y2 = sheared(2, ray.axes.y, 1, z2);

    const V mx = largest(x0, x1, x2), my = largest(y0, y1, y2), depth = largest(z0, z1, z2);
    const auto corner = [&](int i, V m) HWY_ATTR {
        const V near = hn::Add(all(Error::kOrigin * ray.farthest[i]), hn::Mul(all(Error::kSheared), m));
        return hn::Add(hn::Add(near, hn::Mul(all(Error::kDepth), hn::Mul(all(ray.slope[i]), depth))), all(Error::kQuanta));
    };
    const V dx = corner(0, mx), dy = corner(1, my);
    const V linear = hn::Mul(all(Error::kLinear), hn::Add(hn::Mul(dx, my), hn::Mul(dy, mx)));
    const V error = hn::Add(hn::Add(linear, hn::Mul(all(Error::kSquare), hn::Mul(dx, dy))), all(Error::kQuanta));

    const auto edge = [&](V xa, V ya, V xb, V yb) HWY_ATTR { return hn::Sub(hn::Mul(xa, yb), hn::Mul(ya, xb)); };
    const V u = edge(x1, y1, x2, y2), v = edge(x2, y2, x0, y0), w = edge(x0, y0, x1, y1), below = hn::Neg(error);
    const auto positive = hn::Or(hn::Or(hn::Gt(u, error), hn::Gt(v, error)), hn::Gt(w, error));
    const auto negative = hn::Or(hn::Or(hn::Lt(u, below), hn::Lt(v, below)), hn::Lt(w, below));
    return hn::Not(hn::And(positive, negative));
}

template <class T> HWY_ATTR uint32_t filter_block(const TriangleBlock<T>& block, const FilterRay<T>& ray) {
    const hn::CappedTag<T, kLanes> d;
    const auto lanes = uint32_t(hn::Lanes(d));
    uint32_t bits = 0;
    for (uint32_t lane = 0; lane < kLanes; lane += lanes) {
        uint8_t stored[8] = {};
        hn::StoreMaskBits(d, may_hit_lanes(d, block, lane, ray), stored);
        bits |= uint32_t(stored[0]) << lane;
    }
    return bits;
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

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

bool machine_has(Isa isa) {
    static const int64_t targets = hwy::SupportedTargets();   // asks the processor, which takes long on a virtual machine
    switch (isa) {
        case Isa::best:
        case Isa::scalar: return true;
        case Isa::sse4: return (targets & HWY_SSE4) != 0;
        case Isa::avx2: return (targets & HWY_AVX2) != 0;
        case Isa::avx512: return (targets & HWY_AVX3) != 0;
    }
    return false;
}

template <class T> EdgeFilter<T> choose(Isa isa) {
    EdgeFilter<T> chosen = filter_scalar<T>;
    for (const FilterEntry<T>& entry : kFilters<T>) {
        if (machine_has(entry.isa) && (isa == Isa::best || isa == entry.isa)) chosen = entry.filter;
    }
    return chosen;
}

}  // namespace

template <> EdgeFilter<float> edge_filter<float>(Isa isa) { return choose<float>(isa); }
template <> EdgeFilter<double> edge_filter<double>(Isa isa) { return choose<double>(isa); }

std::span<const Isa> available_isas() {
    static const std::vector<Isa> isas = [] {
        std::vector<Isa> found;
        for (const auto& entry : kFilters<float>) {
            if (machine_has(entry.isa)) found.push_back(entry.isa);
        }
        return found;
    }();
    return isas;
}

const char* name(Isa isa) {
    switch (isa) {
        case Isa::best: return "best";
        case Isa::scalar: return "scalar";
        case Isa::sse4: return "sse4";
        case Isa::avx2: return "avx2";
        case Isa::avx512: return "avx512";
    }
    return "unknown";
}

}  // namespace alidade

#endif
