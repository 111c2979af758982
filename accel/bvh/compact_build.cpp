// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/compact.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

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

/// The vertices of a block, each once.
struct NumberedBlocks::Vertices {
    std::array<uint32_t, CorneredBlock::kMost> vertex;
    uint32_t count = 0;

    /// Its place.
    uint32_t add(uint32_t index) {
        for (uint32_t i = 0; i < count; ++i)
            if (vertex[i] == index) return i;
        vertex[count] = index;
        return count++;
    }
};

namespace {

/// The ids of a block, without padding.
std::span<const uint32_t> ids_of(const std::vector<uint32_t>& order, size_t block) {
    const size_t first = block * kLanes, end = std::min(order.size(), first + kLanes);
    const auto begin = order.begin() + std::ptrdiff_t(first);
    return {order.data() + first, size_t(std::find(begin, order.begin() + std::ptrdiff_t(end), kPadding) - begin)};
}

}  // namespace

NumberedBlocks::NumberedBlocks(const TriangleSource<float>& source, const std::vector<uint32_t>& order, int threads, bool watertight, size_t room) : source_(source), numbers_((order.size() + kLanes - 1) / kLanes) {
    lay_out(order, threads, room);
    for_ranges(numbers_.size(), threads, [&](size_t first, size_t end) {
        for (size_t b = first; b < end; ++b) {
            const bool boxed = units_[numbers_[b]].bytes[0] != 0;
            Unit* const at = &units_[numbers_[b]];
            const uint32_t count = (b + 1 < numbers_.size() ? numbers_[b + 1] : uint32_t(units_.size()) - 1) - numbers_[b];
            std::memset(static_cast<void*>(at), 0, count * sizeof(Unit));
            if (boxed) make_boxes(at, ids_of(order, b), watertight);
            else make_corners(at, ids_of(order, b));
        }
    });
}

/// Numbers the blocks, and marks those that have boxes.
void NumberedBlocks::lay_out(const std::vector<uint32_t>& order, int threads, size_t room) {
    std::vector<uint8_t> vertices(numbers_.size(), CorneredBlock::kMost);
    if (room > 0) {
        for_ranges(numbers_.size(), threads, [&](size_t first, size_t end) {
            for (size_t b = first; b < end; ++b) {
                Vertices own;
                for (const uint32_t id : ids_of(order, b))
                    for (int corner = 0; corner < 3; ++corner) own.add(uint32_t(mesh().triangles[id][corner]));
                vertices[b] = uint8_t(own.count);
            }
        });
    }
    std::array<size_t, CorneredBlock::kMost + 1> with{}, kept{}, seen{};   // blocks with so many vertices
    for (const uint8_t count : vertices) ++with[count];
    const size_t of_boxes = units(sizeof(CompactNode));
    room -= std::min(room, numbers_.size() * sizeof(CompactNode) / (kWide - 1));   // for the nodes above: where triangles are in several blocks, there are more of both
    size_t all = numbers_.size() * of_boxes;
    for (uint32_t count = 1; count <= CorneredBlock::kMost && all * sizeof(Unit) <= room; ++count) {
        const size_t own = units(CorneredBlock::bytes(count));
        kept[count] = own <= of_boxes ? with[count] : std::min(with[count], (room / sizeof(Unit) - all) / (own - of_boxes));
        all = all - kept[count] * of_boxes + kept[count] * own;
        if (kept[count] < with[count]) break;
    }
    units_.resize(all + 1);
    std::memset(static_cast<void*>(&units_[all]), 0, sizeof(Unit));
    uint32_t next = 0;
    for (size_t b = 0; b < numbers_.size(); ++b) {
        const size_t count = vertices[b], number = seen[count]++;
        const bool boxed = number * kept[count] / with[count] == (number + 1) * kept[count] / with[count];   // evenly spread
        numbers_[b] = next, units_[next].bytes[0] = boxed;
        next += boxed ? uint32_t(of_boxes) : units(CorneredBlock::bytes(uint32_t(count)));
    }
}

void NumberedBlocks::make_boxes(Unit* at, std::span<const uint32_t> ids, bool watertight) const {
    WideNode<float> node{};
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        const bool none = lane >= ids.size();
        const BoundsT<float> box = none ? BoundsT<float>() : source_.box(ids[lane]);
        node.set_box(lane, watertight && !none ? watertight_box(box, largest_coordinate(box)) : box);
        node.child[lane] = none ? 0 : ids[lane];
    }
    ::new (static_cast<void*>(at)) CompactNode(compacted(node));
}

void NumberedBlocks::make_corners(Unit* at, std::span<const uint32_t> ids) const {
    auto& block = *::new (static_cast<void*>(at)) CorneredBlock{};
    Vertices own;
    for (uint32_t lane = 0; lane < ids.size(); ++lane) {
        block.id[lane] = ids[lane];
        for (int corner = 0; corner < 3; ++corner) block.corner[corner][lane] = uint8_t(own.add(uint32_t(mesh().triangles[ids[lane]][corner])));
    }
    block.vertices = uint8_t(own.count);
    for (int axis = 0; axis < 3; ++axis)
        for (uint32_t i = 0; i < own.count; ++i) block.coordinates(axis)[i] = mesh().positions[own.vertex[i]][axis];
}

TriangleBlock<float> NumberedBlocks::block(uint32_t number, uint32_t lanes) const {
    TriangleBlock<float> block{};
    const bool boxed = has_boxes(number);
    if (boxed) lanes &= boxes(number).places();
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        if (!(lanes >> lane & 1)) continue;
        block.id[lane] = id(number * kLanes + lane);
        for (int i = 0; i < 9; ++i) {
            const auto corner = size_t(i / 3);
            const int axis = i % 3;
            block.v[i][lane] = boxed ? mesh().positions[mesh().triangles[block.id[lane]][int(corner)]][axis] : cornered(number).coordinates(axis)[cornered(number).corner[corner][lane]];
        }
    }
    return block;
}

}  // namespace alidade
