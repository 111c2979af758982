// SPDX-License-Identifier: Apache-2.0
/// Where the leaves' triangles are kept, by eights in the order of traversal.
#pragma once

#include "accel/triangles/edge_filter.h"
#include "accel/triangles/triangle_source.h"
#include "core/large_array.h"
#include "core/parallel.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace alidade {

/// A triangle's corners and number in a lane of a block.
template <class R> void pack(const Corners& corners, uint32_t id, TriangleBlock<R>& block, uint32_t lane) {
    block.put(corners, lane);
    block.id[lane] = id;
}

template <class R> void pack(const std::array<Vec3T<R>, 3>& corners, uint32_t id, TriangleBlock<R>& block, uint32_t lane)
    requires(std::is_same_v<R, float>)
{
    for (int i = 0; i < 9; ++i) block.v[i][lane] = corners[size_t(i / 3)][i % 3];
    block.id[lane] = id;
}

/// All that a test reads: no index, no vertex array. `order` has kPadding where no triangle is.
template <class R> class PackedBlocks {
  public:
    /// The last is for NumberedBlocks, which have boxes: these have none to widen.
    PackedBlocks(const TriangleSource<R>& source, const std::vector<uint32_t>& order, int threads, bool) : blocks_(packed(source, order, threads)) {}
    explicit PackedBlocks(LargeArray<TriangleBlock<R>> blocks) : blocks_(std::move(blocks)) {}

    const TriangleBlock<R>& operator[](uint32_t number) const { return blocks_[number]; }
    const void* address(uint32_t number) const { return &blocks_[number]; }
    const TriangleBlock<R>& block(uint32_t number, uint32_t) const { return blocks_[number]; }
    Corners corners(uint32_t place) const { return blocks_[place / kLanes].corners(place % kLanes); }
    uint32_t id(uint32_t place) const { return blocks_[place / kLanes].id[place % kLanes]; }
    std::span<const TriangleBlock<R>> view() const { return blocks_.view(); }
    std::span<TriangleBlock<R>> writable() { return blocks_.writable(); }
    size_t bytes() const { return blocks_.bytes(); }

  private:
    static LargeVector<TriangleBlock<R>> packed(const TriangleSource<R>& source, const std::vector<uint32_t>& order, int threads) {
        LargeVector<TriangleBlock<R>> blocks((order.size() + kLanes - 1) / kLanes);
        for_ranges(blocks.size(), threads, [&](size_t first, size_t end) {
            for (size_t b = first; b < end; ++b) {
                fetch_ahead(source, order, b);
                std::memset(static_cast<void*>(&blocks[b]), 0, sizeof(TriangleBlock<R>));   // where no triangle is, filters read zeros; the bytes between, too: they go to files
                for (size_t place = b * kLanes; place < std::min(order.size(), (b + 1) * kLanes); ++place)
                    if (order[place] != kPadding) pack(source.stored_corners(order[place]), order[place], blocks[b], uint32_t(place % kLanes));
            }
        });
        return blocks;
    }

    /// Begins to read the triangles of the fourth block from here, and the vertices of the second: they lie anywhere.
    static void fetch_ahead(const TriangleSource<R>& source, const std::vector<uint32_t>& order, size_t block) {
        const auto visit = [&](size_t number, const auto& fetch) {
            for (size_t place = number * kLanes; place < std::min(order.size(), (number + 1) * kLanes); ++place)
                if (order[place] != kPadding) fetch(order[place]);
        };
        visit(block + 4, [&](uint32_t id) { source.fetch_triangle(id); });
        visit(block + 2, [&](uint32_t id) { source.fetch_vertices(id); });
    }

    LargeArray<TriangleBlock<R>> blocks_;
};

/// Which of them a structure of triangles in R has.
template <template <class> class Structure, class R> struct BlocksOf {
    using Type = PackedBlocks<R>;
};

}  // namespace alidade
