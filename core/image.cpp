// SPDX-License-Identifier: Apache-2.0
#include "core/image.h"

#include "core/image/codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace alidade {
namespace {

using image::Bytes;
using image::Result;
using image::Stored;

/// A format that is read without the module, and written, unless `encode` is null. `magic` are the bytes a file begins with.
struct Format {
    const char* ending;
    std::vector<std::string_view> magic;
    Result<Stored> (*decode)(std::span<const std::byte>);
    Result<Bytes> (*encode)(const Picture&);
};

const std::vector<Format>& formats() {
    static const std::vector<Format> table = {
        {".png", {"\x89PNG"}, image::decode_png, image::encode_png},
        {".exr", {"\x76\x2f\x31\x01"}, image::decode_exr, image::encode_exr},
        {".ppm", {"P2", "P3", "P5", "P6"}, image::decode_pnm, image::encode_ppm},
        {".pfm", {"PF", "Pf"}, image::decode_pnm, image::encode_pfm},
        {".jpeg", {"\xff\xd8\xff"}, image::decode_jpeg, nullptr},
        {".gif", {"GIF8"}, image::decode_gif, nullptr},
    };
    return table;
}

bool starts_with(std::span<const std::byte> bytes, std::string_view magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin(), [](char a, std::byte b) { return std::byte(a) == b; });
}

const Format* find_written_format(const std::string& ending) {
    for (const Format& f : formats())
        if (f.encode && ending == f.ending) return &f;
    return nullptr;
}

Result<Stored> decode_stored(std::span<const std::byte> bytes) {
    if (bytes.empty()) return tl::unexpected(std::string("the picture is empty"));
    for (const Format& f : formats())
        for (const std::string_view magic : f.magic)
            if (starts_with(bytes, magic)) {
                Result<Stored> stored = f.decode(bytes);
                if (stored) stored->format = std::string_view(f.ending).substr(1);
                return stored;
            }
    return image::decode_by_module(bytes);
}

/// Takes the sRGB curve off the colour channels. Integer files have few different values: each is computed once.
void linearize(Stored& stored) {
    std::vector<float> table;
    if (stored.levels) {
        table.resize(size_t(stored.levels) + 1);
        for (size_t k = 0; k < table.size(); ++k) table[k] = float(srgb_to_linear(double(k) / stored.levels));
    }
    Picture& picture = stored.picture;
    const image::ColorChannels colors = image::color_channels(picture);
    for (int c = 0; c < colors.count; ++c)
        for (size_t i = size_t(colors.index[c]); i < picture.values.size(); i += size_t(picture.channels)) {
            float& value = picture.values[i];
            value = table.empty() ? float(srgb_to_linear(value)) : table[size_t(std::lround(value * float(stored.levels)))];
        }
}

constexpr const char* kNoEnding = "the name has no ending that says which format to write";
constexpr const char* kNoMemory = "not enough memory";

}  // namespace

namespace image {

Result<void> check_size(uint64_t width, uint64_t height, uint64_t channels, size_t file_bytes) {
    constexpr uint64_t kMaxSide = 1 << 20, kMaxChannels = 1024, kMaxValues = uint64_t(1) << 30;
    constexpr uint64_t kValuesPerByte = 8256, kAlwaysAllowed = uint64_t(1) << 22;
    if (width == 0 || height == 0 || channels == 0) return tl::unexpected(fmt::format("it claims {} x {} pixels of {} channels", width, height, channels));
    if (width > kMaxSide || height > kMaxSide || channels > kMaxChannels || width * height > kMaxValues / channels)
        return tl::unexpected(fmt::format("it claims {} x {} pixels of {} channels, more than the limit of {} values", width, height, channels, kMaxValues));
    const uint64_t values = width * height * channels;
    if (values > kAlwaysAllowed && values / kValuesPerByte > file_bytes)
        return tl::unexpected(fmt::format("it claims {} x {} pixels of {} channels, but has only {} bytes", width, height, channels, file_bytes));
    return {};
}

void note_orientation(Stored& stored, uint32_t orientation) {
    if (orientation > 1 && orientation <= 8) stored.left_out.push_back(fmt::format("its orientation ({}, as Exif counts them)", orientation));
}

}  // namespace image

tl::expected<StoredPicture, std::string> decode_stored_picture(std::span<const std::byte> bytes) try {
    return decode_stored(bytes);
} catch (const std::bad_alloc&) {
    return tl::unexpected(std::string(kNoMemory));
}

tl::expected<Picture, std::string> decode_picture(std::span<const std::byte> bytes, Encoding encoding) try {
    Result<Stored> stored = decode_stored(bytes);
    if (!stored) return tl::unexpected(std::move(stored.error()));
    if (encoding == Encoding::srgb || (encoding == Encoding::automatic && stored->levels)) linearize(*stored);
    return std::move(stored->picture);
} catch (const std::bad_alloc&) {
    return tl::unexpected(std::string(kNoMemory));
}

tl::expected<Picture, std::string> read_picture(const std::string& path, Encoding encoding) {
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto picture = decode_picture(*bytes, encoding);
    if (!picture) return tl::unexpected(fmt::format("cannot read {}: {}", path, picture.error()));
    return picture;
}

tl::expected<StoredPicture, std::string> read_stored_picture(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto stored = decode_stored_picture(*bytes);
    if (!stored) return tl::unexpected(fmt::format("cannot read {}: {}", path, stored.error()));
    return stored;
}

tl::expected<std::vector<std::byte>, std::string> encode_picture(const Picture& picture, const std::string& ending, int bits) try {
    if (ending.empty()) return tl::unexpected(std::string(kNoEnding));
    if (picture.width <= 0 || picture.height <= 0 || picture.channels <= 0) return tl::unexpected(std::string("the picture is empty"));
    if (ending == ".png" && bits > 8) return image::encode_deep_png(picture);
    if (ending == ".ppm" && bits > 8) return image::encode_deep_ppm(picture);
    if (const Format* format = find_written_format(ending)) return format->encode(picture);
    return image::encode_by_module(picture, ending);
} catch (const std::bad_alloc&) {
    return tl::unexpected(std::string(kNoMemory));
}

std::string lower_ending(const std::string& path) {
    const size_t slash = path.find_last_of('/'), dot = path.find_last_of('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
    std::string ending = path.substr(dot);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return ending;
}

tl::expected<void, std::string> write_picture(const std::string& path, const Picture& picture, int bits) {
    const Result<Bytes> bytes = encode_picture(picture, lower_ending(path), bits);
    if (!bytes) return tl::unexpected(fmt::format("cannot write {}: {}", path, bytes.error()));
    return write_file(path, *bytes);
}

std::string why_no_format(const std::string& path) {
    const std::string ending = lower_ending(path);
    if (ending.empty()) return kNoEnding;
    if (find_written_format(ending)) return {};
    const auto done = image::check_module_writes(ending);
    return done ? std::string() : done.error();
}

}  // namespace alidade
