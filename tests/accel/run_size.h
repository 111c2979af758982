// SPDX-License-Identifier: Apache-2.0
/// How much a randomised test runs.
#pragma once

#include <cstddef>

namespace alidade::test {

/// `usual` in an ordinary run, `full` where the environment says ALIDADE_FULL=1; both multiplied by ALIDADE_TEST_SCALE (default 1, e.g. 0.05
/// under a sanitizer), and never less than 1.
size_t run_size(size_t usual, size_t full);

/// Does the environment ask for less than an ordinary run?
bool runs_scaled_down();

}  // namespace alidade::test
