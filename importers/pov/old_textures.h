// SPDX-License-Identifier: Apache-2.0
/// Below version 3.0 the words of pigment, normal and finish may stand in a texture itself.
#pragma once

#include "importers/pov/value.h"

namespace alidade::pov {

/// The words of the blocks in which later versions have the items of a texture, one an item: pigment, normal, finish, or 0 for what belongs to a texture itself. A number in front is that of
/// `crand`.
std::vector<WordId> homes_in_texture(std::span<const Item> items);

}  // namespace alidade::pov
