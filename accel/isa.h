// SPDX-License-Identifier: Apache-2.0
/// Instruction sets: which were compiled for, and which this machine has.
#pragma once

#include <span>

namespace alidade {

/// Which instructions may be used. `best`: what the machine has. All give the same structures and the same hits (`auto`, which counts work, may choose another where two are nearly equal).
enum class Isa { best, scalar, sse4, avx2, avx512 };
/// Those that were compiled and that this machine can run, `scalar` first.
std::span<const Isa> available_isas();
const char* name(Isa isa);

/// Can this machine run them?
bool machine_has(Isa isa);

/// Do they have a product and a sum with one rounding? Boxes and edge filters use it: as they only sort out, what they let pass may differ from those without, and so may counts of work, but no hit does.
constexpr bool fuses(Isa isa) { return isa == Isa::avx2 || isa == Isa::avx512; }

}  // namespace alidade
