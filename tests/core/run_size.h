// SPDX-License-Identifier: Apache-2.0
/// How much a randomised test runs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace alidade::test {

/// Does the environment say ALIDADE_FULL=1?
inline bool runs_in_full() {
    const char* wanted = std::getenv("ALIDADE_FULL");
    return wanted && std::string_view(wanted) == "1";
}

/// ALIDADE_TEST_SCALE: 1 where the environment does not say, less under a sanitizer (0.05).
inline double run_scale() {
    const char* scale = std::getenv("ALIDADE_TEST_SCALE");
    return scale ? std::atof(scale) : 1;
}

/// `usual` in an ordinary run, `full` in a full one; both multiplied by run_scale(), and never less than 1.
inline size_t run_size(size_t usual, size_t full) { return size_t(std::max(double(runs_in_full() ? full : usual) * run_scale(), 1.0)); }
inline size_t run_size(size_t usual) { return run_size(usual, usual); }

}  // namespace alidade::test
