// SPDX-License-Identifier: Apache-2.0
/// The files that one export leaves, and their names.
#pragma once

#include "scene/scene.h"

#include <map>
#include <tl/expected.hpp>

namespace alidade {

/// A name that every program can read in a line of text and as a file's name: what is neither a letter, a digit, one of "_-.+" nor beyond ASCII
/// becomes "_". At most 100 bytes; `instead` if nothing is left.
std::string plain_name(const std::string& name, const std::string& instead);

/// Hands out plain names, each once.
class UniqueNames {
  public:
    std::string make(const std::string& name, const std::string& instead);

  private:
    std::map<std::string, size_t> taken_;   ///< each name, and the number that its next double is tried with
};

/// How an encoded picture says what it is, by its magic bytes.
struct PictureFormat {
    const char* ending;   ///< with the dot; "" if unknown
    const char* mime;     ///< "" if unknown
};
PictureFormat picture_format(std::string_view bytes);

/// Collects the bytes of all files in memory; nothing is written before everything is known to be good.
class OutputFiles {
  public:
    OutputFiles(const Scene& scene, const std::string& path);

    /// The file that was asked for.
    void set_main(std::string bytes) { main_ = std::move(bytes); }
    /// Its name without the ending, fit for other files' names.
    const std::string& stem() const { return stem_; }
    bool has_ending(std::string_view ending) const;
    /// A file that belongs to the one asked for: its name with another ending. Returns the file's name.
    std::string add_companion(const std::string& ending, std::string bytes);
    /// From here on, names of pictures have ASCII letters alone: other ones become '_'.
    void use_ascii_names() { ascii_ = true; }
    /// A picture beside it, its bytes as they are: under its own name if that is free or holds the same bytes already, else numbered.
    std::string add_picture(const Image& image, std::string bytes);
    /// The encoded bytes of a picture; an error is one sentence.
    static tl::expected<std::string, std::string> read(const Image& image);

    /// Writes them, the one asked for last; returns their paths, the one asked for first. Refuses to write over a file that the scene was read from,
    /// or over a companion that may belong to another file (one that is there already although the file asked for is not).
    tl::expected<std::vector<std::string>, std::string> write() const;

  private:
    struct SideFile {
        std::string bytes;
        bool companion = false;
        bool there = false;   ///< the folder holds it already, byte by byte
    };
    std::string in_folder(const std::string& name) const;
    tl::expected<void, std::string> check(const std::string& path) const;
    tl::expected<void, std::string> check_all() const;

    const Scene& scene_;
    std::string path_, folder_, stem_, main_;
    bool ascii_ = false;
    std::map<std::string, SideFile> side_files_;   ///< by name
};

}  // namespace alidade
