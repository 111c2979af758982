// SPDX-License-Identifier: Apache-2.0
/// Places on Hilbert's curve through a cube: as on Morton's each bit halves a box, but cells that follow each other are neighbours, so that stretches of it are in one piece.
#pragma once

#include <array>
#include <cstdint>

namespace alidade {

/// Method   Hamilton, "Compact Hilbert Indices", 2006: within a cell the curve is that of the whole, turned and mirrored. How, is a state; a table has for each of them what 512 cells are at once.
///          The last level, too fine to matter, stays as Morton has it.
class HilbertCurve {
  public:
    static constexpr int kLevels = 10;

    /// Of the cell whose coordinates' bits `morton` has in turns.
    [[gnu::always_inline]] static inline uint32_t place(uint32_t morton) {
        const uint32_t first = kSteps[morton >> 21], second = kSteps[(first & kState) | (morton >> 12 & kCells)], third = kSteps[(second & kState) | (morton >> 3 & kCells)];
        return (first & kCells) << 21 | (second & kCells) << 12 | (third & kCells) << 3 | (morton & 7);
    }

  private:
    /// Where the curve enters a cell, one of four corners, and the axis that it leaves along.
    static constexpr uint32_t kStates = 12, kCells = 511, kState = ~kCells;

    static constexpr uint32_t gray(uint32_t i) { return i ^ i >> 1; }
    static constexpr uint32_t turned_left(uint32_t bits, uint32_t by) { return (bits << by % 3 | bits >> (3 - by % 3)) & 7; }
    static constexpr uint32_t turned_right(uint32_t bits, uint32_t by) { return turned_left(bits, 3 - by % 3); }
    static constexpr uint32_t trailing_ones(uint32_t i) { return i & 1 ? 1 + trailing_ones(i >> 1) : 0; }

    /// Of one of the eight cells below: its place among them, and the state there.
    static constexpr std::array<uint32_t, 2> below(uint32_t state, uint32_t cell) {
        constexpr uint32_t corners[] = {0, 3, 5, 6};   // half of them are the others
        const uint32_t entry = corners[state / 3], axis = state % 3, at = turned_right(cell ^ entry, axis + 1);
        uint32_t place = 0;
        while (gray(place) != at) ++place;
        const uint32_t enters = place == 0 ? 0 : gray((place - 1) / 2 * 2), leaves = place == 0 ? 0 : trailing_ones(place - 1 + (place & 1)) % 3;
        return {place, (entry ^ turned_left(enters, axis + 1)) / 2 * 3 + (axis + leaves + 1) % 3};
    }
    static constexpr std::array<uint16_t, kStates * (kCells + 1)> steps() {
        std::array<std::array<uint32_t, 2>, kStates * 8> each{};
        for (uint32_t i = 0; i < each.size(); ++i) each[i] = below(i / 8, i % 8);
        std::array<uint16_t, kStates * (kCells + 1)> all{};
        for (uint32_t i = 0; i < all.size(); ++i) {
            uint32_t state = i >> 9, place = 0;
            for (int shift = 6; shift >= 0; shift -= 3) {
                const auto [own, next] = each[state * 8 + (i >> shift & 7)];
                place = place << 3 | own, state = next;
            }
            all[i] = uint16_t(state << 9 | place);
        }
        return all;
    }
    static const std::array<uint16_t, kStates * (kCells + 1)> kSteps;
};

inline constexpr std::array<uint16_t, HilbertCurve::kStates * (HilbertCurve::kCells + 1)> HilbertCurve::kSteps = HilbertCurve::steps();

}  // namespace alidade
