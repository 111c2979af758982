// SPDX-License-Identifier: Apache-2.0
/// CPU seconds from a scene's file to its scene graph; what bench/pov_parse.py asks beside POV-Ray.
///
/// Prints three numbers: import_scene alone, the process from its start to the end of import_scene, and what compile() adds
/// (accelerators, pictures), if it is asked for.
/// Example   pov_parse_time scene.pov --compile
#include "importers/importer.h"
#include "tracer/render.h"

#include <ctime>
#include <fmt/format.h>

namespace {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return fmt::print(stderr, "usage: pov_parse_time SCENE [--compile]\n"), 64;
    const bool compiles = argc > 2 && std::string_view(argv[2]) == "--compile";
    alidade::ImportOptions options;
    options.write_folder = ".";       // as POV-Ray, the scene may write files and read them again
    const double begun = cpu_seconds();
    alidade::ImportResult read = alidade::import_scene(argv[1], options);
    const double ended = cpu_seconds();
    if (!read) return fmt::print(stderr, "{}", read.error().text()), 1;
    fmt::print(stderr, "{}", read->diagnostics.text());
    const double said = cpu_seconds();
    if (compiles && !alidade::compile(std::move(read->scene), {}, read->diagnostics)) return 1;
    fmt::print("{:.4f} {:.4f} {:.4f}\n", ended - begun, ended, compiles ? cpu_seconds() - said : 0);
}
