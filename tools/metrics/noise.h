// SPDX-License-Identifier: Apache-2.0
/// Is a difference noise? A test of tile means.
#pragma once

#include "tools/metrics/metric.h"

namespace alidade {

/// Under the hypothesis that both pictures show the same and differ by noise that is independent from pixel to pixel, the mean difference of a tile's
/// channel over its standard error has Student's distribution.
struct Noise {
    double largest_z = 0;   ///< of all tiles of 16 x 16 pixels (at the ends up to 31) and channels, turned into a normal deviate
    double limit = 0;       ///< that 1 % of such pairs exceed: Sidak's correction for the number of tests
};

/// What is left over at the right and at the bottom belongs to the last tiles; tiles of less than 8 pixels that count are left out, and if all are, a difference is not
/// noise: nobody can know. Means alone are seen: a pattern that leaves them as they are is not found. A tile whose pixels all differ by one and the same value is infinitely far from noise.
Noise measure_noise(const PicturePair& pair);

}  // namespace alidade
