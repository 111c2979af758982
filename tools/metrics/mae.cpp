// SPDX-License-Identifier: Apache-2.0
/// The mean absolute error over all values.
#include "tools/metrics/differences.h"

namespace alidade {

Measured measure_mae(const PicturePair& pair) {
    double sum = 0;
    size_t count = 0;
    for_each_value(pair, [&](double reference, double test, size_t) { sum += std::abs(test - reference), ++count; });
    return {{{"value", sum / double(count)}}, {}};
}

}  // namespace alidade
