// SPDX-License-Identifier: Apache-2.0
/// Figures as text.
#pragma once

#include "stress/run.h"

namespace alidade {

/// What the structures cost, how fast rays are, what was left out, and whether all agree.
std::string stress_table(const StressFigures& figures);

}  // namespace alidade
