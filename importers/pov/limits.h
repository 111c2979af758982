// SPDX-License-Identifier: Apache-2.0
/// How much a scene may ask for while it is read. What exceeds a limit is an error at the place that exceeds it, which says how to raise it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace alidade::pov {

/// The defaults leave room for what people write, and end what is endless within seconds (pov_hostile_test).
struct Limits {
    uint64_t tokens_read = 200'000'000;      ///< replayed ones count each time: what an endless loop or a macro bomb runs into
    uint64_t loop_turns = 25'000'000;
    uint64_t tokens_in_file = 27'000'000;    ///< and numbers in literal vectors
    uint64_t levels = 400;                   ///< macro calls and includes inside one another (POV-Ray: 100)
    uint64_t nesting = 500;                  ///< brackets, blocks, directives and calls inside one another: what the call stack has to hold
    uint64_t depth = 20'000;                 ///< objects, functions and arrays made of one another: two for each `union { object { A } ... }`
    uint64_t array_elements = 10'000'000;    ///< of all arrays together
    uint64_t items = 6'200'000;              ///< of all blocks together; a mesh of a million triangles has six million
    uint64_t copies = 1'000'000;             ///< of objects that are named more than once: each time they are there with all their parts
    uint64_t string_bytes = 16'000'000;      ///< of one string
    uint64_t written_bytes = 100'000'000;    ///< by #write
    uint64_t file_bytes = 0xFFFF'FFF0;
};

/// A limit that a user may set, by name.
struct LimitEntry {
    const char* name;
    uint64_t Limits::*value;
    uint64_t most;      ///< what it may be raised to
    const char* doc;
};
std::span<const LimitEntry> limit_entries();

/// "steps=1e9": sets one, or says why not.
std::string set_limit(Limits& limits, std::string_view word);

/// What to do about a limit that was met; "" if it cannot be raised so far. `needed`: what the scene asks for, if that is known.
std::string how_to_raise(const Limits& limits, uint64_t Limits::*value, double needed = 0);

}  // namespace alidade::pov
