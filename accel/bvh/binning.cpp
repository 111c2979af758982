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

template <class R> HWY_ATTR void fill_bins(std::span<const BvhReference<R>> references, const CentroidMap<R>& map, Bins<R>& bins) {
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < map.count; ++b) bins.box[a][b] = BoxEnds<R>::none(), bins.count[a][b] = 0;
    }
    for (const BvhReference<R>& reference : references) {
        for (int a = 0; a < 3; ++a) {
            const int bin = map.bin(reference, a);
            extend<R>(bins.box[a][bin], reference), ++bins.count[a][bin];
        }
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

/// Without branches: each reference is written to both sides, and only the right one counts.
template <class R>
HWY_ATTR size_t partition(std::span<BvhReference<R>> references, BvhReference<R>* spare, const CentroidMap<R>& map, int axis, int bin, CentroidBounds<R>& left,
                          CentroidBounds<R>& right) {
    size_t lefts = 0, rights = 0;
    CentroidBounds<R> sides[2];
    for (const BvhReference<R>& at : references) {
        const bool is_right = map.bin(at, axis) >= bin;
        extend<R>(sides[is_right], at);
        copy(at, spare[lefts]), copy(at, references[rights]);
        lefts += !is_right, rights += is_right;
    }
    for (size_t i = 0; i < lefts; ++i) copy(spare[i], references[rights + i]);
    left = sides[0], right = sides[1];
    return rights;
}

/// Other threads write behind both sides, so that nothing is written twice here.
template <class R>
HWY_ATTR void scatter(std::span<const BvhReference<R>> references, BvhReference<R>* lefts, BvhReference<R>* rights, const CentroidMap<R>& map, int axis, int bin, CentroidBounds<R>& left,
                      CentroidBounds<R>& right) {
    BvhReference<R>* to[2] = {lefts, rights};
    CentroidBounds<R> sides[2];
    for (const BvhReference<R>& at : references) {
        const bool is_right = map.bin(at, axis) >= bin;
        extend<R>(sides[is_right], at);
        copy(at, *to[is_right]++);
    }
    left = sides[0], right = sides[1];
}

template <class R> constexpr BinningPasses<R> passes() { return {bound<R>, fill_bins<R>, partition<R>, scatter<R>}; }

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
