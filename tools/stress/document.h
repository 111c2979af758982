// SPDX-License-Identifier: Apache-2.0
/// The figures for programs: docs/stress.md says what the keys and columns mean.
#pragma once

#include "tools/json.h"
#include "tools/stress/series.h"

namespace alidade {

inline constexpr int kStressSchema = 1;

Json stress_document(const StressRequest& request, const StressResults& results, int exit_code);
/// A line for each peer and kind of rays of each size.
std::string stress_csv(const StressResults& results);
/// How costs grow, as a table.
std::string growth_table(const std::vector<StressGrowth>& growth);

}  // namespace alidade
