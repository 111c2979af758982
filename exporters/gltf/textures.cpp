// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/materials.h"

#include <fmt/format.h>

namespace alidade::gltf_export {

namespace {

enum { kNearest = 9728, kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497 };

int wrap_of(Wrap wrap) { return wrap == Wrap::repeat ? kRepeat : wrap == Wrap::mirror ? kMirroredRepeat : kClampToEdge; }

/// What a URI may hold as it is (RFC 3986, "unreserved"); all else is written as %XX.
std::string percent_encoded(const std::string& name) {
    std::string out;
    for (const char c : name) {
        const auto u = static_cast<unsigned char>(c);
        if ((u < 0x80 && std::isalnum(u)) || std::string_view("-_.~").find(c) != std::string_view::npos) out += c;
        else out += fmt::format("%{:02X}", u);
    }
    return out;
}

/// m = translation * rotation * scale, as KHR_texture_transform has it.
struct UvTransform {
    Vec2 offset{0}, scale{1};
    double rotation = 0;
    bool sheared = false;
};

UvTransform take_apart(const Mat3& m) {
    constexpr double kTolerance = 1e-9;
    UvTransform out;
    out.offset = Vec2(m[2][0], m[2][1]);
    const bool turned = m[0][1] != 0 || m[1][0] != 0;
    out.rotation = turned ? std::atan2(-m[0][1], m[0][0]) : 0;
    const double c = turned ? std::cos(out.rotation) : 1, s = turned ? std::sin(out.rotation) : 0;
    out.scale = Vec2(c * m[0][0] - s * m[0][1], s * m[1][0] + c * m[1][1]);
    out.sheared = std::abs(c * m[1][0] - s * m[1][1]) > kTolerance * (std::abs(m[1][0]) + std::abs(m[1][1]));
    return out;
}

}  // namespace

const TextureWriter::Picture& TextureWriter::picture(ImageId id) {
    const auto [known, added] = pictures_.try_emplace(id);
    if (!added) return known->second;
    const Image& image = scene_.images[id.index];
    auto bytes = OutputFiles::read(image);
    const PictureFormat format = bytes ? picture_format(*bytes) : PictureFormat{"", ""};
    const std::string mime = format.mime;
    if (mime.empty()) {
        losses_.add(bytes ? "pictures that are neither PNG nor JPEG nor WebP" : "pictures that cannot be read");
        return known->second;
    }
    Json json = Json::object();
    set(json, "name", image.name, std::string());
    if (embed_) json["bufferView"] = document_.add_view(*bytes, Target::none), json["mimeType"] = mime;
    else json["uri"] = percent_encoded(files_.add_picture(image, std::move(*bytes)));
    known->second = {document_.add("images", std::move(json)), mime == "image/webp"};
    return known->second;
}

std::optional<size_t> TextureWriter::sampler(const ImageSignal& signal) {
    losses_.add("textures that stand once", signal.wrap_u == Wrap::once || signal.wrap_v == Wrap::once, "their edge is continued");
    Json json = Json::object();
    if (signal.filter == Filter::nearest) json["magFilter"] = int(kNearest);
    set(json, "wrapS", wrap_of(signal.wrap_u), int(kRepeat));
    set(json, "wrapT", wrap_of(signal.wrap_v), int(kRepeat));
    if (json.empty()) return std::nullopt;
    const auto [known, added] = samplers_.try_emplace(json.dump());
    if (added) known->second = document_.add("samplers", std::move(json));
    return known->second;
}

std::optional<size_t> TextureWriter::texture(const ImageSignal& signal) {
    const Picture& p = picture(signal.image);
    if (!p.index) return std::nullopt;
    Json json = Json::object();
    if (const auto s = sampler(signal)) json["sampler"] = *s;
    if (p.webp) document_.use(json, "EXT_texture_webp", true)["source"] = *p.index;
    else json["source"] = *p.index;
    const auto [known, added] = textures_.try_emplace(json.dump());
    if (added) known->second = document_.add("textures", std::move(json));
    return known->second;
}

void TextureWriter::put_transform(Json& info, const ImageSignal& signal) {
    if (signal.uv_transform == Mat3(1.0)) return;
    const UvTransform parts = take_apart(signal.uv_transform);
    losses_.add("sheared texture coordinates", parts.sheared, "unsheared ones");
    Json& out = document_.use(info, "KHR_texture_transform");
    out = Json::object();
    set(out, "offset", parts.offset, Vec2(0));
    set(out, "rotation", parts.rotation, 0.0);
    set(out, "scale", parts.scale, Vec2(1));
}

bool TextureWriter::put(Json& object, const char* key, const ImageSignal& signal) {
    const auto index = texture(signal);
    if (!index) return false;
    Json info = {{"index", *index}};
    set(info, "texCoord", signal.uv_set, uint32_t(0));
    put_transform(info, signal);
    object[key] = std::move(info);
    return true;
}

}  // namespace alidade::gltf_export
