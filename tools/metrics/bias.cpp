// SPDX-License-Identifier: Apache-2.0
/// The signed mean of test - reference: the whole picture's largest by size, and each channel's.
#include "tools/metrics/differences.h"

#include <array>

namespace alidade {

Measured measure_bias(const PicturePair& pair) {
    std::array<double, 4> sums{};
    for_each_value(pair, [&](double reference, double test, size_t channel) { sums[channel] += test - reference; });
    Measured out{{{"value", 0}}, {}};
    for (size_t c = 0; c < size_t(pair.reference.channels); ++c) {
        const double mean = sums[c] / double(counted(pair));
        out.numbers.push_back({pair.reference.names[c], mean});
        if (std::abs(mean) > std::abs(out.numbers[0].value)) out.numbers[0].value = mean;
    }
    return out;
}

}  // namespace alidade
