// SPDX-License-Identifier: Apache-2.0
/// The files that a render leaves.
#pragma once

#include "core/image.h"

namespace alidade {

/// Why a file called `path` surely cannot be written, in one clause, or "": asked before hours of rendering.
std::string why_no_file(const std::string& path);
/// The same of a file whose ending names its format.
std::string why_not_writable(const std::string& path);

/// Writes a film's picture (colour, then the layers' channels, "layer.X") to `path`. An EXR holds everything; other formats hold the
/// colour, and each layer stands beside it as an EXR: out.png, out.depth.exr. Returns the files' names, `path` first.
tl::expected<std::vector<std::string>, std::string> write_film(const std::string& path, const Picture& picture, int bits = 8);

}  // namespace alidade
