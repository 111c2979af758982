// SPDX-License-Identifier: Apache-2.0
/// Where a point lies in the lattice of POV-Ray's noise, and what the corners of its cell are. Inline in all that is made of it, for whatever instructions.
#pragma once

#include "core/vec.h"
#include "eval/noise/hash.h"
#include "eval/noise/lattice_values.h"

#include <bit>

namespace alidade {

/// The low 8 bits of kLatticeHash, which say what a corner has.
inline constexpr std::array<uint8_t, 8192> kCornerHash = [] {
    std::array<uint8_t, 8192> h{};
    for (size_t i = 0; i < h.size(); ++i) h[i] = uint8_t(kLatticeHash[i] & 255u);
    return h;
}();

/// The cell of a coordinate, and where in it the coordinate is. A negative integer belongs to the cell below it, up to 1e-10.
struct LatticePlace {
    double offset;
    unsigned index;

    [[gnu::always_inline]] explicit LatticePlace(double x) {
        const auto negative = uint64_t(int64_t(std::bit_cast<uint64_t>(x)) >> 63);   // all bits or none: half of all coordinates are, and no branch foresees which
        const int32_t cell = truncated(x - std::bit_cast<double>(negative & std::bit_cast<uint64_t>(1 - 1e-10)));
        offset = x - cell;
        index = (uint32_t(cell) + 10000u) & 4095u;
    }
};

/// The eight corners of the cell at these indices; bit 0 of a corner: x, bit 1: y, bit 2: z.
[[gnu::always_inline]] inline void hash_corners(unsigned x, unsigned y, unsigned z, unsigned* hash) {
    const auto& h = kLatticeHash;
    const unsigned x0 = h[x], x1 = h[x + 1];
    const unsigned columns[4] = {h[x0 ^ y], h[x1 ^ y], h[x0 ^ (y + 1)], h[x1 ^ (y + 1)]};
    for (int i = 0; i < 4; ++i) {
        hash[i] = kCornerHash[columns[i] ^ z];
        hash[i + 4] = kCornerHash[columns[i] ^ (z + 1)];
    }
}

/// What the eight corners around a point are: their hashes, and where the point is between them.
struct LatticeCell {
    LatticePlace x, y, z;
    unsigned hash[8];   ///< of hash_corners()

    [[gnu::always_inline]] explicit LatticeCell(const Vec3& p) : x(p.x), y(p.y), z(p.z) { hash_corners(x.index, y.index, z.index, hash); }
};

/// Value and gradient at a lattice point, side by side.
struct alignas(32) LatticeCorner {
    double value, gx, gy, gz;
};

inline constexpr std::array<LatticeCorner, 264> kLatticeCorners = [] {
    std::array<LatticeCorner, 264> all{};
    for (size_t m = 0; m < all.size(); ++m) all[m] = {kLatticeValues[m] * 0.5, kLatticeValues[m + 1], kLatticeValues[m + 2], kLatticeValues[m + 3]};
    return all;
}();

}  // namespace alidade
