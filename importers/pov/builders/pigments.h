// SPDX-License-Identifier: Apache-2.0
/// pigment, normal -> signals.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// What the items of `block` behind the first `skipped` make of the pigment `start`.
/// Source   POV-Ray 3.7 reference, 3.4.6.1 "Pigment".
SignalId build_pigment(Build& build, const Block& block, SignalId start, size_t skipped = 0);
/// What one begins with where no #default counts (probed): in sky spheres, functions and pigment_pattern.
SignalId plain_pigment(Build& build);

/// The same for a normal: a ReliefSignal, without a pattern where the block names none.
/// Source   POV-Ray 3.7 reference, 3.4.6.4 "Normal".
SignalId build_normal(Build& build, const Block& block, std::optional<SignalId> start, size_t skipped = 0);
/// Has it no pattern?
bool is_flat(const Build& build, SignalId normal);

/// The entries of a color_map.
std::vector<MapEntry> read_colour_map(Build& build, const Block& block);

/// A colour: red, green, blue, filter, transmit.
SignalId add_colour(Build& build, const std::array<double, 5>& c, Place at);

/// The same signal, moved behind all that it has: another one.
SignalId moved(Build& build, SignalId signal, const Transform& transform);

/// The same, but for what is looked up at (u, v, 0).
SignalId moved_in_space(Build& build, SignalId signal, const Transform& transform);

/// Puts a pigment's quick_color in its place, wherever it is the pigment of a texture.
void show_quick_colors(Build& build);

/// The pattern that comes next is none that is modelled: says so.
void tally_pattern(Build& build, const Item& item, const char* what);

}  // namespace alidade::pov
