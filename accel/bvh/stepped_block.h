// SPDX-License-Identifier: Apache-2.0
/// Triangles whose corners are whole numbers of steps: the same floats in fewer bits, as those of neighbours differ in their last ones alone.
#pragma once

#include "accel/bvh/byte_grid.h"
#include "accel/triangles/triangle_source.h"

#include <array>
#include <bit>
#include <cstring>
#include <span>

namespace alidade {

/// Up to eight triangles, whose numbers follow: of each axis the coordinates of the first corners, of the second, of the third, then the triangles' numbers. Each list begins with a byte, and has a number of bits for each triangle.
///
/// A coordinate is ByteGrid::plane of its number, without any rounding: steps are a power of two that all differences between coordinates are multiples of. Where that would take more than kMostBits, as near 0, lists have the floats themselves.
struct SteppedBlock {
    static constexpr uint32_t kMostBits = 24;   ///< a float holds them, and 32 bits from any byte on have them whole
    static constexpr uint32_t kWhole = 32;      ///< bits of what is kept as it is

    ByteGrid grid;     ///< `places`: 0, where a CompactNode has what is never 0; `exponent`: not 0, where a CorneredBlock is
    uint8_t bits[4];   ///< of a coordinate along each axis, and of a triangle's number
    uint8_t count;     ///< of triangles

    size_t list_bytes(size_t which) const { return (size_t(count) * bits[which] + 7) / 8; }
    const uint8_t* list(size_t axis, size_t corner) const {
        const uint8_t* at = reinterpret_cast<const uint8_t*>(this) + kHead;
        for (size_t a = 0; a < axis; ++a) at += 3 * list_bytes(a);
        return at + corner * list_bytes(axis);
    }
    uint32_t id(uint32_t lane) const { return number(list(3, 0), 3, lane); }
    float coordinate(int axis, size_t corner, uint32_t lane) const {
        const uint32_t own = number(list(size_t(axis), corner), size_t(axis), lane);
        return bits[axis] == kWhole ? std::bit_cast<float>(own) : grid.plane(axis, own);
    }
    Corners corners(uint32_t lane) const {
        Corners c;
        for (size_t i = 0; i < 3; ++i) c[i] = {double(coordinate(0, i, lane)), double(coordinate(1, i, lane)), double(coordinate(2, i, lane))};
        return c;
    }
    size_t bytes() const { return kHead + 3 * (list_bytes(0) + list_bytes(1) + list_bytes(2)) + list_bytes(3); }

    /// Makes the head.
    SteppedBlock(const TriangleView& mesh, std::span<const uint32_t> ids);
    /// Writes the lists behind it, where there are zeros.
    void fill(const TriangleView& mesh, std::span<const uint32_t> ids);

  private:
    static constexpr size_t kHead = sizeof(ByteGrid) + 5;

  public:
    static constexpr size_t kMostBytes = kHead + 8 * (9 * kWhole + kWhole) / 8;

  private:
    /// The number of a lane; the eight bytes that have it may end behind the block.
    uint32_t number(const uint8_t* list, size_t which, uint32_t lane) const {
        const size_t bit = size_t(lane) * bits[which];
        uint64_t word;
        std::memcpy(&word, list + bit / 8, sizeof(word));
        return uint32_t(word >> bit % 8 & ((uint64_t(1) << bits[which]) - 1));
    }
};

/// Where eight numbers of so many bits stand, of which four are read with sixteen bytes from the list on, and four from the middle on: of each the bytes in its half, and how far it is to be shifted.
struct alignas(32) BitLanes {
    uint8_t bytes[8][4];
    uint32_t shift[8];
};
extern const std::array<BitLanes, SteppedBlock::kMostBits + 1> kBitLanes;   ///< [bits]

}  // namespace alidade
