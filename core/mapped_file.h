// SPDX-License-Identifier: Apache-2.0
/// A file as memory: its bytes are read when they are touched first, and shared with all who map it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace alidade {

/// The bytes of a regular file. Whoever changes it in place changes them; one that is replaced by another of its name (core/output_file.h) stays as it was.
class MappedFile {
  public:
    /// An error is one sentence that names the file.
    static tl::expected<std::shared_ptr<const MappedFile>, std::string> open(const std::string& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    explicit MappedFile(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::span<const std::byte> bytes_;
};

}  // namespace alidade
