// SPDX-License-Identifier: Apache-2.0
/// What compile() made of a scene, what it left alone, and why: for `info`.
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

struct Explained {
    const char* what;    ///< "image", "mesh", ...
    std::string name;
    std::string why;
};

/// Pictures that were decoded and tangents that were made, each with what asked for it.
std::vector<Explained> decoded(const CompiledScene& scene);

/// Shapes, materials and pictures of the file that nothing of what is shown needs, structures that were not built, and features that the kernel has no code for.
std::vector<Explained> left_out(const CompiledScene& scene);

}  // namespace alidade
