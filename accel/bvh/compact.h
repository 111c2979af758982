// SPDX-License-Identifier: Apache-2.0
/// The BVH of triangles in little memory: planes of a byte, down to the boxes of single triangles, and triangles by their numbers.
#pragma once

#include "accel/bvh/byte_grid.h"
#include "accel/bvh/stepped_block.h"
#include "accel/bvh/wide.h"
#include "accel/bvh/watertight_boxes.h"

#include <cstddef>
#include <span>
#include <vector>

namespace alidade {

/// A WideNode whose planes are those of a grid, outward: what is tested holds the exact boxes.
struct alignas(16) CompactNode {
    using Real = float;

    ByteGrid grid;
    uint8_t steps[6][kWide];   ///< as WideNode::planes
    uint32_t child[kWide];     ///< as of a WideNode

    uint32_t places() const { return grid.places; }
    float plane(uint32_t side, uint32_t i) const { return grid.plane(int(side / 2), steps[side][i]); }
};
static_assert(sizeof(CompactNode) == 96);

CompactNode compacted(const WideNode<float>& node);
/// The same tree.
LargeVector<CompactNode> compacted(const LargeVector<WideNode<float>>& nodes, int threads = 1);

/// Eight triangles whose corners follow: each once, for all triangles around it, so that meshes take half of what three corners a triangle do. Read where a ray meets the leaf, and nothing else.
struct alignas(16) CorneredBlock {
    static constexpr uint32_t kMost = 2 * kLanes;   ///< more take less room as steps

    uint8_t none[4];             ///< 0, where a CompactNode has its places, and a SteppedBlock exponents
    uint8_t vertices;
    uint8_t unused[3];
    uint8_t corner[3][kLanes];   ///< which of the vertices
    uint32_t id[kLanes];

    /// Of an axis, one after the other; those of the next axis follow.
    const float* coordinates(int axis) const { return reinterpret_cast<const float*>(this + 1) + size_t(axis) * vertices; }
    float* coordinates(int axis) { return reinterpret_cast<float*>(this + 1) + size_t(axis) * vertices; }
    Corners corners(uint32_t lane) const {
        Corners c;
        for (size_t i = 0; i < 3; ++i) c[i] = {double(coordinates(0)[corner[i][lane]]), double(coordinates(1)[corner[i][lane]]), double(coordinates(2)[corner[i][lane]])};
        return c;
    }
    static constexpr size_t bytes(uint32_t vertices) { return sizeof(CorneredBlock) + size_t(vertices) * 3 * sizeof(float); }
};
static_assert(sizeof(CorneredBlock) == 64 && offsetof(CorneredBlock, none) == 0 && offsetof(ByteGrid, exponent) == 0 && offsetof(ByteGrid, places) == 3);

/// Triangles by the number, each block either with its corners, in the shorter of two ways, or with the boxes of its triangles: then only those whose boxes a ray enters are read from the caller's arrays, which must live as long.
///
/// Corners are kept of as many blocks as there is room for, those that take the least first; if not of all that take as much, then of some all over the tree.
class NumberedBlocks {
  public:
    /// Bytes that blocks may take where corners are kept: of a large mesh. A small one is near at hand itself, and instances of it have a structure of their own to pay for;
    /// of the largest (1.4e8 triangles) there would be more units than leaves can number.
    static size_t room(size_t triangles) { return triangles > kSmallMesh && kRoom * double(triangles) < double(WideLeaf::kMaxBlocks * sizeof(Unit)) ? size_t(kRoom * double(triangles)) : 0; }

    NumberedBlocks(const TriangleSource<float>& source, const std::vector<uint32_t>& order, int threads, bool watertight = false) : NumberedBlocks(source, order, threads, watertight, room(source.size())) {}
    NumberedBlocks(const TriangleSource<float>& source, const std::vector<uint32_t>& order, int threads, bool watertight, size_t room);

    /// The number of the block that begins at that place of the order, divided by eight. Until forget_order().
    uint32_t number(uint32_t block) const { return numbers_[block]; }
    void forget_order() { numbers_ = {}; }

    bool has_boxes(uint32_t number) const { return boxes(number).places() != 0; }
    /// The eight boxes of a block that has them. The children are triangles.
    const CompactNode& boxes(uint32_t number) const { return *reinterpret_cast<const CompactNode*>(&units_[number]); }
    /// Corners of the two kinds: is it a SteppedBlock?
    bool is_stepped(uint32_t number) const { return boxes(number).grid.exponent[0] != 0; }
    const CorneredBlock& cornered(uint32_t number) const { return *reinterpret_cast<const CorneredBlock*>(&units_[number]); }
    const SteppedBlock& stepped(uint32_t number) const { return *reinterpret_cast<const SteppedBlock*>(&units_[number]); }
    const void* address(uint32_t number) const { return &units_[number]; }
    uint32_t id(uint32_t place) const {
        const uint32_t number = place / kLanes, lane = place % kLanes;
        return has_boxes(number) ? boxes(number).child[lane] : is_stepped(number) ? stepped(number).id(lane) : cornered(number).id[lane];
    }
    Corners corners(uint32_t place) const {
        const uint32_t number = place / kLanes, lane = place % kLanes;
        return has_boxes(number) ? source_.corners(id(place)) : is_stepped(number) ? stepped(number).corners(lane) : cornered(number).corners(lane);
    }
    /// What a block of PackedBlocks has in `lanes`; zeros in the others.
    TriangleBlock<float> block(uint32_t number, uint32_t lanes) const;
    TriangleBlock<float> operator[](uint32_t number) const { return block(number, (1u << kLanes) - 1); }
    const TriangleView& mesh() const { return source_.mesh(); }
    size_t bytes() const { return units_.capacity() * sizeof(Unit); }

  private:
    static constexpr size_t kSmallMesh = size_t(1) << 15;
    static constexpr double kRoom = 30;   ///< bytes a triangle, with the nodes above

    struct alignas(16) Unit {
        unsigned char bytes[16];
    };
    static uint32_t units(size_t bytes) { return uint32_t((bytes + sizeof(Unit) - 1) / sizeof(Unit)); }
    struct Vertices;

    void lay_out(const std::vector<uint32_t>& order, int threads, size_t room);
    void make_boxes(Unit* at, std::span<const uint32_t> ids, bool watertight) const;
    void make_corners(Unit* at, std::span<const uint32_t> ids) const;
    /// How a block keeps its corners in the fewest units.
    struct Way;
    Way way_of(std::span<const uint32_t> ids) const;

    TriangleSource<float> source_;
    LargeVector<Unit> units_;         ///< a block begins at each number; behind the last there are some more, which vectors may read
    std::vector<uint32_t> numbers_;   ///< of each block of the order
};

template <TriangleTest test> using CompactTraversals = WideTraversals<CompactNode, TriangleLeaf<float, test, NumberedBlocks>>;
template <> const CompactTraversals<TriangleTest::exact>& wide_traversals(Isa isa);
template <> const CompactTraversals<TriangleTest::watertight>& wide_traversals(Isa isa);
template <> const CompactTraversals<TriangleTest::fast>& wide_traversals(Isa isa);

template <> WideBoxTest<CompactNode> wide_box_test(Isa isa);

}  // namespace alidade
