// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// What to do about a name that is not declared: the include that declares it, or the name that may have been meant, if it can stand there. For messages: it
/// reads files.
std::string hint_for_undeclared(Parser& p, const Token& name);

/// The first of `items`, which were read into a block of the word `block` that is not closed, or of the blocks in them, that stands where it cannot: before it a
/// brace may be missing. Nothing if none does.
std::optional<std::pair<WordId, Place>> first_out_of_place(WordId block, std::span<const OpenItem> items);

}  // namespace alidade::pov
