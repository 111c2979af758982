// SPDX-License-Identifier: Apache-2.0
/// The BVH of triangles in little memory: planes of a byte, down to the boxes of single triangles, and triangles by their numbers.
#pragma once

#include "accel/bvh/byte_grid.h"
#include "accel/bvh/watertight_boxes.h"

namespace alidade {

/// A WideNode whose planes are those of a grid, outward: what is tested holds the exact boxes.
struct alignas(32) CompactNode {
    using Real = float;

    uint8_t steps[6][kWide];   ///< as WideNode::planes
    ByteGrid grid;
    uint32_t child[kWide];     ///< as of a WideNode

    uint32_t places() const { return grid.places; }
    float plane(uint32_t side, uint32_t i) const { return grid.plane(int(side / 2), steps[side][i]); }
};
static_assert(sizeof(CompactNode) == 96);

CompactNode compacted(const WideNode<float>& node);
/// The same tree.
LargeVector<CompactNode> compacted(const LargeVector<WideNode<float>>& nodes, int threads = 1);

/// Triangles by the number, with their boxes. Only those whose boxes a ray enters are read from the caller's arrays, which must live as long.
class NumberedBlocks {
  public:
    NumberedBlocks(const TriangleSource<float>& source, const std::vector<uint32_t>& order, int threads, bool watertight = false);

    /// The eight boxes of a block. The children are triangles.
    const CompactNode& boxes(uint32_t number) const { return boxes_[number]; }
    const void* address(uint32_t number) const { return &boxes_[number]; }
    uint32_t id(uint32_t place) const { return boxes_[place / kLanes].child[place % kLanes]; }
    Corners corners(uint32_t place) const { return source_.corners(id(place)); }
    /// What a block of PackedBlocks has in `lanes`; zeros in the others.
    TriangleBlock<float> block(uint32_t number, uint32_t lanes) const;
    TriangleBlock<float> operator[](uint32_t number) const { return block(number, boxes_[number].places()); }
    const TriangleView& mesh() const { return source_.mesh(); }
    size_t bytes() const { return boxes_.capacity() * sizeof(CompactNode); }

  private:
    TriangleSource<float> source_;
    LargeVector<CompactNode> boxes_;
};

template <TriangleTest test> using CompactTraversals = WideTraversals<CompactNode, TriangleLeaf<float, test, NumberedBlocks>>;
template <> const CompactTraversals<TriangleTest::exact>& wide_traversals(Isa isa);
template <> const CompactTraversals<TriangleTest::watertight>& wide_traversals(Isa isa);
template <> const CompactTraversals<TriangleTest::fast>& wide_traversals(Isa isa);

template <> WideBoxTest<CompactNode> wide_box_test(Isa isa);

}  // namespace alidade
