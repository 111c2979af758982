// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// Fails where `next` cannot stand behind `comma`, in a block of the word `block` that has `before` so far and ends with `close`: POV-Ray may leave a comma out, but
/// takes one between two values alone, and behind what may be followed by one more value.
/// Source   experiments with POV-Ray 3.7: commas at 150 places. In blocks that were not tried only a second comma is refused.
void check_behind_comma(Parser& p, WordId block, std::span<const OpenItem> before, char close, const Token& comma, const Token& next);

}  // namespace alidade::pov
