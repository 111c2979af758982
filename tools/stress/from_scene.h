// SPDX-License-Identifier: Apache-2.0
/// A user's scene as accelerators are measured on it.
#pragma once

#include "scene/scene.h"
#include "stress/rays.h"

#include "core/diagnostics.h"

#include <optional>

namespace alidade {

struct StressSubject {
    StressScene scene;
    std::vector<StressRay> primary;   ///< side x side, of the scene's first camera, or of one that frames everything
};

/// All triangles of all meshes that are shown, in their places; what is no mesh is left out, and that is said. Nothing if there is no triangle, or the scene
/// cannot be used.
std::optional<StressSubject> stress_subject(Scene scene, const std::string& path, size_t side, Diagnostics& said);

}  // namespace alidade
