// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/words.h"

#include <optional>
#include <string_view>

namespace alidade::pov {

/// Of a word that POV-Ray refuses in blocks of the word `block`: the kind of block that it belongs to. Nothing for the many words that are not known to be
/// refused there.
/// Source   experiments with POV-Ray 3.7: each word in each kind of block
std::optional<std::string_view> belongs_elsewhere(WordId word, WordId block);

/// Is the word one of a block that stands in objects, and nowhere by itself?
inline bool belongs_to_objects(WordId word) {
    return word == "texture"_w || word == "interior_texture"_w || word == "pigment"_w || word == "normal"_w || word == "finish"_w || word == "material"_w || word == "interior"_w;
}

}  // namespace alidade::pov
