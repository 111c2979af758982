// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/cameras.h"
#include "exporters/gltf/lights.h"
#include "exporters/gltf/meshes.h"

#include <tl/expected.hpp>

namespace alidade::gltf_export {

/// Where the nodes of a scene stand in the document.
struct WrittenNodes {
    std::vector<std::optional<size_t>> node;      ///< by NodeId; nothing for what no root and no parent leads to
    std::vector<std::optional<size_t>> carrier;   ///< the node that has its mesh; the same, or a child made for it
    std::vector<bool> copied;                     ///< written more than once: the first is meant above
};

/// Writes the nodes and the document's one scene. An error if more than ten million paths lead to them.
class NodeWriter {
  public:
    NodeWriter(const Scene& scene, Document& document, Losses& losses)
        : scene_(scene), document_(document), losses_(losses), meshes_(scene, document, losses), cameras_(scene, document, losses), lights_(scene, document, losses) {}

    tl::expected<WrittenNodes, std::string> write();

  private:
    /// A node to be written: at `index`, in the document's list.
    struct Task {
        NodeId id;
        size_t index;
        std::optional<MaterialId> inherited;
    };
    std::vector<NodeId> tops() const;
    void number(const std::vector<NodeId>& tops);
    size_t place(NodeId id, std::optional<MaterialId> inherited);
    void write_node(const Task& task);
    void put_shape(const Task& task, ShapeId shape, Json& json);
    size_t add_child(Json& parent, Json child);
    SlotMaterials materials(const Node& node, ShapeId shape, std::optional<MaterialId> inherited) const;

    const Scene& scene_;
    Document& document_;
    Losses& losses_;
    MeshWriter meshes_;
    CameraWriter cameras_;
    LightWriter lights_;
    WrittenNodes written_;
    std::vector<bool> used_;         ///< the first place of a node is taken
    std::vector<Json> nodes_;
    std::vector<Task> tasks_;
};

}  // namespace alidade::gltf_export
