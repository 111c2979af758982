// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/document.h"
#include "exporters/losses.h"

namespace alidade::gltf_export {

/// The lights of a document (KHR_lights_punctual), each written once. Candela and lux are the scene's radiometric units times 683 lm/W, as Blender's
/// exporter has it; the importer knows by the generator's name that it must divide by as much.
class LightWriter {
  public:
    LightWriter(const Scene& scene, Document& document, Losses& losses);

    /// Nothing for lights that glTF does not have.
    std::optional<size_t> add(LightId id);

  private:
    std::optional<Json> write(LightId id);
    /// What POV-Ray's brightness is multiplied by to be as bright at the middle of the scene.
    double strength_at_middle(LightId id);

    const Scene& scene_;
    Document& document_;
    Losses& losses_;
    std::map<LightId, std::optional<Light>> merged_;   ///< merged_cones
    std::map<LightId, std::optional<size_t>> known_;
    std::map<LightId, double> distances_;   ///< of those that are shown, from the middle of the scene; found when one is asked for
};

}  // namespace alidade::gltf_export
