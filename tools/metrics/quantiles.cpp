// SPDX-License-Identifier: Apache-2.0
/// The difference that a share of the pixels does not exceed: p99 is blind to the worst hundredth, and the mean to small broken places.
#include "tools/metrics/differences.h"

namespace alidade {

Measured measure_percentiles(const PicturePair& pair) {
    std::vector<float> differences = pixel_differences(pair), seen;
    for (size_t p = 0; p < differences.size(); ++p)
        if (pair.counts[p]) seen.push_back(differences[p]);
    constexpr double kShares[] = {0.5, 0.95, 0.99, 0.999};
    const std::vector<double> values = percentiles(std::move(seen), kShares);
    return {{{"p50", values[0]}, {"p95", values[1]}, {"p99", values[2]}, {"p99.9", values[3]}}, {}};
}

}  // namespace alidade
