// SPDX-License-Identifier: Apache-2.0
/// Below version 3.0 the words of pigment, normal and finish may stand in a texture itself.
#pragma once

#include "importers/pov/value.h"

namespace alidade::pov {

/// The items of a texture with each run of words that belongs into a pigment, a normal or a finish in such a block. Takes what they hold.
std::vector<OpenItem> with_blocks_for_old_words(std::span<OpenItem> items, const Ref<Meter>& meter, const BlockStanding& where);

}  // namespace alidade::pov
