// SPDX-License-Identifier: Apache-2.0
/// #fopen, #read, #write, #fclose: text files that a scene reads and writes.
#pragma once

#include "importers/pov/source.h"
#include "importers/pov/value.h"

#include <map>

namespace alidade::pov {

/// An open file; what the identifier of #fopen holds.
struct TextFile : Shared {
    std::string path;
    bool writing = false, append = false;
    bool kept = false;           ///< in memory alone, because nothing has allowed to write
    std::string text;            ///< what there is to read
    size_t at = 0;
};

/// The files that a scene writes: on the disk where that is allowed, else in memory, where the scene can read them again.
class TextFiles {
  public:
    /// A path below `folder` for `name`, or nothing if `name` leads out of it.
    static std::optional<std::string> below(const std::string& folder, const std::string& name);
    /// False if the file cannot be written.
    bool write(const TextFile& file);
    /// What the scene has written to `name` in memory, or null.
    const std::string* kept(const std::string& name) const;
    size_t written = 0;          ///< bytes, of all files

  private:
    std::map<std::string, std::string> kept_;
};

}  // namespace alidade::pov
