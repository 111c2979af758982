// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/binning.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/binning.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// In double, too, vectors are of 256 bits: -mprefer-vector-width in cmake/folder.cmake says why.
template <class R> inline constexpr size_t kAtOnce = 32 / sizeof(R);

/// BoxEnds::extend; coordinates are finite, so that all maxima are the same.
template <class R> HWY_INLINE HWY_ATTR void extend(BoxEnds<R>& box, const BoxEnds<R>& by) {
    const hn::CappedTag<R, kAtOnce<R>> d;
    for (size_t i = 0; i < 8; i += hn::Lanes(d)) hn::Store(hn::Max(hn::Load(d, by.v + i), hn::Load(d, box.v + i)), d, box.v + i);
}

/// A CentroidMap of four lanes; the last one maps anything to anything.
template <class R> struct MapLanes {
    alignas(4 * sizeof(R)) R low[4] = {}, scale[4] = {};
    R last;

    explicit MapLanes(const CentroidMap<R>& map) : last(R(map.count - 1)) { std::copy(map.low, map.low + 3, low), std::copy(map.scale, map.scale + 3, scale); }
};

/// CentroidMap::bin along all axes, before it is truncated.
template <class R> HWY_INLINE HWY_ATTR void map_to_bins(const BoxEnds<R>& box, const MapLanes<R>& map, R* bins) {
    const hn::CappedTag<R, 4> d;
    for (size_t i = 0; i < 4; i += hn::Lanes(d)) {
        const auto c = hn::Sub(hn::Load(d, box.v + 4 + i), hn::Load(d, box.v + i));
        hn::Store(hn::Min(hn::Mul(hn::Sub(c, hn::Load(d, map.low + i)), hn::Load(d, map.scale + i)), hn::Set(d, map.last)), d, bins + i);
    }
}

template <class R> HWY_INLINE HWY_ATTR void clear(Bins<R>& bins, int count) {
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < count; ++b) bins.box[a][b] = BoxEnds<R>::none(), bins.count[a][b] = 0;
    }
}

template <class R> HWY_INLINE HWY_ATTR void add_to_bins(const BvhReference<R>& reference, const MapLanes<R>& map, Bins<R>& bins) {
    alignas(4 * sizeof(R)) R at[4];
    map_to_bins<R>(reference, map, at);
    for (int a = 0; a < 3; ++a) {
        const int bin = int(at[a]);
        extend<R>(bins.box[a][bin], reference), ++bins.count[a][bin];
    }
}

/// So many references for each bin, at least, are sorted into two sets of bins in turns: neighbours are in the same bin, and would wait for each other.
inline constexpr size_t kInTurns = 4;

template <class R> HWY_ATTR void fill_bins(std::span<const BvhReference<R>> references, const CentroidMap<R>& map, Bins<R>& bins) {
    const MapLanes<R> lanes(map);
    clear(bins, map.count);
    if (references.size() < kInTurns * size_t(map.count)) {
        for (const BvhReference<R>& reference : references) add_to_bins(reference, lanes, bins);
        return;
    }
    Bins<R> others;
    clear(others, map.count);
    for (size_t i = 0; i + 1 < references.size(); i += 2) add_to_bins(references[i], lanes, bins), add_to_bins(references[i + 1], lanes, others);
    if (references.size() % 2 == 1) add_to_bins(references.back(), lanes, bins);
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < map.count; ++b) extend<R>(bins.box[a][b], others.box[a][b]), bins.count[a][b] += others.count[a][b];
    }
}

/// CentroidBounds::extend.
template <class R> HWY_INLINE HWY_ATTR void extend(CentroidBounds<R>& bounds, const BoxEnds<R>& by) {
    const hn::CappedTag<R, 4> d;
    for (size_t i = 0; i < 4; i += hn::Lanes(d)) {
        const auto c = hn::Sub(hn::Load(d, by.v + 4 + i), hn::Load(d, by.v + i));
        hn::Store(hn::Min(c, hn::Load(d, bounds.low + i)), d, bounds.low + i), hn::Store(hn::Max(c, hn::Load(d, bounds.high + i)), d, bounds.high + i);
    }
}

