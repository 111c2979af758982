// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/differences.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alidade {

const double* Measured::find(const std::string& name) const {
    for (const Number& number : numbers)
        if (number.name == name) return &number.value;
    return nullptr;
}

size_t counted(const PicturePair& pair) {
    return size_t(std::count_if(pair.counts.begin(), pair.counts.end(), [](uint8_t counts) { return counts != 0; }));
}

std::vector<float> pixel_differences(const PicturePair& pair) {
    const size_t channels = size_t(pair.reference.channels);
    std::vector<float> differences(pair.pixels());
    for (size_t p = 0; p < differences.size(); ++p) {
        if (!pair.counts[p]) continue;
        double largest = 0;
        for (size_t i = p * channels; i < (p + 1) * channels; ++i)
            largest = std::max(largest, std::abs(double(pair.test.values[i]) - double(pair.reference.values[i])));
        differences[p] = float(std::min(largest, double(std::numeric_limits<float>::max())));
    }
    return differences;
}

}  // namespace alidade
