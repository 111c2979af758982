// SPDX-License-Identifier: Apache-2.0
/// The root mean squared error on a logarithmic scale, below a peak of 1: infinite for equal pictures.
#include "tools/metrics/differences.h"

namespace alidade {

Measured measure_psnr(const PicturePair& pair) { return {{{"value", -20 * std::log10(measure_rmse(pair).numbers[0].value)}}, {}}; }

}  // namespace alidade
