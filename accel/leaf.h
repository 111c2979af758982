// SPDX-License-Identifier: Apache-2.0
/// What a structure may know of the primitives: a Source while it is built, a Leaf while it is traversed.
#pragma once

#include "accel/local_ray.h"
#include "accel/stats.h"

#include <concepts>
#include <span>
#include <vector>

namespace alidade {

/// Fills a place in the order of references where no primitive is.
inline constexpr uint32_t kPadding = kNoId;

/// bounded: goes into the structure; unbounded: is tested by every ray; removed: can never be hit, reported; empty: has no points, dropped.
enum class PrimitiveKind { bounded, unbounded, removed, empty };

/// The primitives as a builder sees them. Ids run from 0 to size() - 1. bounds(id) is meant for bounded ones.
template <class S>
concept PrimitiveSource = requires(const S& source, uint32_t id, const Bounds& box) {
    { source.size() } -> std::convertible_to<size_t>;
    { source.kind(id) } -> std::same_as<PrimitiveKind>;
    { source.bounds(id) } -> std::same_as<Bounds>;
    /// A box of the part of the primitive in `box`: may be larger; empty only if nothing of it is there.
    { source.clipped_bounds(id, box) } -> std::same_as<Bounds>;
};

/// The bounds of a primitive, which R holds exactly.
template <class R, class Source> BoundsT<R> box_of(const Source& source, uint32_t id) {
    if constexpr (requires { { source.box(id) } -> std::same_as<BoundsT<R>>; }) {
        return source.box(id);
    } else {
        const Bounds box = source.bounds(id);
        return {Vec3T<R>(box.min), Vec3T<R>(box.max)};
    }
}

/// Primitives packed in the order that the structure wants; `first` and `count` below are places in that order. A Probe is what a leaf makes of a ray, once.
///
/// - `Real`: the type of node coordinates. `kBlock`: references that one test handles at once; leaves cost by started blocks.
/// - `kEntry`: of its local rays, whose hits are those that it finds, see local_ray().
/// - `closest` replaces `hit` by the first hit in the range that comes before it; `any` is true if there is one; `all` appends all.
template <class L>
concept LeafKind = PrimitiveSource<typename L::Source> &&
    requires(const L& leaf, const typename L::Probe& probe, uint32_t place, Hit& hit, std::vector<Hit>& hits, WorkCounters& work) {
        typename L::Real;
        { L::kBlock } -> std::convertible_to<uint32_t>;
        { L::kEntry } -> std::convertible_to<RayEntry>;
        { leaf.closest(probe, place, place, hit, work) } -> std::same_as<bool>;
        { leaf.any(probe, place, place, work) } -> std::same_as<bool>;
        leaf.all(probe, place, place, hits, work);
        { leaf.bytes() } -> std::same_as<size_t>;
    };

/// What a builder is given: which primitives to put into a structure, and the list that receives them in the order of traversal. Places count
/// from the start of the list, which may already hold primitives that are not the structure's.
template <class Source> struct BuildInput {
    const Source& source;
    std::vector<uint32_t> ids;         ///< bounded, not removed
    Bounds bounds;                     ///< of all of them
    std::vector<uint32_t>& order;

    /// The mean extent of the primitives, by which cells are shaped: stretched meshes want stretched cells. Never less than if the primitives stood
    /// beside each other on a surface, and 1 along an axis without extent.
    Vec3 typical_extent() const {
        const Vec3 extent = bounds.extent();
        Vec3 sum(0);
        for (const uint32_t id : ids) sum += source.bounds(id).extent();
        for (int a = 0; a < 3; ++a) {
            const double count = double(ids.size());
            sum[a] = extent[a] > 0 ? std::max(sum[a] / count, extent[a] / std::sqrt(count)) : 1;
        }
        return sum;
    }
};

}  // namespace alidade
