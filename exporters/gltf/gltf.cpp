// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/gltf.h"

#include "exporters/gltf/animations.h"
#include "exporters/gltf/materials.h"
#include "exporters/gltf/nodes.h"

namespace alidade {

namespace {

using namespace gltf_export;

/// The importer knows the unit of light intensities by this name.
constexpr const char* kGenerator = "Alidade";

void append_u32(std::string& out, size_t value) {
    for (int i = 0; i < 4; ++i) out += char(value >> (8 * i) & 0xFF);
}

std::string padded(std::string bytes, char with) {
    bytes.resize((bytes.size() + 3) / 4 * 4, with);
    return bytes;
}

void append_chunk(std::string& out, const std::string& bytes, const char* type) {
    append_u32(out, bytes.size());
    out.append(type, 4);
    out += bytes;
}

/// glTF 2.0 specification, section 4 "GLB File Format Specification".
tl::expected<std::string, std::string> glb(const std::string& text, const std::string& buffer) {
    const std::string json = padded(text, ' '), binary = padded(buffer, '\0');
    const size_t size = 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
    if (size > UINT32_MAX) return tl::unexpected(std::string("the scene needs more than 4 GiB, which .glb cannot hold; write .gltf"));
    std::string out = "glTF";
    append_u32(out, 2), append_u32(out, size);
    append_chunk(out, json, "JSON");
    if (!binary.empty()) append_chunk(out, binary, std::string("BIN\0", 4).data());
    return out;
}

/// Names may be any bytes; JSON is UTF-8.
std::string text_of(const Json& root, int indent) { return root.dump(indent, ' ', false, Json::error_handler_t::replace); }

}  // namespace

tl::expected<void, std::string> write_gltf(const Scene& scene, OutputFiles& files, Losses& losses) {
    const bool binary = files.has_ending(".glb");
    Document document;
    document.root["asset"] = {{"version", "2.0"}, {"generator", kGenerator}};
    add_common_losses(scene, losses);
    const auto nodes = NodeWriter(scene, document, losses).write();
    if (!nodes) return tl::unexpected(nodes.error());
    TextureWriter textures(scene, document, files, binary, losses);
    write_materials(scene, document, textures, losses);
    write_skins(scene, *nodes, document);
    write_animations(scene, *nodes, document, losses);
    document.finish_extensions();
    const std::string& buffer = document.buffer();
    if (!buffer.empty()) document.root["buffers"] = Json::array({{{"byteLength", buffer.size()}}});
    if (!binary && !buffer.empty()) document.root["buffers"][0]["uri"] = files.add_companion(".bin", buffer);
    if (!binary) return files.set_main(text_of(document.root, 1) + "\n"), tl::expected<void, std::string>();
    return glb(text_of(document.root, -1), buffer).map([&](std::string bytes) { files.set_main(std::move(bytes)); });
}

}  // namespace alidade
