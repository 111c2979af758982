// SPDX-License-Identifier: Apache-2.0
/// What the picture formats share. Seen by core/image.cpp, its codecs and nobody else.
#pragma once

#include "core/image.h"

#include <optional>
#include <string_view>

namespace alidade::image {

using Bytes = std::vector<std::byte>;
template <class T> using Result = tl::expected<T, std::string>;

using Stored = StoredPicture;

/// Refuses a picture of `width` x `height` x `channels` values that a file of `file_bytes` bytes cannot hold, before memory is asked for.
/// The densest honest file is a 1-bit PNG, whose deflate stream makes 1032 bytes of one: 8256 values a byte.
Result<void> check_size(uint64_t width, uint64_t height, uint64_t channels, size_t file_bytes);

/// Which channels make the colour: R, G, B (or Y alone), and A.
struct ColorChannels {
    int count = 0;               ///< 1 or 3; 0: there is no colour
    int index[3] = {-1, -1, -1};
    int alpha = -1;
};
ColorChannels color_channels(const Picture& picture);

/// One float of straight colour, or alpha, for each pixel and output channel: colour is divided by alpha where alpha is not 0.
/// `with_alpha` asks for a last channel of alpha.
std::vector<float> straight_colors(const Picture& picture, const ColorChannels& colors, bool with_alpha);

/// The same in 8 bits: colour sRGB-encoded, alpha linear, each rounded to the nearest code; NaN becomes 0.
std::vector<uint8_t> encode_8bit(const Picture& picture, const ColorChannels& colors, bool with_alpha);

/// And in 16.
std::vector<uint16_t> encode_16bit(const Picture& picture, const ColorChannels& colors, bool with_alpha);

Result<Stored> decode_png(std::span<const std::byte> bytes);
Result<Bytes> encode_png(const Picture& picture);
/// With 16 bits a sample.
Result<Bytes> encode_deep_png(const Picture& picture);

/// PGM and PPM, plain and raw (P2, P3, P5, P6), and PFM (Pf, PF).
Result<Stored> decode_pnm(std::span<const std::byte> bytes);
Result<Bytes> encode_ppm(const Picture& picture);
/// With 16 bits a sample.
Result<Bytes> encode_deep_ppm(const Picture& picture);
Result<Bytes> encode_pfm(const Picture& picture);

Result<Stored> decode_exr(std::span<const std::byte> bytes);
Result<Bytes> encode_exr(const Picture& picture);

/// Both leave what they do not read to the module.
Result<Stored> decode_jpeg(std::span<const std::byte> bytes);
Result<Stored> decode_gif(std::span<const std::byte> bytes);

/// Tells that the picture is to be turned, if Exif's number says so.
void note_orientation(Stored& stored, uint32_t orientation);

/// Everything else, by the OpenImageIO module. `ending` is the wanted format, with its dot.
Result<Stored> decode_by_module(std::span<const std::byte> bytes);
/// Is the ending one of a format that encode_by_module writes, and is the module there?
Result<void> check_module_writes(const std::string& ending);
Result<Bytes> encode_by_module(const Picture& picture, const std::string& ending);

}  // namespace alidade::image
