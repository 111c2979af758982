// SPDX-License-Identifier: Apache-2.0
/// Builds the tree of a BVH: binned surface area heuristic, top down.
#pragma once

#include "accel/bvh/binning.h"
#include "core/huge_pages.h"

#include <cstdint>
#include <vector>

namespace alidade {

template <class R> struct BvhNode {
    BoundsT<R> box;
    uint32_t first = 0;   ///< a leaf's first place in the order, or the first of two neighbouring children
    uint32_t count = 0;   ///< of references; 0 for inner nodes

    bool leaf() const { return count > 0; }
};

/// Half the surface, in double: that of boxes 2^120 wide does not fit float.
template <class R> double area(const BoundsT<R>& box) { return Bounds{Vec3(box.min), Vec3(box.max)}.half_area(); }

struct BvhLimits {
    uint32_t block = 1;      ///< references that one leaf test handles at once; leaves start at multiples of it
    uint32_t max_leaf = 1;
    Isa isa = Isa::best;     ///< changes no result
};

/// No node is deeper than this: below kSahDepth ranges are halved, and there are fewer than 2^32 references.
inline constexpr uint32_t kSahDepth = 60, kBvhDepth = kSahDepth + 32;

/// The nodes, the root first, children after parents, in depth-first order of pairs; none for no references. Appends the ids to `order` leaf by leaf, padded to blocks.
///
/// Method   Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007. Leaves cost by started blocks.
template <class R>
LargeVector<BvhNode<R>> build_bvh(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats);

extern template LargeVector<BvhNode<float>> build_bvh(LargeVector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&);
extern template LargeVector<BvhNode<double>> build_bvh(LargeVector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&);

}  // namespace alidade
