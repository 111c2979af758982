// SPDX-License-Identifier: Apache-2.0
/// The mean of the squared error over the squared reference: what Monte Carlo papers plot.
/// Source   Rousselle, Knaus, Zwicker, "Adaptive sampling and reconstruction using greedy error minimization", ACM TOG 30(6), 2011, section 6, with
///          their 0.01 in the denominator.
#include "tools/metrics/differences.h"

namespace alidade {

Measured measure_rel_mse(const PicturePair& pair) {
    double sum = 0;
    size_t count = 0;
    for_each_value(pair, [&](double reference, double test, size_t) { sum += (test - reference) * (test - reference) / (reference * reference + 0.01), ++count; });
    return {{{"value", sum / double(count)}}, {}};
}

}  // namespace alidade
