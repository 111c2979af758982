// SPDX-License-Identifier: Apache-2.0
/// What the metrics of single pixels share.
#pragma once

#include "tools/metrics/metric.h"

#include <cmath>

namespace alidade {

/// Calls `see(reference, test, channel)` for each value of each pixel that counts, alpha included, row by row.
template <class See>
void for_each_value(const PicturePair& pair, See&& see) {
    const size_t channels = size_t(pair.reference.channels);
    for (size_t p = 0; p < pair.pixels(); ++p) {
        if (!pair.counts[p]) continue;
        for (size_t c = 0; c < channels; ++c) see(double(pair.reference.values[p * channels + c]), double(pair.test.values[p * channels + c]), c);
    }
}

/// How many pixels count.
size_t counted(const PicturePair& pair);

/// One a pixel: the largest |test - reference| of its channels, alpha included; 0 where it does not count.
std::vector<float> pixel_differences(const PicturePair& pair);

/// `steps` of 255, and a little more: a difference of just as many 8-bit steps is not over it, however it was rounded.
inline double over_steps(double steps) { return (steps + 0.001) / 255; }

/// The share of the pixels that count whose difference is over `steps` of 255.
Measured measure_over(const PicturePair& pair, double steps);

}  // namespace alidade
