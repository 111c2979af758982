// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/stepped_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace alidade {

const std::array<BitLanes, SteppedBlock::kMostBits + 1> kBitLanes = [] {
    std::array<BitLanes, SteppedBlock::kMostBits + 1> all{};
    for (uint32_t bits = 0; bits < all.size(); ++bits)
        for (uint32_t lane = 0; lane < 8; ++lane) {
            const uint32_t bit = lane < 4 ? lane * bits : lane * bits - 4 * bits / 8 * 8;
            all[bits].shift[lane] = bit % 8;
            for (uint32_t i = 0; i < 4; ++i) all[bits].bytes[lane][i] = uint8_t(bit / 8 + i);
        }
    return all;
}();

namespace {

/// Along an axis: the first corners, the second, the third.
struct Coordinates {
    std::array<float, 24> at;
    size_t count = 0;

    Coordinates(const TriangleView& mesh, std::span<const uint32_t> ids, int axis) {
        for (int corner = 0; corner < 3; ++corner)
            for (const uint32_t id : ids) at[count++] = mesh.positions[size_t(mesh.triangles[id][corner])][axis];
    }
    std::span<const float> all() const { return std::span(at).first(count); }
};

/// How the coordinates of a block are kept along an axis.
struct Steps {
    float origin;
    int exponent;    ///< of a step
    uint32_t bits;
    std::array<uint32_t, 24> numbers;

    explicit Steps(std::span<const float> all) {
        const auto [least, most] = std::minmax_element(all.begin(), all.end());
        origin = *least;
        const double extent = double(*most) - double(origin);
        const int unit = extent > 0 ? std::ilogb(extent) - 52 : 0;
        std::array<uint64_t, 24> units;
        uint64_t any = 0;
        for (size_t i = 0; i < all.size(); ++i) any |= units[i] = uint64_t(std::ldexp(1.0, -unit) * (double(all[i]) - double(origin)));   // what is rounded here is none of these steps
        const int zeros = any ? std::countr_zero(any) : 0;
        exponent = unit + zeros, bits = uint32_t(std::bit_width(any >> zeros));
        for (size_t i = 0; i < all.size(); ++i) numbers[i] = uint32_t(units[i] >> zeros);
        if (bits > SteppedBlock::kMostBits || exponent < -126 || !stand_for(all)) keep(all);
    }

  private:
    /// Bit for bit: not for -0.
    bool stand_for(std::span<const float> all) const {
        const float step = std::ldexp(1.0f, exponent);
        for (size_t i = 0; i < all.size(); ++i)
            if (std::bit_cast<uint32_t>(origin + float(numbers[i]) * step) != std::bit_cast<uint32_t>(all[i])) return false;
        return true;
    }
    void keep(std::span<const float> all) {
        exponent = 0, bits = SteppedBlock::kWhole;
        for (size_t i = 0; i < all.size(); ++i) numbers[i] = std::bit_cast<uint32_t>(all[i]);
    }
};

/// The numbers of a list, one after the other.
void write(uint8_t* list, uint32_t bits, std::span<const uint32_t> numbers) {
    for (size_t i = 0; i < numbers.size(); ++i) {
        const size_t bit = i * bits;
        uint8_t* at = list + bit / 8;
        for (uint64_t rest = uint64_t(numbers[i]) << bit % 8; rest; rest >>= 8) *at++ |= uint8_t(rest);
    }
}

}  // namespace

SteppedBlock::SteppedBlock(const TriangleView& mesh, std::span<const uint32_t> ids) : grid{}, count(uint8_t(ids.size())) {
    const auto of_ids = uint32_t(std::bit_width(*std::max_element(ids.begin(), ids.end())));
    bits[3] = uint8_t(of_ids > kMostBits ? kWhole : of_ids);
    for (int axis = 0; axis < 3; ++axis) {
        const Steps steps(Coordinates(mesh, ids, axis).all());
        grid.origin[axis] = steps.origin, grid.exponent[axis] = uint8_t(steps.exponent + 127), bits[axis] = uint8_t(steps.bits);
    }
}

void SteppedBlock::fill(const TriangleView& mesh, std::span<const uint32_t> ids) {
    std::memset(reinterpret_cast<uint8_t*>(this) + kHead, 0, sizeof(SteppedBlock) - kHead);   // the lists begin in what pads the head, which nothing defines yet
    for (int axis = 0; axis < 3; ++axis) {
        const Steps steps(Coordinates(mesh, ids, axis).all());
        for (size_t corner = 0; corner < 3; ++corner) write(const_cast<uint8_t*>(list(size_t(axis), corner)), steps.bits, std::span(steps.numbers).subspan(corner * ids.size(), ids.size()));
    }
    write(const_cast<uint8_t*>(list(3, 0)), bits[3], ids);
}

}  // namespace alidade
