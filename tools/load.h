// SPDX-License-Identifier: Apache-2.0
/// The first steps of every verb that looks at a scene.
#pragma once

#include "tools/options.h"
#include "tracer/render.h"

#include <memory>
#include <optional>

namespace alidade {

struct Loaded {
    std::optional<Scene> scene;   ///< absent if there is an error among what was said
    Diagnostics said;
    double seconds = 0;
};

/// Reads the scene of `request`, poses it if a time was asked for, and reshapes its meshes as asked.
Loaded load(const Request& request);

/// A scene ready for its rays, and what it took to get there.
struct Prepared {
    std::shared_ptr<const CompiledScene> scene;
    Diagnostics said;
    double read_seconds = 0, build_seconds = 0;
};

/// Loads and compiles.
Prepared prepare(const Request& request);

/// Seconds since some fixed point; for differences.
double seconds_now();

}  // namespace alidade
