// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/gltf/document.h"
#include "exporters/output_files.h"
#include "exporters/surfaces.h"

namespace alidade::gltf_export {

/// The textures of a document: samplers, images, and what refers to them.
class TextureWriter {
  public:
    /// `embed`: pictures go into the buffer, else beside the file.
    TextureWriter(const Scene& scene, Document& document, OutputFiles& files, bool embed, Losses& losses)
        : scene_(scene), document_(document), files_(files), embed_(embed), losses_(losses) {}

    /// object[key] = the textureInfo of a picture; false if it cannot be written.
    bool put(Json& object, const char* key, const ImageSignal& signal);

  private:
    struct Picture {
        std::optional<size_t> index;
        bool webp = false;
    };
    const Picture& picture(ImageId id);
    std::optional<size_t> sampler(const ImageSignal& signal);
    std::optional<size_t> texture(const ImageSignal& signal);
    void put_transform(Json& info, const ImageSignal& signal);

    const Scene& scene_;
    Document& document_;
    OutputFiles& files_;
    bool embed_;
    Losses& losses_;
    std::map<ImageId, Picture> pictures_;
    std::map<std::string, size_t> samplers_, textures_;   ///< by their JSON
};

/// Writes all materials of the scene, with their indices.
void write_materials(const Scene& scene, Document& document, TextureWriter& textures, Losses& losses);

}  // namespace alidade::gltf_export
