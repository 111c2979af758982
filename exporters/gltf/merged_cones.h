// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <map>
#include <optional>

namespace alidade::gltf_export {

/// A spot of glTF's is in POV-Ray's files a sum of hard cones, some of which take light away (exporters/pov/spot_rim.h); glTF's may not. Of each such sum the first light
/// becomes the spot again, and the others nothing. Only what is such a sum to rounding is in the map: cones like each other, in the same places, of the sum's coefficients.
std::map<LightId, std::optional<Light>> merged_cones(const Scene& scene);

}  // namespace alidade::gltf_export
