// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/document.h"
#include "exporters/losses.h"

namespace alidade::gltf_export {

/// The lights of a document (KHR_lights_punctual), each written once. Candela and lux are the scene's radiometric units times 683 lm/W, as Blender's
/// exporter has it; the importer knows by the generator's name that it must divide by as much.
class LightWriter {
  public:
    LightWriter(const Scene& scene, Document& document, Losses& losses) : scene_(scene), document_(document), losses_(losses) {}

    /// Nothing for lights that glTF does not have.
    std::optional<size_t> add(LightId id);

  private:
    std::optional<Json> write(const Light& light);

    const Scene& scene_;
    Document& document_;
    Losses& losses_;
    std::map<LightId, std::optional<size_t>> known_;
};

}  // namespace alidade::gltf_export
