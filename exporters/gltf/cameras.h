// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/document.h"
#include "exporters/losses.h"

namespace alidade::gltf_export {

/// The cameras of a document, each written once.
class CameraWriter {
  public:
    CameraWriter(const Scene& scene, Document& document, Losses& losses) : scene_(scene), document_(document), losses_(losses) {}

    struct Written {
        size_t index;
        Transform to_node;   ///< from glTF's camera, which looks along -z with y up, to the node's space
    };
    /// Nothing if glTF has no such projection.
    std::optional<Written> add(CameraId id);

  private:
    std::optional<Written> write(const Camera& camera);

    const Scene& scene_;
    Document& document_;
    Losses& losses_;
    std::map<CameraId, std::optional<Written>> known_;
};

}  // namespace alidade::gltf_export
