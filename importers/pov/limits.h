// SPDX-License-Identifier: Apache-2.0
/// How much a scene may ask for before reading it ends in an error. A scene is a program, and programs can be endless.
#pragma once

#include <cstddef>
#include <cstdint>

namespace alidade::pov {

struct Limits {
    uint64_t tokens_read = 200'000'000;    ///< replayed ones count each time: what an endless loop or a macro bomb runs into
    uint64_t loop_turns = 25'000'000;
    size_t tokens_in_file = 27'000'000;     ///< and numbers in literal vectors
    size_t levels = 400;                   ///< macro calls and includes inside one another (POV-Ray: 100)
    size_t nesting = 500;                  ///< brackets, blocks, directives and calls inside one another: what the call stack has to hold
    size_t array_elements = 10'000'000;    ///< of all arrays together
    size_t items = 6'200'000;              ///< of all blocks together; a mesh of a million triangles has six million
    size_t string_bytes = 16'000'000;      ///< of one string
    size_t written_bytes = 100'000'000;    ///< by #write
    uint64_t file_bytes = 0xFFFF'FFF0;
};

}  // namespace alidade::pov
