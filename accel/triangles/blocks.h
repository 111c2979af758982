// SPDX-License-Identifier: Apache-2.0
/// Where the leaves' triangles are kept, by eights in the order of traversal.
#pragma once

#include "accel/triangles/edge_filter.h"
#include "accel/triangles/triangle_source.h"
#include "core/huge_pages.h"
#include "core/parallel.h"

#include <algorithm>

namespace alidade {

/// A triangle's corners and number in a lane of a block.
template <class R> void pack(const Corners& corners, uint32_t id, TriangleBlock<R>& block, size_t lane) {
    for (int i = 0; i < 9; ++i) block.v[i][lane] = R(corners[size_t(i / 3)][i % 3]);
    block.id[lane] = id;
}

/// All that a test reads: no index, no vertex array. `order` has kPadding where no triangle is.
template <class R> class PackedBlocks {
  public:
    PackedBlocks(const TriangleSource<R>& source, const std::vector<uint32_t>& order, int threads) : blocks_((order.size() + kLanes - 1) / kLanes) {
        for_ranges(blocks_.size(), threads, [&](size_t first, size_t end) {
            for (size_t b = first; b < end; ++b) {
                blocks_[b] = {};   // where no triangle is, filters read zeros
                for (size_t place = b * kLanes; place < std::min(order.size(), (b + 1) * kLanes); ++place)
                    if (order[place] != kPadding) pack(source.corners(order[place]), order[place], blocks_[b], place % kLanes);
            }
        });
    }

    const TriangleBlock<R>& operator[](uint32_t number) const { return blocks_[number]; }
    const TriangleBlock<R>& block(uint32_t number, uint32_t) const { return blocks_[number]; }
    Corners corners(uint32_t place) const { return blocks_[place / kLanes].corners(place % kLanes); }
    size_t bytes() const { return blocks_.capacity() * sizeof(TriangleBlock<R>); }

  private:
    LargeVector<TriangleBlock<R>> blocks_;
};

/// Which of them a structure of triangles in R has.
template <template <class> class Structure, class R> struct BlocksOf {
    using Type = PackedBlocks<R>;
};

}  // namespace alidade
