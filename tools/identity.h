// SPDX-License-Identifier: Apache-2.0
/// What decides the pixels of a picture.
#pragma once

#include "tracer/render.h"

namespace alidade {

/// Named lines, such as {"size", "640x480"}: the program, the scene, and what is asked of its render. Pictures with the same lines have the same
/// pixels, on however many threads they are made.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// This build of the program: another may compute otherwise.
std::string program_identity();

/// Of a scene that was compiled with the usual CompileOptions. A scene is what dump() says of it, and the bytes of the pictures that it names.
Identity identity(const CompiledScene& scene, const RenderOptions& options);

}  // namespace alidade
