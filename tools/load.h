// SPDX-License-Identifier: Apache-2.0
/// The first step of every verb that looks at a scene.
#pragma once

#include "tools/options.h"

#include <optional>

namespace alidade {

struct Loaded {
    std::optional<Scene> scene;   ///< absent if there is an error among what was said
    Diagnostics said;
    double seconds = 0;
};

/// Reads the scene of `request`, poses it if a time was asked for, and reshapes its meshes as asked.
Loaded load(const Request& request);

/// Seconds since some fixed point; for differences.
double seconds_now();

}  // namespace alidade
