// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/pov.h"

#include "core/deep_stack.h"
#include "importers/pov/builders/scenes.h"
#include "importers/pov/parser.h"
#include "importers/pov/quality.h"

namespace alidade {

bool looks_like_pov(std::span<const std::byte>) { return false; }

ImportResult import_pov(const std::string& path, const ImportOptions& options) {
    pov::ReadOptions read;
    read.include_paths = options.include_paths;
    read.scene_folder_last = options.scene_folder_last;
    read.header = options.header;
    read.declarations = options.declarations;
    read.strict = options.strict;
    read.frame = options.frame;
    read.version = options.version;
    read.quality = options.quality;
    read.write_folder = options.write_folder;
    read.print = options.print;
    read.limits = options.limits;
    read.limits.file_bytes = std::min(read.limits.file_bytes, options.max_file_bytes);
    Imported out;
    std::optional<std::string> text = pov::read_scene_file(path, read, out.diagnostics);
    const auto read_all = [&] {
        pov::Parser parser(read, out.diagnostics);
        const pov::Program program = pov::read_program(parser, path, std::move(*text));
        if (!out.diagnostics.has_errors()) out.scene = pov::build_scene(parser, program);
        pov::reduce(out.scene, read.quality);
        parser.say_tallies();
    };
    if (text) run_on_deep_stack(read_all);
    if (out.diagnostics.has_errors()) return tl::unexpected(std::move(out.diagnostics));
    return out;
}

}  // namespace alidade
