// SPDX-License-Identifier: Apache-2.0
#include "tools/file_gamma.h"

#include "core/image_colors.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <zlib.h>

namespace alidade {

namespace {

using Bytes = std::vector<std::byte>;

/// Encoded by sRGB's curve, the colours become the codes of `gamma`.
void change_curve(Picture& picture, double gamma) {
    const std::vector<int> channels = color_channels(picture);
    const bool has_alpha = channels.size() == 2 || channels.size() == 4;
    for (size_t first = 0; first < picture.values.size(); first += size_t(picture.channels)) {
        const double alpha = has_alpha ? picture.values[first + size_t(channels.back())] : 1.0, whole = alpha > 0 ? alpha : 1.0;
        for (size_t c = 0; c < channels.size() - (has_alpha ? 1 : 0); ++c) {
            float& value = picture.values[first + size_t(channels[c])];
            value = float(srgb_to_linear(std::pow(std::clamp(value / whole, 0.0, 1.0), 1 / gamma)) * whole);
        }
    }
}

void put_number(Bytes& out, uint32_t n) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(std::byte(n >> shift & 255));
}

/// The same PNG file with a gAMA chunk behind its header, and none that says another curve.
Bytes with_gamma_chunk(const Bytes& png, double gamma) {
    constexpr size_t kHead = 8 + 25, kAround = 12;     // signature and IHDR; length, name and checksum of a chunk
    Bytes out(png.begin(), png.begin() + kHead);
    put_number(out, 4);
    const size_t name = out.size();
    for (const char c : {'g', 'A', 'M', 'A'}) out.push_back(std::byte(c));
    put_number(out, uint32_t(std::lround(std::clamp(1e5 / gamma, 1.0, 2147483647.0))));
    put_number(out, uint32_t(crc32(0, reinterpret_cast<const Bytef*>(&out[name]), uInt(out.size() - name))));
    for (size_t at = kHead, size; at < png.size(); at += size) {
        size = kAround;
        for (size_t i = 0; i < 4; ++i) size += size_t(png[at + i]) << (24 - 8 * i);
        const std::string_view kind(reinterpret_cast<const char*>(&png[at + 4]), 4);
        if (kind != "sRGB" && kind != "gAMA" && kind != "cHRM") out.insert(out.end(), png.begin() + std::ptrdiff_t(at), png.begin() + std::ptrdiff_t(at + size));
    }
    return out;
}

}  // namespace

tl::expected<Bytes, std::string> encode_with_gamma(Picture picture, const std::string& ending, int bits, double gamma) {
    const bool of_floats = ending == ".exr" || ending == ".pfm" || ending == ".hdr";
    if (!of_floats) change_curve(picture, gamma);
    auto bytes = encode_picture(picture, ending, bits);
    if (bytes && ending == ".png") *bytes = with_gamma_chunk(*bytes, gamma);
    return bytes;
}

}  // namespace alidade
