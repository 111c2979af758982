// SPDX-License-Identifier: Apache-2.0
/// Vertex colours as textures: POV-Ray mixes those of a triangle's three corners over it.
#pragma once

#include "exporters/pov/node_facts.h"
#include "exporters/pov/textures.h"

#include <span>

namespace alidade::pov_export {

class VertexColors {
  public:
    /// Of the triangles `which` of `mesh` in the materials `slots`. Colours are lost where a material has pictures or layers, and where there are too many.
    VertexColors(const Mesh& mesh, const SlotMaterials& slots, std::span<const uint32_t> which, const Scene& scene, Losses& losses);

    /// Are there textures to write?
    bool present() const { return !textures_.empty(); }
    size_t size() const { return textures_.size(); }
    /// `texture { }` of each, in the order of their numbers.
    void write(TextureWriter& textures) const;
    /// The numbers of the textures at the corners of the n-th of the triangles.
    const Index3& at(size_t n) const { return corners_[n]; }

  private:
    using Tint = std::array<float, 4>;

    std::vector<std::pair<MaterialId, Tint>> textures_;
    std::vector<Index3> corners_;
};

}  // namespace alidade::pov_export
