// SPDX-License-Identifier: Apache-2.0
/// A scene in POV-Ray's language -> Program: its top-level blocks, with every directive obeyed and every expression evaluated.
#pragma once

#include "importers/pov/settings.h"
#include "importers/pov/value.h"

namespace alidade::pov {

/// What builders read.
struct Program {
    std::vector<Ref<Block>> blocks;                   ///< of the top level, in order
    std::vector<Value> defaults;                      ///< blocks of #default, in order; Block::defaults tells how many of them stood before a block
    std::vector<SourceFile> files;                    ///< by Place::source
};

/// Reads a whole scene. Errors are in `said`; what could be read is in the program. Throws nothing.
Program read_program(const std::string& path, const ReadOptions& options, Diagnostics& said);
/// The text of a scene's file, or an error in `said`.
std::optional<std::string> read_scene_file(const std::string& path, const ReadOptions& options, Diagnostics& said);
/// The same from memory by a parser that the caller keeps, for builders: its tallies are not said yet.
Program read_program(class Parser& parser, const std::string& path, std::string text);
/// The same from memory; `path` names it in messages, and its folder is where includes are looked for.
Program read_program_text(const std::string& path, std::string text, const ReadOptions& options, Diagnostics& said);

}  // namespace alidade::pov
