// SPDX-License-Identifier: Apache-2.0
/// Planes of eight boxes in a byte each: steps on a grid of their own.
#pragma once

#include <bit>
#include <cstdint>

namespace alidade {

/// Along each axis 256 planes, the first through `origin`, at distances that are powers of two. They are rounded to float, which keeps their order.
struct ByteGrid {
    static constexpr uint32_t kSteps = 255;

    uint8_t exponent[3];   ///< of a step's size, as floats keep it
    uint8_t places;        ///< bit i: there is a box i
    float origin[3];

    float step(int axis) const { return std::bit_cast<float>(uint32_t(exponent[axis]) << 23); }
    /// The product is exact, as a step is a power of two: fused or not, one rounding.
    float plane(int axis, uint32_t count) const { return origin[axis] + float(count) * step(axis); }

    /// The finest grid along the axis that begins at `low` and reaches to `high`, or beyond.
    void lay(int axis, float low, float high);
    /// The last plane that is not above `x`, which is between those ends, and the first that is not below it.
    uint8_t below(int axis, float x) const;
    uint8_t above(int axis, float x) const;
};
static_assert(sizeof(ByteGrid) == 16);

}  // namespace alidade
