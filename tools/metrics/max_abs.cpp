// SPDX-License-Identifier: Apache-2.0
/// The largest difference: where it is, and both values. Of equal ones the first, row by row.
#include "tools/metrics/differences.h"

namespace alidade {

Measured measure_max_abs(const PicturePair& pair) {
    const size_t channels = size_t(pair.reference.channels);
    size_t worst = 0;
    double largest = 0;
    for (size_t i = 0; i < pair.reference.values.size(); ++i) {
        const double difference = std::abs(double(pair.test.values[i]) - double(pair.reference.values[i]));
        if (pair.counts[i / channels] && difference > largest) largest = difference, worst = i;
    }
    const size_t pixel = worst / channels;
    return {{{"value", largest},
             {"x", double(pixel % size_t(pair.width()))},
             {"y", double(pixel / size_t(pair.width()))},
             {"channel", double(worst % channels)},
             {"reference", pair.reference.values[worst]},
             {"test", pair.test.values[worst]}},
            {}};
}

}  // namespace alidade
