// SPDX-License-Identifier: Apache-2.0
/// The files of a scene: where they are looked for, what they hold, and places in them.
#pragma once

#include "core/diagnostics.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

namespace alidade::pov {

/// A byte of a source: small enough to stand in every token and every item.
struct Place {
    uint32_t source = 0, offset = 0;
};

/// One file as it was read. Never changed afterwards.
class Source {
  public:
    Source(std::string path, std::string text, uint32_t file) : path_(std::move(path)), text_(std::move(text)), file_(file) {}

    const std::string& path() const { return path_; }
    /// A NUL stands behind its last byte.
    std::string_view text() const { return text_; }
    /// Line and column (from 1) of a byte.
    SourcePos position(uint32_t offset) const;
    /// The line that holds a byte; a long one is cut to what is around it, and `column` becomes the column in the cut.
    std::string excerpt(uint32_t offset, uint32_t& column) const;

  private:
    std::string path_, text_;
    uint32_t file_;
    mutable std::vector<uint32_t> line_starts_;   ///< made when a message first needs them
};

/// Where POV-Ray's own includes lie when Debian's povray-includes is installed.
inline constexpr const char* kStandardIncludes = "/usr/share/povray-3.7/include";

/// Finds and reads files: in the folder of the scene, then in those given, then in the standard one. Nothing else may be read.
class SourceFinder {
  public:
    struct Found {
        std::string path;
        bool other_case = false;   ///< only the case of letters differs from what was asked for
    };

    SourceFinder(const std::filesystem::path& scene_folder, std::vector<std::string> include_paths, bool scene_folder_last = false);
    std::optional<Found> find(const std::string& name) const;
    const std::vector<std::filesystem::path>& folders() const { return folders_; }

  private:
    /// Does `path`, with links and ".." resolved, lie below one of the folders?
    bool allowed(const std::filesystem::path& path) const;

    /// `path`, an existing file, with links and ".." resolved.
    std::filesystem::path resolved(const std::filesystem::path& path, std::error_code& failed) const;

    std::vector<std::filesystem::path> folders_;
    mutable std::vector<std::filesystem::path> roots_;   ///< the same with links and ".." resolved; made when first asked
    mutable std::map<std::string, std::filesystem::path> resolved_;   ///< folders, likewise: most files lie in few of them
};

/// The name of a standard include that declares `name` (a value or a macro); empty if none does. Reads them all: for messages.
std::string include_that_declares(std::string_view name);

/// The bytes of a file, or nothing if it cannot be read or has more than `limit`.
std::optional<std::string> read_whole(const std::string& path, uint64_t limit);

}  // namespace alidade::pov
