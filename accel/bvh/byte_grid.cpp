// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/byte_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alidade {

void ByteGrid::lay(int axis, float low, float high) {
    origin[axis] = low;
    const double wanted = (double(high) - double(low)) / kSteps;
    exponent[axis] = uint8_t(std::ilogb(std::max(wanted, double(std::numeric_limits<float>::min()))) + 127);
    while (plane(axis, kSteps) < high) ++exponent[axis];
}

uint8_t ByteGrid::below(int axis, float x) const {
    auto count = uint32_t(std::min((double(x) - double(origin[axis])) / double(step(axis)), double(kSteps)));
    while (plane(axis, count) > x) --count;
    while (count < kSteps && plane(axis, count + 1) <= x) ++count;
    return uint8_t(count);
}

uint8_t ByteGrid::above(int axis, float x) const {
    const uint32_t count = below(axis, x);
    return uint8_t(plane(axis, count) < x ? count + 1 : count);
}

}  // namespace alidade
