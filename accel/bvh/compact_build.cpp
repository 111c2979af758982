// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/compact.h"
#include "core/parallel.h"

#include <algorithm>

namespace alidade {

CompactNode compacted(const WideNode<float>& wide) {
    CompactNode node{};
    std::copy(std::begin(wide.child), std::end(wide.child), node.child);
    for (uint32_t i = 0; i < kWide; ++i) node.grid.places |= uint8_t((wide.planes[0][i] <= wide.planes[1][i]) << i);
    for (int a = 0; a < 3; ++a) {
        const float *const lows = wide.planes[2 * a], *const highs = wide.planes[2 * a + 1];
        node.grid.lay(a, *std::min_element(lows, lows + kWide), *std::max_element(highs, highs + kWide));   // empty boxes are of no account
        for (uint32_t i = 0; i < kWide; ++i) {
            if (node.places() >> i & 1) node.steps[2 * a][i] = node.grid.below(a, lows[i]), node.steps[2 * a + 1][i] = node.grid.above(a, highs[i]);
        }
    }
    return node;
}

LargeVector<CompactNode> compacted(const LargeVector<WideNode<float>>& nodes, int threads) {
    LargeVector<CompactNode> made(nodes.size());
    for_ranges(nodes.size(), threads, [&](size_t first, size_t end) {
        for (size_t i = first; i < end; ++i) made[i] = compacted(nodes[i]);
    });
    return made;
}

NumberedBlocks::NumberedBlocks(const TriangleSource<float>& source, const std::vector<uint32_t>& order, int threads, bool watertight) : source_(source), boxes_((order.size() + kLanes - 1) / kLanes) {
    for_ranges(boxes_.size(), threads, [&](size_t first, size_t end) {
        for (size_t b = first; b < end; ++b) {
            WideNode<float> node{};
            for (uint32_t lane = 0; lane < kLanes; ++lane) {
                const size_t place = b * kLanes + lane;
                const bool none = place >= order.size() || order[place] == kPadding;
                const BoundsT<float> box = none ? BoundsT<float>() : source.box(order[place]);
                node.set_box(lane, watertight && !none ? watertight_box(box, largest_coordinate(box)) : box);
                node.child[lane] = none ? 0 : order[place];
            }
            boxes_[b] = compacted(node);
        }
    });
}

TriangleBlock<float> NumberedBlocks::block(uint32_t number, uint32_t lanes) const {
    TriangleBlock<float> block{};
    for (uint32_t lane = 0; lane < kLanes; ++lane)
        if (lanes >> lane & 1) pack(corners(number * kLanes + lane), id(number * kLanes + lane), block, lane);
    return block;
}

}  // namespace alidade
