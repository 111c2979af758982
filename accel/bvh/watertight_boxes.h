// SPDX-License-Identifier: Apache-2.0
/// The boxes of a wide tree for TriangleTest::watertight: what its corners may be off by that grows with their own coordinates is added once, so that a ray need only pad its origin.
#pragma once

#include "accel/bvh/wide_nodes.h"
#include "accel/triangles/triangle_leaf.h"
#include "core/parallel.h"

#include <algorithm>
#include <vector>

namespace alidade {

template <class Leaf> inline constexpr bool is_watertight = false;
template <class R, class Blocks> inline constexpr bool is_watertight<TriangleLeaf<R, TriangleTest::watertight, Blocks>> = true;

/// Widens a box of triangles whose largest coordinate is `largest`.
template <class R> BoundsT<R> watertight_box(const BoundsT<R>& box, R largest) {
    const Vec3T<R> pad(watertight_box_pad(largest));
    return {box.min - pad, box.max + pad};
}

/// Widens all boxes. `largest(block, count)`: the largest coordinate of the triangles of a leaf, those parts that were cut off too. Children must have larger numbers than their parents. The same bits
/// for any number of threads.
template <class R, class Largest> void make_watertight(std::span<WideNode<R>> nodes, int threads, const Largest& largest) {
    std::vector<R> largest_below(nodes.size());
    const auto widen = [&](size_t n, uint32_t place, R below) {
        set_box(nodes[n], place, watertight_box(box_at(nodes[n], place), below));
        largest_below[n] = std::max(largest_below[n], below);
    };
    for_ranges(nodes.size(), threads, [&](size_t first, size_t end) {
        for (size_t n = first; n < end; ++n) {
            for (uint32_t i = 0; i < kWide; ++i) {
                const uint32_t child = nodes[n].child[i];
                if (WideLeaf::is(child) && !vacant(nodes[n], i)) widen(n, i, largest(WideLeaf::block(child), WideLeaf::count(child)));
            }
        }
    });
    for (size_t n = nodes.size(); n-- > 0;) {
        for (uint32_t i = 0; i < kWide; ++i)
            if (!WideLeaf::is(nodes[n].child[i])) widen(n, i, largest_below[nodes[n].child[i]]);
    }
}

/// The same of a tree whose leaves are numbered by their places in `order`.
template <class R> void make_watertight(std::span<WideNode<R>> nodes, int threads, const TriangleSource<R>& source, const std::vector<uint32_t>& order) {
    make_watertight(nodes, threads, [&](uint32_t block, uint32_t count) {
        R most = 0;
        for (uint32_t place = block * kLanes; place < block * kLanes + count; ++place) most = std::max(most, largest_coordinate(source.box(order[place])));
        return most;
    });
}

/// The same of packed leaves.
template <class R> void make_watertight(std::span<WideNode<R>> nodes, int threads, std::span<const TriangleBlock<R>> blocks) {
    make_watertight(nodes, threads, [&](uint32_t block, uint32_t count) {
        R most = 0;
        for (const auto& coordinate : blocks[block].v)
            for (uint32_t lane = 0; lane < count; ++lane) most = std::max(most, std::abs(coordinate[lane]));
        return most;
    });
}

}  // namespace alidade
