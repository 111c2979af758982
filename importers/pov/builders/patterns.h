// SPDX-License-Identifier: Apache-2.0
/// What pigments, normals and maps of textures share: a pattern and its modifiers.
#pragma once

#include "importers/pov/builders/build.h"

#include <fmt/format.h>

namespace alidade::pov {

/// Reads the pattern that comes next, its name and the values that belong to the name, into `s`, whose modifiers stay. False, and nothing read, where no
/// pattern stands that eval/patterns knows. `depth`: that of a normal, which a bump_map may bring.
bool take_pattern(Build& build, Cursor& at, PatternSignal& s, double* depth = nullptr);

/// Reads what changes a pattern: turbulence, warps, waves, its own parameters, transformations. False, and nothing read, where nothing of it stands.
bool take_pattern_modifier(Build& build, Cursor& at, PatternSignal& s);

/// Moves a pattern, behind all that it has.
void move(PatternSignal& s, const Transform& transform);

/// How many entries stand in the list of a pattern of blocks (checker, brick ...); 0 for a pattern that takes a map.
size_t list_length(const PatternSignal& s);

/// The number that an entry of a map begins with, and how many items it takes: without one (which `average` allows) it counts as 1.
struct MapPlace {
    double value = 1;
    size_t skipped = 0;
};
MapPlace place_in_map(Build& build, const Block& entry);
/// A number of a map, which POV-Ray keeps in single precision.
double map_position(Cursor& at);

/// Calls `read` with each entry, `[ ... ]`, of a map and of the declared maps that stand in it. Fails where there is none, as POV-Ray does.
template <class F>
void for_each_entry(Build& build, const Block& map, const F& read) {
    const Nested nested(build.p, map.place);
    if (map.items().empty()) build.p.fail(map.place, fmt::format("this {} has no entry", kWords[map.word]));
    for (Cursor at(build, map); !at.done();) {
        if (const Block* base = at.any_block()) at.next(), for_each_entry(build, *base, read);
        else if (at.peek().kind == Item::Kind::entry) read(at.next().block());
        else at.skip_unmodelled();
    }
}

}  // namespace alidade::pov
