// SPDX-License-Identifier: Apache-2.0
/// Pictures in memory, and the files that hold them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace alidade {

/// width x height pixels of `channels` floats, rows from the top, left to right, interleaved.
struct Picture {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
    std::vector<std::string> names;   ///< one a channel: "R", "G", "B", "A", "depth.Z", "normal.X", ...; gray is one channel, "Y"

    Picture() = default;
    Picture(int w, int h, std::vector<std::string> channel_names)
        : width(w), height(h), channels(int(channel_names.size())), values(size_t(w) * size_t(h) * channel_names.size()), names(std::move(channel_names)) {}
    float* at(int x, int y) { return &values[(size_t(y) * size_t(width) + size_t(x)) * size_t(channels)]; }
    const float* at(int x, int y) const { return &values[(size_t(y) * size_t(width) + size_t(x)) * size_t(channels)]; }
};

/// How stored numbers become linear ones. `automatic`: 8- and 16-bit files are sRGB, float files are linear.
enum class Encoding { automatic, linear, srgb };

double srgb_to_linear(double encoded);
double linear_to_srgb(double linear);

/// Decodes a picture held in memory: by its magic bytes, never by its name. Colour and alpha are as the file has them: alpha is straight (not
/// multiplied into the colour) but in EXR, whose colour is premultiplied by definition. Alpha is never decoded by a curve. Channels come as
/// R, G, B, A or Y, A, then others. PNG, JPEG, GIF, PPM/PGM, PFM and EXR are read here; all else (JPEG of CMYK, GIF whose first picture does not
/// fill the screen) goes to the OpenImageIO module, which is opened on first use. An error is one sentence without the file's name.
tl::expected<Picture, std::string> decode_picture(std::span<const std::byte> bytes, Encoding encoding);
/// The same for a file; an error names it.
tl::expected<Picture, std::string> read_picture(const std::string& path, Encoding encoding);

/// A picture as its file stores it: no curve is taken off.
struct StoredPicture {
    Picture picture;
    uint32_t levels = 0;   ///< values are k / levels with k = 0 .. levels; 0: they are floats
    double gamma = 0;      ///< of a PNG that says by a gAMA chunk, without an sRGB chunk: stored = linear ^ gamma; 0: it does not say
    bool srgb = false;     ///< of a PNG that has an sRGB chunk
    std::vector<uint8_t> palette = {};   ///< of a PNG or GIF with a palette: the number of each pixel's colour
    std::vector<std::string> left_out = {};   ///< what else the file says, and is not in `picture`: a clause each
    std::string_view format = {};   ///< "png", "gif" ..., by the file's magic bytes
};
tl::expected<StoredPicture, std::string> read_stored_picture(const std::string& path);
/// The same for a picture held in memory.
tl::expected<StoredPicture, std::string> decode_stored_picture(std::span<const std::byte> bytes);

/// Writes `picture`, linear and premultiplied by alpha, by the ending of `path`: .exr (float, every channel, names as layers); .png (8 bit, or 16 if `bits` says so,
/// sRGB-encoded, colour and alpha only); .ppm (the same without alpha: over black); .pfm (float, colour only, over black); others through the
/// OpenImageIO module. PNG's alpha is straight, so colour is divided by it (where it is 0, colour stays); it is left out if it is 1 everywhere.
/// Written to a temporary name and renamed, without time stamps: the same picture gives the same bytes, and a file is never half there.
tl::expected<void, std::string> write_picture(const std::string& path, const Picture& picture, int bits = 8);

/// The bytes that write_picture would write for `ending` (".png", ...; lower case). An error is one sentence.
tl::expected<std::vector<std::byte>, std::string> encode_picture(const Picture& picture, const std::string& ending, int bits = 8);

/// ".png" of "a/b.PNG"; nothing for a name without an ending.
std::string lower_ending(const std::string& path);

/// Why write_picture could write no picture to a file with the ending of `path`; "" if it can. Opens the OpenImageIO module where the format needs it.
std::string why_no_format(const std::string& path);

/// True once the OpenImageIO module is open (a test holds that it is not, unless a file needs it).
bool image_module_loaded();

/// All bytes of a file, or why not (the error names it); refuses what is not a regular file and files over `limit` bytes.
tl::expected<std::vector<std::byte>, std::string> read_file(const std::string& path, uint64_t limit = uint64_t(1) << 34);

/// Writes all or nothing: to a temporary name beside `path`, which is then renamed. Links are followed; what is no regular file (a device, a pipe) is written into.
tl::expected<void, std::string> write_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace alidade
