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
    std::array<uint32_t, 3 * kLanes> vertex;
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

/// Marks of blocks that are to be made.
enum : uint8_t { kBoxed, kStepped, kCornered };
/// Blocks for each node, about as many as trees have.
constexpr size_t kBlocksOfNode = 4;
/// Units that are there to be read.
constexpr size_t kBehind = 2;

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
            Unit* const at = &units_[numbers_[b]];
            const uint8_t kind = at->bytes[0];
            const uint32_t count = (b + 1 < numbers_.size() ? numbers_[b + 1] : uint32_t(units_.size() - kBehind)) - numbers_[b];
            std::memset(static_cast<void*>(at), 0, count * sizeof(Unit));
            const std::span<const uint32_t> ids = ids_of(order, b);
            if (kind == kBoxed) make_boxes(at, ids, watertight);
            else if (kind == kStepped) (::new (static_cast<void*>(at)) SteppedBlock(mesh(), ids))->fill(mesh(), ids);
            else make_corners(at, ids);
        }
    });
}

struct NumberedBlocks::Way {
    uint8_t units : 7, stepped : 1;
};

NumberedBlocks::Way NumberedBlocks::way_of(std::span<const uint32_t> ids) const {
    Vertices own;
    for (const uint32_t id : ids)
        for (int corner = 0; corner < 3; ++corner) own.add(uint32_t(mesh().triangles[id][corner]));
    const uint32_t cornered = units(CorneredBlock::bytes(own.count));
    if (own.count <= kLanes) return {uint8_t(cornered & 127), 0};   // one vector of vertices: read at once
    const uint32_t stepped = units(SteppedBlock(mesh(), ids).bytes());
    const bool shorter = own.count > CorneredBlock::kMost || stepped < cornered;
    return {uint8_t((shorter ? stepped : cornered) & 127), shorter};
}

/// Numbers the blocks, and marks what they have.
void NumberedBlocks::lay_out(const std::vector<uint32_t>& order, int threads, size_t room) {
    constexpr size_t kMost = (SteppedBlock::kMostBytes + sizeof(Unit) - 1) / sizeof(Unit);
    static_assert(kMost < 128 && CorneredBlock::bytes(CorneredBlock::kMost) <= SteppedBlock::kMostBytes);
    std::vector<Way> ways(numbers_.size(), Way{kMost, 0});
    if (room > 0) {
        for_ranges(numbers_.size(), threads, [&](size_t first, size_t end) {
            for (size_t b = first; b < end; ++b) ways[b] = way_of(ids_of(order, b));
        });
    }
    std::array<size_t, kMost + 1> with{}, kept{}, seen{};   // blocks of such a size
    for (const Way way : ways) ++with[way.units];
    const size_t of_boxes = units(sizeof(CompactNode));
    room -= std::min(room, numbers_.size() * sizeof(CompactNode) / kBlocksOfNode);   // for the nodes above: where triangles are in several blocks, there are more of both
    size_t all = numbers_.size() * of_boxes;
    for (size_t own = 1; own <= kMost && all * sizeof(Unit) <= room; ++own) {
        kept[own] = own <= of_boxes ? with[own] : std::min(with[own], (room / sizeof(Unit) - all) / (own - of_boxes));
        all = all - kept[own] * of_boxes + kept[own] * own;
        if (kept[own] < with[own]) break;
    }
    units_.resize(all + kBehind);
    std::memset(static_cast<void*>(&units_[all]), 0, kBehind * sizeof(Unit));
    uint32_t next = 0;
    for (size_t b = 0; b < numbers_.size(); ++b) {
        const size_t size = ways[b].units, number = seen[size]++;
        const bool boxed = number * kept[size] / with[size] == (number + 1) * kept[size] / with[size];   // evenly spread
        numbers_[b] = next, units_[next].bytes[0] = boxed ? kBoxed : ways[b].stepped ? kStepped : kCornered;
        next += boxed ? uint32_t(of_boxes) : uint32_t(size);
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
    if (has_boxes(number)) lanes &= boxes(number).places();
    else if (is_stepped(number)) lanes &= (1u << stepped(number).count) - 1;
    for (uint32_t lane = 0; lane < kLanes; ++lane)
        if (lanes >> lane & 1) pack(corners(number * kLanes + lane), id(number * kLanes + lane), block, lane);
    return block;
}

}  // namespace alidade
