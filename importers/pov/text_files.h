// SPDX-License-Identifier: Apache-2.0
/// #fopen, #read, #write, #fclose: text files that a scene reads and writes.
#pragma once

#include "importers/pov/lexer.h"
#include "importers/pov/value.h"

#include <fstream>
#include <map>
#include <set>

namespace alidade::pov {

/// An open file; what the identifier of #fopen holds.
struct TextFile : Shared {
    std::string path;
    bool writing = false;
    std::optional<Source> source;    ///< what there is to read, and its tokens
    TokenRoom room;
    TokenList list;
    size_t at = 0;               ///< in the tokens
    std::string* kept = nullptr; ///< where it is written to in memory, because nothing has allowed to write
    std::ofstream out;           ///< where else
};

/// The files that a scene writes: on the disk where that is allowed, else in memory, where the scene can read them again.
class TextFiles {
  public:
    /// A path below `folder` for `name`, or nothing if `name` leads out of it.
    static std::optional<std::string> below(const std::string& folder, const std::string& name);
    /// Both return false if the file cannot be written.
    bool open_on_disk(const Ref<TextFile>& file, bool append);
    static bool write(TextFile& file, const std::string& text);
    void open_in_memory(TextFile& file) { file.kept = &kept_[file.path]; }
    /// Writes out what is still on its way to the disk: before something is read that the scene may have written. The path of a file that cannot be
    /// written, if there is one.
    std::optional<std::string> flush();
    /// Has the scene opened this file of the disk to write to it?
    bool wrote(const std::string& path) const;
    /// What the scene has written to `name` in memory, or null.
    const std::string* kept(const std::string& name) const;
    size_t written = 0;          ///< bytes, of all files

  private:
    std::map<std::string, std::string> kept_;
    std::vector<Ref<TextFile>> on_disk_;     ///< those that are open
    std::set<std::string> written_;          ///< the paths of all that were, links and ".." resolved
};

}  // namespace alidade::pov
