// SPDX-License-Identifier: Apache-2.0
/// `translate`, `rotate`, `scale`, `matrix` and `transform` of a block -> one affine map.
#pragma once

#include "core/transform.h"
#include "importers/pov/parser.h"

namespace alidade::pov {

/// The map that the items of `transform { ... }` make, in order; `inverse`, wherever it stands, inverts all of it (probed). Fails with a place for what is
/// no transformation, and for the inverse of a map that has none. A scale of 0 becomes 1, with a warning, as in POV-Ray.
Transform build_transform(Parser& p, const Block& block);

}  // namespace alidade::pov
