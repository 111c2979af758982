// SPDX-License-Identifier: Apache-2.0
/// What other programs were measured to do, row by row.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace alidade {

/// Measured with inputs like those of the row, in 2026, programs of g++ 12.2 -O2 -march=native -ffp-contract=off or Debian's packages, on one thread.
struct NumericsPeer {
    const char* row;       ///< "T01"
    const char* program;   ///< with its version
    const char* figure;
    const char* inputs;
};
std::span<const NumericsPeer> numerics_peers();

/// All of a row in a sentence, or "not measured".
std::string peers_text(std::string_view row);

}  // namespace alidade
