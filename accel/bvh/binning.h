// SPDX-License-Identifier: Apache-2.0
/// The passes over references that a BVH's builder spends its time in.
#pragma once

#include "accel/accelerator.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

namespace alidade {

/// Half the surface, in double: that of boxes 2^120 wide does not fit float.
template <class R> double area(const BoundsT<R>& box) { return Bounds{Vec3(box.min), Vec3(box.max)}.half_area(); }

/// A box as eight numbers, lower ends negated, so that one maximum of all eight extends it: -min x y z, spare, max x y z, largest. Aligned to their size: they may be one vector.
template <class R> struct alignas(8 * sizeof(R)) BoxEnds {
    R v[8];

    static BoxEnds none() {
        constexpr R no = -std::numeric_limits<R>::infinity();
        return {{no, no, no, no, no, no, no, no}};
    }
    R min(int axis) const { return -v[axis]; }
    R max(int axis) const { return v[4 + axis]; }
    R largest() const { return v[7]; }   ///< the largest reference within: the root of its area
    BoundsT<R> box() const { return {{min(0), min(1), min(2)}, {max(0), max(1), max(2)}}; }
    /// Twice the centre: halving would cost a bit of denormal numbers.
    R centroid(int axis) const { return v[4 + axis] - v[axis]; }
    void extend(const BoxEnds& b) {
        for (int i = 0; i < 8; ++i) v[i] = b.v[i] > v[i] ? b.v[i] : v[i];
    }
    /// Areas are compared in double: those of boxes 2^120 wide do not fit float.
    double half_area() const {
        const double x = double(v[4]) + double(v[0]), y = double(v[5]) + double(v[1]), z = double(v[6]) + double(v[2]);
        return x * y + y * z + z * x;
    }
};

/// What is partitioned: boxes stay next to the ids, so that each pass reads memory in order.
template <class R> struct BvhReference : BoxEnds<R> {
    using Bits = std::conditional_t<sizeof(R) == 4, uint32_t, uint64_t>;

    BvhReference() = default;
    BvhReference(const BoundsT<R>& b, uint32_t id)
        : BoxEnds<R>{{-b.min.x, -b.min.y, -b.min.z, std::bit_cast<R>(Bits(id)), b.max.x, b.max.y, b.max.z, R(std::sqrt(area(b)))}} {}
    uint32_t id() const { return uint32_t(std::bit_cast<Bits>(this->v[3])); }
};
static_assert(alignof(BvhReference<float>) == 32 && alignof(BvhReference<double>) == 64);

/// Bounds of centroids; the fourth lane is spare.
template <class R> struct alignas(8 * sizeof(R)) CentroidBounds {
    R low[4], high[4];

    CentroidBounds() { std::fill(low, low + 4, std::numeric_limits<R>::infinity()), std::fill(high, high + 4, -std::numeric_limits<R>::infinity()); }
    void extend(const BoxEnds<R>& b) {
        for (int a = 0; a < 3; ++a) {
            const R c = b.centroid(a);
            low[a] = c < low[a] ? c : low[a], high[a] = c > high[a] ? c : high[a];
        }
    }
    void extend(const CentroidBounds& b) {
        for (int a = 0; a < 3; ++a) low[a] = b.low[a] < low[a] ? b.low[a] : low[a], high[a] = b.high[a] > high[a] ? b.high[a] : high[a];
    }
    R width(int axis) const { return high[axis] - low[axis]; }
};

inline constexpr int kMostBins = 16;

/// Maps centroids along each axis to 0 .. count - 1; without width, or with less than can be divided by, all to 0.
template <class R> struct CentroidMap {
    R low[3], scale[3];
    int count;

    CentroidMap(const CentroidBounds<R>& bounds, int bins) : count(bins) {
        for (int a = 0; a < 3; ++a) {
            const R width = bounds.width(a);
            low[a] = bounds.low[a], scale[a] = width > std::numeric_limits<R>::min() * 64 ? R(bins) / width : R(0);
        }
    }
    bool divides(int axis) const { return scale[axis] > 0; }
    int bin(const BoxEnds<R>& b, int axis) const { return std::min(int((b.centroid(axis) - low[axis]) * scale[axis]), count - 1); }
};

template <class R> struct Bins {
    BoxEnds<R> box[3][kMostBins];
    uint32_t count[3][kMostBins];
};

/// The passes, for one kind of machine; all give the same results.
template <class R> struct BinningPasses {
    /// Extends both by the references.
    void (*bound)(std::span<const BvhReference<R>> references, BoxEnds<R>& box, CentroidBounds<R>& centroids);
    /// Sorts the references into bins along each axis.
    void (*fill)(std::span<const BvhReference<R>> references, const CentroidMap<R>& map, Bins<R>& bins);
    /// Copies those not below `bin` to `rights` and the others to `lefts`, in their order, and tells the bounds of their centroids.
    void (*scatter)(std::span<const BvhReference<R>> references, BvhReference<R>* lefts, BvhReference<R>* rights, const CentroidMap<R>& map, int axis, int bin, CentroidBounds<R>& left,
                    CentroidBounds<R>& right);
};
template <class R> const BinningPasses<R>& binning_passes(Isa isa);
template <> const BinningPasses<float>& binning_passes<float>(Isa isa);
template <> const BinningPasses<double>& binning_passes<double>(Isa isa);

}  // namespace alidade
