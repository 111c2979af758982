// SPDX-License-Identifier: Apache-2.0
/// Where something stands in the user's files.
#pragma once

#include <cstdint>
#include <string>

namespace alidade {

inline constexpr uint32_t kNoFile = ~uint32_t(0);

/// A place in a file: a line and column (both from 1; 0 = unknown) or, for JSON, a pointer such as "/nodes/3/mesh" (RFC 6901).
struct SourcePos {
    uint32_t file = kNoFile;   ///< index into Scene::files and Diagnostics::files
    uint32_t line = 0, column = 0;
    std::string pointer;
};

struct SourceFile {
    std::string path;   ///< as the user or the including file wrote it
};

}  // namespace alidade
