// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/buffers.h"

#include "core/image.h"
#include "importers/gltf/meshopt.h"
#include "importers/gltf/uris.h"

#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

std::vector<bool> referenced_buffers(const Json& root) {
    std::vector<bool> used(array_in(root, "buffers").size());
    for (const Json& view : array_in(root, "bufferViews")) {
        const Json* compressed = meshopt_of(view);
        used[(compressed ? *compressed : view)["buffer"].get<size_t>()] = true;
    }
    return used;
}

/// How many times over images may use the bytes of the buffers.
constexpr uint64_t kBufferReuse = 16;

class BufferLoader {
  public:
    BufferLoader(const Sources& sources, Reporter& report) : sources_(sources), report_(report), budget_(sources.max_file_bytes) {}

    Bytes load(const Json& buffer, size_t index, bool referenced) {
        const std::string at = child("/buffers", index);
        const auto uri = buffer.find("uri");
        Bytes bytes;
        if (index < sources_.unread.size() && sources_.unread[index]) return {};
        if (uri == buffer.end() && is_meshopt_fallback(buffer) && !referenced) return {};
        if (uri == buffer.end()) {
            if (index == 0 && sources_.bin) bytes = from_chunk(*sources_.bin, buffer["byteLength"].get<uint64_t>());
            else return without_data(at, index, referenced);
        } else {
            const auto& text = uri->get_ref<const std::string&>();
            auto read = is_data_uri(text) ? decode_data_uri(text) : read_beside(text);
            if (!read) {
                report_.error(child(at, "uri"), read.error());
                return {};
            }
            bytes = std::move(*read);
        }
        cut(bytes, buffer["byteLength"].get<uint64_t>(), at);
        return bytes;
    }

  private:
    static Bytes from_chunk(std::span<const std::byte> chunk, uint64_t length) {
        const auto* first = reinterpret_cast<const unsigned char*>(chunk.data());
        return Bytes(first, first + std::min<uint64_t>(chunk.size(), length));
    }

    Bytes without_data(const std::string& at, size_t index, bool referenced) {
        if (index == 0 && sources_.glb) report_.error(at, "the buffer has no uri, and the file has no binary chunk");
        else if (referenced) report_.error(at, "the buffer has no uri", "export the file again, with its buffers");
        return {};
    }

    tl::expected<Bytes, std::string> read_beside(const std::string& uri) {
        const auto path = resolve_uri(uri, sources_.base_dir);
        if (!path) return tl::unexpected(path.error());
        const auto file = read_file(*path, budget_);
        if (!file) return tl::unexpected(fmt::format("cannot read \"{}\": {}", *path, file.error()));
        budget_ -= file->size();
        const auto* first = reinterpret_cast<const unsigned char*>(file->data());
        return Bytes(first, first + file->size());
    }

    void cut(Bytes& bytes, uint64_t length, const std::string& at) {
        if (bytes.size() < length)
            report_.error(child(at, "byteLength"), fmt::format("claims {} bytes, but there are only {}", length, bytes.size()));
        else bytes.resize(length);
    }

    const Sources& sources_;
    Reporter& report_;
    uint64_t budget_;
};

class ImageLoader {
  public:
    ImageLoader(const Json& root, const std::vector<Bytes>& buffers, const Sources& sources, Reporter& report)
        : root_(root), buffers_(buffers), sources_(sources), report_(report) {
        for (const Bytes& b : buffers) budget_ += kBufferReuse * b.size();
    }

    Image load(const Json& json, size_t index) {
        const std::string at = child("/images", index);
        Image image;
        image.name = json.value("name", std::string());
        image.from = report_.at(at);
        if (json.contains("bufferView")) copy_view(json["bufferView"].get<size_t>(), at, image);
        else if (json.contains("uri")) load_uri(json["uri"].get_ref<const std::string&>(), child(at, "uri"), image);
        else report_.error(at, "the image has neither a uri nor a bufferView");
        return image;
    }

  private:
    void copy_view(size_t view_index, const std::string& at, Image& image) {
        const Json& view = root_["bufferViews"][view_index];
        const uint64_t length = view["byteLength"].get<uint64_t>(), offset = view.value("byteOffset", uint64_t(0));
        if (length > budget_) return report_.error(at, "the images hold far more bytes than the buffers that they are in");
        budget_ -= length;
        const auto* first = reinterpret_cast<const std::byte*>(buffers_[view["buffer"].get<size_t>()].data()) + offset;
        image.bytes.assign(first, first + length);
    }

    void load_uri(const std::string& uri, const std::string& at, Image& image) {
        if (is_data_uri(uri)) {
            const auto bytes = decode_data_uri(uri);
            if (!bytes) return report_.error(at, bytes.error());
            const auto* first = reinterpret_cast<const std::byte*>(bytes->data());
            image.bytes.assign(first, first + bytes->size());
            return;
        }
        const auto path = resolve_uri(uri, sources_.base_dir);
        if (!path) return report_.error(at, path.error());
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(*path, ignored)) report_.not_understood(at, fmt::format("there is no file \"{}\"", *path));
        image.path = *path;
    }

    const Json& root_;
    const std::vector<Bytes>& buffers_;
    const Sources& sources_;
    Reporter& report_;
    uint64_t budget_ = 0;
};

}  // namespace

std::vector<Bytes> load_buffers(const Json& root, const Sources& sources, Reporter& report) {
    const std::vector<bool> referenced = referenced_buffers(root);
    BufferLoader loader(sources, report);
    std::vector<Bytes> buffers;
    for (const Json& buffer : array_in(root, "buffers")) buffers.push_back(loader.load(buffer, buffers.size(), referenced[buffers.size()]));
    return buffers;
}

std::vector<Image> load_images(const Json& root, const std::vector<Bytes>& buffers, const Sources& sources, Reporter& report) {
    ImageLoader loader(root, buffers, sources, report);
    std::vector<Image> images;
    for (const Json& image : array_in(root, "images")) images.push_back(loader.load(image, images.size()));
    return images;
}

}  // namespace alidade::gltf
