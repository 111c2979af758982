// SPDX-License-Identifier: Apache-2.0
#include "tests/accel/run_size.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace alidade::test {

size_t run_size(size_t usual, size_t full) {
    const char* wants_full = std::getenv("ALIDADE_FULL");
    const char* scale = std::getenv("ALIDADE_TEST_SCALE");
    const double count = double(wants_full && std::string_view(wants_full) == "1" ? full : usual) * (scale ? std::atof(scale) : 1.0);
    return size_t(std::max(count, 1.0));
}

bool runs_scaled_down() {
    const char* scale = std::getenv("ALIDADE_TEST_SCALE");
    return scale && std::atof(scale) < 1;
}

}  // namespace alidade::test
