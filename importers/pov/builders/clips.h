// SPDX-License-Identifier: Apache-2.0
/// `clipped_by { ... }` and `bounded_by { ... }`: what stands in them, as nodes.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// A bounded_by, which clipped_by may name.
struct Bound {
    const Block* block;
    Transform moved;                      ///< of the object, where it stands
};

/// `clipped_by { bounded_by }` and `bounded_by { clipped_by }`: the word stands alone.
bool names_other_limits(Build& build, const Block& block);
/// Adds what stands in `block` to `limits`. `moved`: the object, where the block stands; `bounds`: what bounds it and has not been named, of which the last is named here.
void take_limits(Build& build, std::vector<Bound>& bounds, std::vector<NodeId>& limits, const Block& block, const Transform& moved);
/// Moves the last of `bounds` to `limits`, if there is one.
void take_last_bound(Build& build, std::vector<Bound>& bounds, std::vector<NodeId>& limits);

}  // namespace alidade::pov
