// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/textures.h"

#include "importers/gltf/values.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

/// Translation * rotation * scale. The rotation turns texture coordinates so that the picture turns counter-clockwise as one sees it, v pointing
/// down. The extension's example fixes the sign: offset (0, 1), a quarter turn and scale 1/2 show the lower left quadrant.
/// Source   KHR_texture_transform, "Overview" and "Example JSON".
Mat3 uv_matrix(const tinygltf::Value& transform) {
    const Vec2 offset = vec2_in(transform, "offset", Vec2(0, 0)), scale = vec2_in(transform, "scale", Vec2(1, 1));
    const double angle = number_in(transform, "rotation", 0), c = std::cos(angle), s = std::sin(angle);
    return Mat3(c * scale.x, -s * scale.x, 0, s * scale.y, c * scale.y, 0, offset.x, offset.y, 1);
}

bool is_there(const Image& image) {
    std::error_code ignored;
    return !image.bytes.empty() || std::filesystem::is_regular_file(image.path, ignored);
}

void apply_transform(const tinygltf::Value& transform, TextureUse& use) {
    use.uv_transform = uv_matrix(transform);
    use.uv_set = uint32_t(number_in(transform, "texCoord", use.uv_set));
}

template <class Info> TextureUse use_of(const Info& info, std::string at) {
    TextureUse use;
    use.texture = info.index;
    use.uv_set = uint32_t(info.texCoord);
    use.at = std::move(at);
    const auto transform = info.extensions.find("KHR_texture_transform");
    if (transform != info.extensions.end()) apply_transform(transform->second, use);
    return use;
}

Wrap wrap_of(int wrap) {
    if (wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
    return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

}  // namespace

TextureUse texture_use(const tinygltf::TextureInfo& info, std::string at) { return use_of(info, std::move(at)); }

TextureUse texture_use(const tinygltf::NormalTextureInfo& info, std::string at) {
    TextureUse use = use_of(info, std::move(at));
    use.scale = info.scale;
    return use;
}

TextureUse texture_use(const tinygltf::OcclusionTextureInfo& info, std::string at) { return use_of(info, std::move(at)); }

TextureUse texture_use(const tinygltf::Value& extension, const char* name, const std::string& at) {
    TextureUse use;
    if (!extension.Has(name)) return use;
    const tinygltf::Value& info = extension.Get(name);
    use.texture = int(number_in(info, "index", -1));
    use.uv_set = uint32_t(number_in(info, "texCoord", 0));
    use.scale = number_in(info, "scale", 1);
    use.at = child(at, name);
    if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform"))
        apply_transform(info.Get("extensions").Get("KHR_texture_transform"), use);
    return use;
}

SignalId SignalBuilder::add(decltype(Signal::what) what, const std::string& at) {
    scene_.signals.push_back({std::move(what), report_.at(at)});
    return SignalId{uint32_t(scene_.signals.size() - 1)};
}

SignalId SignalBuilder::constant(const Vec4& value, const std::string& at) { return add(ConstantSignal{value}, at); }

SignalId SignalBuilder::times(SignalId signal, const Vec4& factor, const std::string& at) {
    return factor == Vec4(1, 1, 1, 1) ? signal : add(ProductSignal{signal, constant(factor, at)}, at);
}

std::optional<ImageId> SignalBuilder::image_of(const TextureUse& use) {
    const tinygltf::Texture& texture = model_.textures[size_t(use.texture)];
    const auto webp = texture.extensions.find("EXT_texture_webp");
    const int better = webp == texture.extensions.end() ? -1 : int(number_in(webp->second, "source", -1));
    for (const int source : {better, texture.source})
        if (source >= 0 && is_there(scene_.images[size_t(source)])) return ImageId{uint32_t(source)};
    report_.warning(child("/textures", size_t(use.texture)), "the texture has no image that can be read: it is left out");
    return std::nullopt;
}

std::optional<SignalId> SignalBuilder::texture(const TextureUse& use, bool srgb) {
    if (!use.present()) return std::nullopt;
    const Mat3& m = use.uv_transform;
    const std::string key =
        fmt::format("{} {} {} {} {} {} {} {} {}", use.texture, use.uv_set, srgb, m[0][0], m[0][1], m[1][0], m[1][1], m[2][0], m[2][1]);
    if (const auto found = shared_.find(key); found != shared_.end()) return found->second;
    const auto image = image_of(use);
    if (!image) return std::nullopt;
    ImageSignal signal;
    signal.image = *image;
    signal.uv_set = use.uv_set;
    signal.srgb = srgb;
    signal.uv_transform = use.uv_transform;
    if (const int sampler = model_.textures[size_t(use.texture)].sampler; sampler >= 0) {
        const tinygltf::Sampler& s = model_.samplers[size_t(sampler)];
        signal.wrap_u = wrap_of(s.wrapS), signal.wrap_v = wrap_of(s.wrapT);
        if (s.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) signal.filter = Filter::nearest;
    }
    return shared_[key] = add(signal, use.at);
}

SignalId SignalBuilder::textured(const TextureUse& use, bool srgb, const Vec4& factor, const std::string& at) {
    const auto signal = texture(use, srgb);
    return signal ? times(*signal, factor, at) : constant(factor, at);
}

std::optional<SignalId> SignalBuilder::channel(const TextureUse& use, int channel, double factor, double absent, const std::string& at) {
    const Vec4 all(factor, factor, factor, factor);
    const auto signal = texture(use, false);
    if (signal) return times(add(ChannelSignal{*signal, channel}, use.at), all, at);
    if (factor == absent) return std::nullopt;
    return constant(all, at);
}

}  // namespace alidade::gltf
