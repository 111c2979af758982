// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/document.h"
#include "exporters/losses.h"

namespace alidade::gltf_export {

using SlotMaterials = std::vector<std::optional<MaterialId>>;   ///< one a slot

/// The meshes of a document. A shape is written once, however many nodes show it, and in however many materials.
class MeshWriter {
  public:
    MeshWriter(const Scene& scene, Document& document, Losses& losses) : scene_(scene), document_(document), losses_(losses) {}

    /// The mesh of `shape` in these materials; nothing if no triangle of it can be written. A skinned one has its origin added to its positions, because
    /// no node can move it.
    std::optional<size_t> add(ShapeId shape, const SlotMaterials& materials, bool skinned);

  private:
    struct Primitive {
        uint32_t slot = 0;
        Json json;   ///< without a material
    };
    struct Key {
        ShapeId shape;
        bool skinned;
        SlotMaterials materials;
        friend auto operator<=>(const Key&, const Key&) = default;
    };
    const std::vector<Primitive>& primitives(ShapeId shape, bool skinned);

    const Scene& scene_;
    Document& document_;
    Losses& losses_;
    std::map<std::pair<ShapeId, bool>, std::vector<Primitive>> primitives_;
    std::map<Key, size_t> meshes_;
};

}  // namespace alidade::gltf_export
