// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace alidade::pov {

/// Truncates, as the processor's conversion does that POV-Ray relies on: what does not fit (and NaN) becomes the least int.
inline int32_t to_int(double x) {
    return x > -2147483649.0 && x < 2147483648.0 ? int32_t(x) : std::numeric_limits<int32_t>::min();
}

}  // namespace alidade::pov
