// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

constexpr const char* kNames[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// Attributes are stored in blocks of at most 256 elements; the least that a block takes is 2 bits a byte of the element for every 16 elements:
/// so no byte of data yields more than 64.
constexpr uint64_t kBestRatio = 64;

enum class Mode { attributes, triangles, indices };
enum class Filter { none, octahedral, quaternion, exponential, color };

/// One compressed view, as the file describes it.
struct Compressed {
    uint64_t stride = 0, count = 0;
    Mode mode = Mode::attributes;
    Filter filter = Filter::none;
    std::span<const unsigned char> data;
    std::string at;   ///< of the extension

    uint64_t bytes() const { return stride * count; }
};

Mode mode_of(const Json& extension) {
    const auto& name = extension["mode"].get_ref<const std::string&>();
    return name == "ATTRIBUTES" ? Mode::attributes : name == "TRIANGLES" ? Mode::triangles : Mode::indices;
}

Filter filter_of(const Json& extension) {
    const std::string name = extension.value("filter", "NONE");
    if (name == "OCTAHEDRAL") return Filter::octahedral;
    if (name == "QUATERNION") return Filter::quaternion;
    if (name == "EXPONENTIAL") return Filter::exponential;
    return name == "COLOR" ? Filter::color : Filter::none;
}

/// What the extension asks of a mode and a filter (EXT_meshopt_compression, "JSON schema updates"); nothing, or what is wrong.
std::string broken_rule(const Compressed& c) {
    const bool attributes = c.mode == Mode::attributes;
    if (attributes && c.stride % 4 != 0) return fmt::format("attributes need a byteStride that is a multiple of 4, not {}", c.stride);
    if (!attributes && c.stride != 2 && c.stride != 4) return fmt::format("indices need a byteStride of 2 or 4, not {}", c.stride);
    if (c.mode == Mode::triangles && c.count % 3 != 0) return fmt::format("triangles need a count that is a multiple of 3, not {}", c.count);
    if (!attributes && c.filter != Filter::none) return "only attributes can have a filter";
    if (c.filter == Filter::octahedral && c.stride != 4 && c.stride != 8)
        return fmt::format("the filter OCTAHEDRAL needs a byteStride of 4 or 8, not {}", c.stride);
    if (c.filter == Filter::quaternion && c.stride != 8) return fmt::format("the filter QUATERNION needs a byteStride of 8, not {}", c.stride);
    return {};
}

/// The fewest bytes that the elements can have been compressed to: a triangle takes a byte, an index takes one.
uint64_t fewest_bytes(const Compressed& c) {
    switch (c.mode) {
        case Mode::attributes: return c.bytes() / kBestRatio;
        case Mode::triangles: return c.count / 3;
        case Mode::indices: break;
    }
    return c.count;
}

int decode(const Compressed& c, Bytes& out) {
    switch (c.mode) {
        case Mode::attributes: return meshopt_decodeVertexBuffer(out.data(), c.count, c.stride, c.data.data(), c.data.size());
        case Mode::triangles: return meshopt_decodeIndexBuffer(out.data(), c.count, c.stride, c.data.data(), c.data.size());
        case Mode::indices: break;
    }
    return meshopt_decodeIndexSequence(out.data(), c.count, c.stride, c.data.data(), c.data.size());
}

void undo_filter(const Compressed& c, Bytes& out) {
    switch (c.filter) {
        case Filter::octahedral: return meshopt_decodeFilterOct(out.data(), c.count, c.stride);
        case Filter::quaternion: return meshopt_decodeFilterQuat(out.data(), c.count, c.stride);
        case Filter::exponential: return meshopt_decodeFilterExp(out.data(), c.count, c.stride);
        default: return;
    }
}

/// What only KHR_meshopt_compression has: colour filters, and version 1 of the attribute code (the low half of the first byte).
bool is_newer(const Compressed& c) {
    return c.filter == Filter::color || (c.mode == Mode::attributes && !c.data.empty() && (c.data[0] & 0x0f) > 0);
}

class Decompressor {
  public:
    Decompressor(Json& root, std::vector<Bytes>& buffers, Reporter& report) : root_(root), buffers_(buffers), report_(report) {
        for (const Bytes& b : buffers) left_ += kBestRatio * b.size();
    }

    void decompress(Json& view, const std::string& at) {
        const auto compressed = describe(view, at);
        if (!compressed) return;
        if (is_newer(*compressed)) return keep_fallback(view, *compressed);
        const uint64_t bytes = compressed->bytes();
        if (bytes > left_) return report_.error(compressed->at, "the compressed views use the bytes of their buffers many times over");
        left_ -= bytes;
        Bytes out(bytes);
        if (decode(*compressed, out) != 0) return report_.error(compressed->at, "the compressed data are damaged");
        undo_filter(*compressed, out);
        view["buffer"] = buffers_.size();
        view["byteOffset"] = 0;
        root_["buffers"].push_back({{"byteLength", bytes}});
        buffers_.push_back(std::move(out));
    }

  private:
    std::optional<Compressed> describe(const Json& view, const std::string& at) {
        const Json& extension = *meshopt_of(view);
        Compressed c;
        c.at = child(child(at, "extensions"), extension_in(view, kNames[0]) ? kNames[0] : kNames[1]);
        c.stride = whole(extension, "byteStride"), c.count = whole(extension, "count");
        c.mode = mode_of(extension), c.filter = filter_of(extension);
        const auto refuse = [&](std::string message) {
            report_.error(c.at, std::move(message));
            return std::nullopt;
        };
        if (const std::string broken = broken_rule(c); !broken.empty()) return refuse(broken);
        if (c.bytes() != whole(view, "byteLength"))
            return refuse(fmt::format("{} elements of {} bytes do not make the {} bytes of the view", c.count, c.stride, whole(view, "byteLength")));
        const Bytes& buffer = buffers_[extension["buffer"].get<size_t>()];
        const uint64_t offset = whole(extension, "byteOffset"), length = whole(extension, "byteLength");
        if (offset + length > buffer.size())
            return refuse(fmt::format("the compressed data end at byte {}, but their buffer has {} bytes", offset + length, buffer.size()));
        if (fewest_bytes(c) > length) return refuse(fmt::format("{} elements cannot have been compressed to {} bytes", c.count, length));
        c.data = {buffer.data() + offset, size_t(length)};
        return c;
    }

    void keep_fallback(const Json& view, const Compressed& compressed) {
        const std::string message = "this form of KHR_meshopt_compression is not supported";
        if (buffers_[view["buffer"].get<size_t>()].empty())
            report_.error(compressed.at, message, "write it with EXT_meshopt_compression, or without compression");
        else report_.warning(compressed.at, message + ": the uncompressed data are used");
    }

    Json& root_;
    std::vector<Bytes>& buffers_;
    Reporter& report_;
    uint64_t left_ = 0;   ///< bytes that may still be decoded
};

}  // namespace

const Json* meshopt_of(const Json& view) {
    for (const char* name : kNames)
        if (const Json* found = extension_in(view, name)) return found;
    return nullptr;
}

bool is_meshopt_fallback(const Json& buffer) {
    for (const char* name : kNames)
        if (const Json* found = extension_in(buffer, name)) return found->value("fallback", false);
    return false;
}

void decompress_views(Json& root, std::vector<Bytes>& buffers, Reporter& report) {
    const auto views = root.find("bufferViews");
    if (views == root.end()) return;
    Decompressor decompressor(root, buffers, report);
    for (size_t i = 0; i < views->size(); ++i) {
        if (!meshopt_of((*views)[i])) continue;
        decompressor.decompress((*views)[i], child("/bufferViews", i));
        (*views)[i].erase("extensions");
    }
}

}  // namespace alidade::gltf
