// SPDX-License-Identifier: Apache-2.0
/// Instruction sets: which this machine has, and the choice among what was compiled for several of them.
#pragma once

#include <cstddef>
#include <span>

namespace alidade {

/// Which instructions may be used. `best`: what the machine has. All give the same structures and the same hits.
enum class Isa { best, scalar, sse4, avx2, avx512 };
/// Those that were compiled and that this machine can run, `scalar` first.
std::span<const Isa> available_isas();
const char* name(Isa isa);

/// Can this machine run them?
bool machine_has(Isa isa);

/// Of a table from the plainest to the widest, the row for `isa`, which for `best` is the widest that this machine has; the first, `scalar`, where it has not what was asked for.
template <class Entry, size_t count> const Entry& chosen(const Entry (&entries)[count], Isa isa) {
    const Entry* found = &entries[0];
    for (const Entry& entry : entries) {
        if (machine_has(entry.isa) && (isa == Isa::best || isa == entry.isa)) found = &entry;
    }
    return *found;
}

}  // namespace alidade
