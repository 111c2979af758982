// SPDX-License-Identifier: Apache-2.0
/// #fopen, #read, #write, #fclose: text files that a scene reads and writes.
#pragma once

#include "importers/pov/source.h"
#include "importers/pov/value.h"

namespace alidade::pov {

/// An open file; what the identifier of #fopen holds.
struct TextFile : Shared {
    std::string path;
    bool writing = false, append = false;
    std::string text;            ///< what there is to read
    size_t at = 0;
};

/// Files that are written are collected here and reach the disk when they are closed.
class TextFiles {
  public:
    /// A path below `folder` for `name`, or nothing if `name` leads out of it.
    static std::optional<std::string> below(const std::string& folder, const std::string& name);
    /// False if the file cannot be written.
    static bool write(const TextFile& file);
    size_t written = 0;          ///< bytes, of all files
};

}  // namespace alidade::pov
