// SPDX-License-Identifier: Apache-2.0
/// What `tradeoff` tells, for people and for programs. The schema is docs/tradeoff.md.
#pragma once

#include "tools/json.h"
#include "tools/tradeoff/verdict.h"

#include <nlohmann/json.hpp>

namespace alidade::tradeoff {

/// The table, the recommendations, and what is wrong.
std::string as_lines(const Experiment& experiment, const Verdicts& verdicts);
/// The versioned document: `schema` counts up when a key changes its meaning or goes.
Json as_document(const Experiment& experiment, const Verdicts& verdicts);
/// A line for each row; names as in the document.
std::string as_csv(const Experiment& experiment, const Verdicts& verdicts);
/// One self-contained HTML page.
std::string as_page(const Experiment& experiment, const Verdicts& verdicts);

}  // namespace alidade::tradeoff
