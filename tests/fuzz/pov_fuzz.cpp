// SPDX-License-Identifier: Apache-2.0
/// libFuzzer target: any bytes as a scene in POV-Ray's language, read and built. Limits are low, so that a run is short; nothing is written, and what is included comes from
/// POV-Ray's own folder at most.
#include "importers/pov/builders/scenes.h"
#include "importers/pov/parser.h"
#include "importers/pov/reader.h"

#include "core/diagnostics.h"
#include "scene/queries.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace alidade;
    pov::ReadOptions options;
    options.limits.tokens_read = 20'000, options.limits.loop_turns = 2'000, options.limits.nesting = 300, options.limits.levels = 100;
    options.limits.array_elements = 10'000, options.limits.items = 10'000, options.limits.string_bytes = 10'000;
    Diagnostics said;
    pov::Parser parser(options, said);
    const pov::Program program = pov::read_program(parser, "fuzz.pov", std::string(reinterpret_cast<const char*>(data), size));
    const Scene scene = pov::build_scene(parser, program);
    if (!said.has_errors()) said.append(validate(scene));
    said.text();
    return 0;
}
