// SPDX-License-Identifier: Apache-2.0
/// A file that is written piece by piece, and is there whole or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace alidade {

/// Written to a temporary name beside `path`, which finish() renames. Links are followed; what is no regular file (a device, a pipe) is written into, and may be there in part. Without finish() nothing is left.
class OutputFile {
  public:
    explicit OutputFile(std::string path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// After an error nothing more is written: finish() tells the first one.
    void write(std::span<const std::byte> bytes);
    bool good() const { return error_.empty(); }
    /// An error is one sentence that names the file.
    tl::expected<void, std::string> finish();

  private:
    void check(bool done);

    std::string path_, target_, temporary_, error_;   ///< temporary_: empty where the file is written in place
    int descriptor_ = -1;
};

}  // namespace alidade
