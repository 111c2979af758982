// SPDX-License-Identifier: Apache-2.0
/// The root of the mean squared error over all values.
#include "tools/metrics/differences.h"

namespace alidade {

Measured measure_rmse(const PicturePair& pair) {
    double sum = 0;
    size_t count = 0;
    for_each_value(pair, [&](double reference, double test, size_t) { sum += (test - reference) * (test - reference), ++count; });
    return {{{"value", std::sqrt(sum / double(count))}}, {}};
}

}  // namespace alidade
