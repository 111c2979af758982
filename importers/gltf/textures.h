// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/accessors.h"

#include <map>

namespace alidade::gltf {

/// How a material uses a texture: a textureInfo with its KHR_texture_transform.
struct TextureUse {
    int texture = -1;   ///< -1: none
    uint32_t uv_set = 0;
    Mat3 uv_transform{1.0};
    double scale = 1;   ///< of normal textures
    std::string at;     ///< JSON pointer

    bool present() const { return texture >= 0; }
};

/// From a textureInfo that tinygltf has read, ...
TextureUse texture_use(const tinygltf::TextureInfo& info, std::string at);
TextureUse texture_use(const tinygltf::NormalTextureInfo& info, std::string at);
TextureUse texture_use(const tinygltf::OcclusionTextureInfo& info, std::string at);
/// ... or from member `name` of an extension.
TextureUse texture_use(const tinygltf::Value& extension, const char* name, const std::string& at);

/// Adds signals to a scene. The same use of the same texture is one signal, so that metallic and roughness share it.
class SignalBuilder {
  public:
    SignalBuilder(const Model& model, Scene& scene, Reporter& report) : model_(model), scene_(scene), report_(report) {}

    SignalId constant(const Vec4& value, const std::string& at);
    /// All four channels of the texture times `factor`; the factor alone if there is no texture.
    SignalId textured(const TextureUse& use, bool srgb, const Vec4& factor, const std::string& at);
    /// One channel of the texture times `factor`; nothing if there is no texture and the factor is `absent`.
    std::optional<SignalId> channel(const TextureUse& use, int channel, double factor, double absent, const std::string& at);
    /// The texture alone (normals, occlusion).
    std::optional<SignalId> texture(const TextureUse& use, bool srgb);

  private:
    SignalId add(decltype(Signal::what) what, const std::string& at);
    SignalId times(SignalId signal, const Vec4& factor, const std::string& at);
    std::optional<ImageId> image_of(const TextureUse& use);

    const Model& model_;
    Scene& scene_;
    Reporter& report_;
    std::map<std::string, SignalId> shared_;
};

}  // namespace alidade::gltf
