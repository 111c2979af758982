// SPDX-License-Identifier: Apache-2.0
/// `word { ... }` -> Block: words, values, blocks and entries, with every expression evaluated. No word is known here but for textures of old versions (old_textures.h): that is the builders' part,
/// so that a scene can be read to its end whatever stands in it.
#pragma once

#include "importers/pov/parser.h"

namespace alidade::pov {

/// From the `{` on.
Value parse_block(Parser& p, WordId word, Place at);
/// What a #declare can hold: a block, or several textures one above the other. The word has been taken.
Value parse_declared_block(Parser& p, const Token& word);

}  // namespace alidade::pov
