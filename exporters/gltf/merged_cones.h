// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <map>

namespace alidade::gltf_export {

/// POV-Ray's spotlights may take light away, glTF's may not. Where some do, all of one place and direction are summed: the first stands for them, as the spot nearest to
/// the sum, and the others are nothing. What is left of negative light is not in the map.
std::map<LightId, std::optional<Light>> merged_cones(const Scene& scene);

}  // namespace alidade::gltf_export
