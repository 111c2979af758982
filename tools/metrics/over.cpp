// SPDX-License-Identifier: Apache-2.0
/// The share of pixels that differ by more than so many 8-bit steps in any channel.
#include "tools/metrics/differences.h"

#include <algorithm>

namespace alidade {

Measured measure_over(const PicturePair& pair, double steps) {
    const std::vector<float> differences = pixel_differences(pair);
    const auto over = std::count_if(differences.begin(), differences.end(), [&](float difference) { return difference > over_steps(steps); });
    return {{{"value", double(over) / double(counted(pair))}, {"pixels", double(over)}}, {}};
}

Measured measure_over1(const PicturePair& pair) { return measure_over(pair, 1); }
Measured measure_over2(const PicturePair& pair) { return measure_over(pair, 2); }
Measured measure_over4(const PicturePair& pair) { return measure_over(pair, 4); }
Measured measure_over8(const PicturePair& pair) { return measure_over(pair, 8); }

}  // namespace alidade
