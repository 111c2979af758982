// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/student.h"

#include <algorithm>
#include <cmath>

namespace alidade {

double normal_deviate(double t, double degrees) { return (8 * degrees + 1) / (8 * degrees + 3) * std::sqrt(degrees * std::log1p(t * t / degrees)); }

double sidak_limit(double alpha, size_t tests) {
    const double each = -std::expm1(std::log1p(-alpha) / double(std::max<size_t>(tests, 1)));   // 1 - (1 - alpha)^(1 / tests), without losing digits
    double low = 0, high = 40;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > each ? low : high) = middle;
    }
    return low;
}

}  // namespace alidade
