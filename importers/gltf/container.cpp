// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/container.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade::gltf {

namespace {

constexpr uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;
constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr int kMaxDepth = 64;

uint32_t little_endian_u32(std::span<const std::byte> bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value |= uint32_t(bytes[at + i]) << (8 * i);
    return value;
}

struct Chunk {
    uint32_t type = 0;
    std::span<const std::byte> data;
};

/// Chunks must be padded to 4 bytes. Some writers forget it; where another chunk follows it is plain that nothing is missing, at the end it is not.
bool accept_odd_length(size_t chunk, size_t length, bool last, Reporter& report) {
    const std::string message = fmt::format("GLB: chunk {} has a length that is not a multiple of 4 ({})", chunk, length);
    if (last) report.error("", message, "the file may be truncated: export it again");
    else report.warning("", message);
    return !last;
}

/// The chunks after the header, as long as they fit.
std::optional<std::vector<Chunk>> read_chunks(std::span<const std::byte> bytes, Reporter& report) {
    std::vector<Chunk> chunks;
    for (size_t at = kHeaderBytes; at < bytes.size();) {
        if (bytes.size() - at < kChunkHeaderBytes) {
            report.error("", fmt::format("GLB: {} bytes after chunk {} are too few for another chunk", bytes.size() - at, chunks.size()),
                         "the file may be truncated");
            return std::nullopt;
        }
        const size_t length = little_endian_u32(bytes, at);
        const uint32_t type = little_endian_u32(bytes, at + 4);
        at += kChunkHeaderBytes;
        if (length > bytes.size() - at) {
            report.error("", fmt::format("GLB: chunk {} claims {} bytes, but only {} are left", chunks.size(), length, bytes.size() - at),
                         "the file may be truncated");
            return std::nullopt;
        }
        chunks.push_back({type, bytes.subspan(at, length)});
        at += length;
        if (length % 4 != 0 && !accept_odd_length(chunks.size() - 1, length, at == bytes.size(), report)) return std::nullopt;
    }
    return chunks;
}

/// The part of the file that the header speaks of, or nothing and an error.
std::optional<std::span<const std::byte>> check_header(std::span<const std::byte> bytes, Reporter& report) {
    if (bytes.size() < kHeaderBytes) {
        report.error("", "GLB: the file ends inside its header", "the file may be truncated");
        return std::nullopt;
    }
    const uint32_t version = little_endian_u32(bytes, 4), length = little_endian_u32(bytes, 8);
    if (version != 2) {
        report.error("", fmt::format("GLB: container version {} is not supported, only 2 is", version),
                     version == 1 ? "convert the file to glTF 2.0" : "");
        return std::nullopt;
    }
    if (length < kHeaderBytes + kChunkHeaderBytes) {
        report.error("", fmt::format("GLB: the header claims {} bytes in all, too few for a chunk", length), "the file may be truncated");
        return std::nullopt;
    }
    if (length > bytes.size()) {
        report.error("", fmt::format("GLB: the header claims {} bytes, but the file has {}", length, bytes.size()), "the file may be truncated");
        return std::nullopt;
    }
    if (length < bytes.size()) report.warning("", fmt::format("GLB: {} bytes after the end are ignored", bytes.size() - length));
    return bytes.first(length);
}

std::optional<Container> split_glb(std::span<const std::byte> bytes, Reporter& report) {
    const auto body = check_header(bytes, report);
    if (!body) return std::nullopt;
    const auto chunks = read_chunks(*body, report);
    if (!chunks) return std::nullopt;
    if (chunks->empty() || chunks->front().type != kJsonChunk) {
        report.error("", "GLB: the first chunk is not JSON");
        return std::nullopt;
    }
    Container out;
    out.json = {reinterpret_cast<const char*>(chunks->front().data.data()), chunks->front().data.size()};
    for (size_t i = 1; i < chunks->size(); ++i) {
        const Chunk& chunk = (*chunks)[i];
        if (chunk.type == kJsonChunk || (chunk.type == kBinChunk && i != 1)) {
            report.error("", fmt::format("GLB: chunk {} is {}, which is only allowed as chunk {}", i, chunk.type == kJsonChunk ? "JSON" : "BIN",
                                         chunk.type == kJsonChunk ? 0 : 1));
            return std::nullopt;
        }
        if (chunk.type == kBinChunk) out.bin = chunk.data;
    }
    return out;
}

/// How deep the brackets nest. Stops counting at the limit.
int nesting(std::string_view text) {
    int depth = 0, deepest = 0;
    bool quoted = false;
    for (size_t i = 0; i < text.size() && deepest <= kMaxDepth; ++i) {
        const char c = text[i];
        if (quoted) {
            if (c == '\\') ++i;
            else if (c == '"') quoted = false;
        } else if (c == '"') quoted = true;
        else if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
        else if (c == ']' || c == '}') --depth;
    }
    return deepest;
}

SourcePos line_and_column(std::string_view text, size_t offset, uint32_t file) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const size_t newline = before.rfind('\n');
    SourcePos at;
    at.file = file;
    at.line = uint32_t(1 + std::count(before.begin(), before.end(), '\n'));
    at.column = uint32_t(newline == std::string_view::npos ? before.size() + 1 : before.size() - newline);
    return at;
}

std::string line_of(std::string_view text, size_t offset) {
    constexpr size_t kLongest = 160;
    offset = std::min(offset, text.size());
    const size_t before = text.substr(0, offset).rfind('\n');
    const size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::string_view line = text.substr(begin, text.substr(begin).find('\n'));
    return line.size() > kLongest ? std::string() : std::string(line);   // a file of one line: no excerpt
}

/// The library's sentence without its own prefix ("[json.exception...] parse error at line 1, column 2: ").
std::string reason(const std::string& what) {
    const size_t close = what.find("] ");
    std::string text = close == std::string::npos ? what : what.substr(close + 2);
    if (text.rfind("parse error at", 0) == 0) {
        const size_t colon = text.find(": ");
        if (colon != std::string::npos) text = text.substr(colon + 2);
    }
    return text;
}

}  // namespace

bool is_glb(std::span<const std::byte> bytes) { return bytes.size() >= 4 && little_endian_u32(bytes, 0) == kMagic; }

std::optional<Container> split_container(std::span<const std::byte> bytes, Reporter& report) {
    if (is_glb(bytes)) return split_glb(bytes, report);
    const auto magic = bytes.first(std::min<size_t>(bytes.size(), 4));
    if (std::find(magic.begin(), magic.end(), std::byte(0)) != magic.end()) {
        report.error("", "neither GLB, whose first bytes would be \"glTF\", nor JSON, which is text");
        return std::nullopt;
    }
    Container out;
    out.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    return out;
}

std::optional<Json> parse_json(std::string_view text, Reporter& report) {
    if (nesting(text) > kMaxDepth) {
        report.error("", fmt::format("JSON nested deeper than {} levels", kMaxDepth));
        return std::nullopt;
    }
    try {
        Json json = Json::parse(text);
        if (json.is_object()) return json;
        report.error("", fmt::format("a glTF file is a JSON object, this is {}", json.is_array() ? "an array" : "a plain value"));
    } catch (const Json::parse_error& e) {
        const size_t at = e.byte > 0 ? e.byte - 1 : 0;
        report.add({Severity::error, line_and_column(text, at, report.file()), "JSON: " + reason(e.what()), "", line_of(text, at), {}});
    } catch (const Json::exception& e) {
        report.error("", "JSON: " + reason(e.what()));
    }
    return std::nullopt;
}

}  // namespace alidade::gltf
