// SPDX-License-Identifier: Apache-2.0
/// Builds the tree of a BVH: binned surface area heuristic, top down.
#pragma once

#include "accel/bvh/spatial.h"
#include "core/huge_pages.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace alidade {

template <class R> struct BvhNode {
    BoundsT<R> box;
    uint32_t first = 0;   ///< a leaf's first place in the order, or the first of two neighbouring children
    uint32_t count = 0;   ///< of references; 0 for inner nodes

    bool leaf() const { return count > 0; }
};

/// No node is deeper than this: below kSahDepth ranges are halved, and there are fewer than 2^32 references.
inline constexpr uint32_t kSahDepth = 60, kBvhDepth = kSahDepth + 32;

struct BvhLimits {
    uint32_t block = 1;      ///< references that one leaf test handles at once; leaves start at multiples of it
    uint32_t max_leaf = 1;
    Isa isa = Isa::best;     ///< changes no result
    double growth = 0;       ///< by this part of their number references may become more through spatial splits; 0: no such splits
    int threads = 1;         ///< changes no result
    uint32_t sah_depth = kSahDepth;   ///< below it ranges are halved
    double plane_favour = 1; ///< what a spatial split may cost, of what the cheapest division of whole references does
};

/// Foretells where spatial splits pay: where the largest reference has more than kLargeReference / sqrt(count) of a node's area. Of triangles side by side on a surface each has about
/// 1 / count, of scattered ones count^(-2/3). Long rotated ones, and a few large ones across many small, have a good part of the node however many there are. Trying it everywhere makes no
/// better trees in the generated scenes, and asking costs nothing: bins tell the largest.
inline constexpr double kLargeReference = 4;
inline bool spatial_splits_promise(uint32_t count, double largest, double area) { return largest * largest * std::sqrt(double(count)) > kLargeReference * area; }

/// The nodes, the root first, children after parents, in depth-first order of pairs; none for no references. Appends the ids to `order` leaf by leaf, padded to blocks.
///
/// Method   Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007. Leaves cost by started blocks. If the references are of `triangles`, nodes may be split in space
///          (bvh/spatial.h) where that is cheaper, or nearly so (plane_favour): then an id may be in several leaves, never twice in one.
template <class R>
LargeVector<BvhNode<R>> build_bvh(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats,
                                  const TriangleSource<R>* triangles = nullptr);

extern template LargeVector<BvhNode<float>> build_bvh(LargeVector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<float>*);
extern template LargeVector<BvhNode<double>> build_bvh(LargeVector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<double>*);

}  // namespace alidade
