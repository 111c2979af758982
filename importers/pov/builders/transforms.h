// SPDX-License-Identifier: Apache-2.0
/// `translate`, `rotate`, `scale`, `matrix` and `transform` of a block -> one affine map.
#pragma once

#include "core/transform.h"
#include "importers/pov/parser.h"

namespace alidade::pov {

/// The map that the items of `transform { ... }` make, in order; `inverse`, wherever it stands, inverts all of it (probed). Fails with a place for what is
/// no transformation, and for the inverse of a map that has none. A scale of 0 becomes 1, with a warning, as in POV-Ray.
Transform build_transform(Parser& p, const Block& block);

/// Does a transformation begin with this item?
bool begins_transform(const Item& item);
/// The map of the transformation that begins at item `i` of `block`; `i` moves behind it.
Transform take_transform(Parser& p, const Block& block, size_t& i);

}  // namespace alidade::pov