template <class R> HWY_ATTR void bound(std::span<const BvhReference<R>> references, BoxEnds<R>& box, CentroidBounds<R>& centroids) {
    for (const BvhReference<R>& reference : references) extend<R>(box, reference), extend<R>(centroids, reference);
}

template <class R> HWY_INLINE HWY_ATTR void copy(const BvhReference<R>& from, BvhReference<R>& to) {
    const hn::CappedTag<R, kAtOnce<R>> d;
    for (size_t i = 0; i < 8; i += hn::Lanes(d)) hn::Store(hn::Load(d, from.v + i), d, to.v + i);
}

/// CentroidBounds of both sides, without a branch and, where a vector holds all axes, without a store.
template <class R> class Sides {
    using D = hn::CappedTag<R, 4>;
    using V = hn::Vec<D>;
    static constexpr bool kWhole = sizeof(V) == 4 * sizeof(R);

  public:
    HWY_INLINE HWY_ATTR Sides() {
        if constexpr (kWhole) low_[0] = low_[1] = hn::Set(D(), inf()), high_[0] = high_[1] = hn::Set(D(), -inf());
    }
    HWY_INLINE HWY_ATTR void add(const BvhReference<R>& reference, R place, R bin) {
        const D d;
        if constexpr (kWhole) {
            const V c = hn::Sub(hn::Load(d, reference.v + 4), hn::Load(d, reference.v));
            const auto right = hn::Ge(hn::Set(d, place), hn::Set(d, bin));
            low_[0] = hn::Min(hn::IfThenElse(right, hn::Set(d, inf()), c), low_[0]), high_[0] = hn::Max(hn::IfThenElse(right, hn::Set(d, -inf()), c), high_[0]);
            low_[1] = hn::Min(hn::IfThenElse(right, c, hn::Set(d, inf())), low_[1]), high_[1] = hn::Max(hn::IfThenElse(right, c, hn::Set(d, -inf())), high_[1]);
        } else {
            extend<R>(stored_[place >= bin], reference);
        }
    }
    HWY_INLINE HWY_ATTR CentroidBounds<R> side(size_t i) {
        if constexpr (kWhole) hn::Store(low_[i], D(), stored_[i].low), hn::Store(high_[i], D(), stored_[i].high);
        return stored_[i];
    }

  private:
    static constexpr R inf() { return std::numeric_limits<R>::infinity(); }

    V low_[2], high_[2];
    CentroidBounds<R> stored_[2];
};

/// Other threads write behind both sides, so that nothing is written twice here.
template <class R>
HWY_ATTR void scatter(std::span<const BvhReference<R>> references, BvhReference<R>* lefts, BvhReference<R>* rights, const CentroidMap<R>& map, int axis, int bin, CentroidBounds<R>& left,
                      CentroidBounds<R>& right) {
    Sides<R> sides;
    const R low = map.low[axis], scale = map.scale[axis], first_right = R(bin);
    for (const BvhReference<R>& at : references) {
        const R place = (at.centroid(axis) - low) * scale;   // at least so much as `bin` just where CentroidMap::bin is
        const bool is_right = place >= first_right;
        sides.add(at, place, first_right);
        copy(at, *(is_right ? rights : lefts));
        lefts += !is_right, rights += is_right;
    }
    left = sides.side(0), right = sides.side(1);
}

template <class R> constexpr BinningPasses<R> passes() { return {bound<R>, fill_bins<R>, scatter<R>}; }

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

template <class R> constexpr IsaRow<BinningPasses<R>> kPasses[] = {ALIDADE_ISA_ROWS(HWY_NAMESPACE::passes<R>(), passes<R>())};

}  // namespace

template <> const BinningPasses<float>& binning_passes<float>(Isa isa) { return chosen(kPasses<float>, isa); }
template <> const BinningPasses<double>& binning_passes<double>(Isa isa) { return chosen(kPasses<double>, isa); }

}  // namespace alidade

#endif
