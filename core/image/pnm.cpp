// SPDX-License-Identifier: Apache-2.0
/// PGM, PPM (netpbm.sourceforge.net/doc/ppm.html) and PFM (pauldebevec.com/Research/HDR/PFM): text headers, then samples.
#include "core/image/codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace alidade::image {
namespace {

constexpr const char* kEndsEarly = "the file ends too early";

/// A header's words: separated by white space, with comments from # to the end of the line.
class Words {
  public:
    explicit Words(std::span<const std::byte> bytes) : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

    std::string_view next() {
        while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#')) {
            if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size());
            else ++at_;
        }
        const size_t begin = at_;
        while (at_ < text_.size() && !is_space(text_[at_]) && text_[at_] != '#') ++at_;
        return text_.substr(begin, at_ - begin);
    }
    template <class T> bool next(T& number) {
        const std::string_view word = next();
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        return error == std::errc() && end == word.data() + word.size();
    }
    /// What follows the single white-space character that ends the header.
    std::string_view after_header() const { return text_.substr(std::min(at_ + 1, text_.size())); }

  private:
    static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    std::string_view text_;
    size_t at_ = 0;
};

Picture make_picture(uint32_t width, uint32_t height, bool color) {
    return Picture(int(width), int(height), color ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"});
}

Result<void> read_plain(Words& words, uint32_t levels, std::vector<float>& values) {
    for (float& value : values) {
        uint32_t sample = 0;
        if (!words.next(sample)) return tl::unexpected(std::string("a sample is missing or is not a number"));
        if (sample > levels) return tl::unexpected(fmt::format("the sample {} is greater than the maximum {}", sample, levels));
        value = float(double(sample) / levels);
    }
    return {};
}

Result<void> read_raw(std::string_view data, uint32_t levels, std::vector<float>& values) {
    const size_t bytes_each = levels > 255 ? 2 : 1;
    if (data.size() / bytes_each < values.size()) return tl::unexpected(std::string(kEndsEarly));
    for (size_t i = 0; i < values.size(); ++i) {
        uint32_t sample = uint8_t(data[i * bytes_each]);
        if (bytes_each == 2) sample = sample << 8 | uint8_t(data[2 * i + 1]);
        if (sample > levels) return tl::unexpected(fmt::format("the sample {} is greater than the maximum {}", sample, levels));
        values[i] = float(double(sample) / levels);
    }
    return {};
}

Result<Stored> decode_integers(Words& words, char kind, size_t file_bytes) {
    uint32_t width = 0, height = 0, levels = 0;
    if (!words.next(width) || !words.next(height) || !words.next(levels)) return tl::unexpected(std::string("broken PPM header"));
    if (levels < 1 || levels > 65535) return tl::unexpected(fmt::format("the maximum sample {} is not in 1 .. 65535", levels));
    const bool color = kind == '3' || kind == '6';
    if (auto fits = check_size(width, height, color ? 3 : 1, file_bytes); !fits) return tl::unexpected(fits.error());
    Stored stored{make_picture(width, height, color), levels};
    const bool plain = kind == '2' || kind == '3';
    const Result<void> read =
        plain ? read_plain(words, levels, stored.picture.values) : read_raw(words.after_header(), levels, stored.picture.values);
    if (!read) return tl::unexpected(read.error());
    return stored;
}

/// The third word's sign is the byte order: negative is little-endian. Its size is a scale that nobody applies. Rows stand from the bottom.
Result<Stored> decode_floats(Words& words, bool color, size_t file_bytes) {
    uint32_t width = 0, height = 0;
    float scale = 0;
    if (!words.next(width) || !words.next(height) || !words.next(scale) || scale == 0) return tl::unexpected(std::string("broken PFM header"));
    if (auto fits = check_size(width, height, color ? 3 : 1, file_bytes); !fits) return tl::unexpected(fits.error());
    Picture picture = make_picture(width, height, color);
    const std::string_view data = words.after_header();
    if (data.size() / sizeof(float) < picture.values.size()) return tl::unexpected(std::string(kEndsEarly));

    const bool swap = (scale < 0) != (std::endian::native == std::endian::little);
    const size_t row = size_t(picture.width) * size_t(picture.channels);
    for (size_t y = 0; y < height; ++y) {
        float* out = picture.at(0, int(height - 1 - y));
        std::memcpy(out, data.data() + y * row * sizeof(float), row * sizeof(float));
        for (size_t i = 0; swap && i < row; ++i) {
            const auto bits = std::bit_cast<std::array<char, 4>>(out[i]);
            out[i] = std::bit_cast<float>(std::array<char, 4>{bits[3], bits[2], bits[1], bits[0]});
        }
    }
    return Stored{std::move(picture), 0};
}

void append(Bytes& bytes, const void* data, size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

}  // namespace

Result<Stored> decode_pnm(std::span<const std::byte> bytes) {
    Words words(bytes);
    const std::string_view magic = words.next();
    if (magic == "PF" || magic == "Pf") return decode_floats(words, magic == "PF", bytes.size());
    if (magic == "P2" || magic == "P3" || magic == "P5" || magic == "P6") return decode_integers(words, magic[1], bytes.size());
    return tl::unexpected(std::string("broken PPM header"));
}

namespace {

/// What a PPM file holds of a picture.
Result<ColorChannels> ppm_colors(const Picture& picture) {
    ColorChannels colors = color_channels(picture);
    if (colors.count == 0) return tl::unexpected(std::string("PPM holds colour, but the picture has no channels R, G, B or Y"));
    colors.count = 3;   // gray is written as three equal channels
    colors.alpha = -1;  // what is left of a premultiplied colour without its alpha is the picture over black
    return colors;
}

Bytes ppm(const Picture& picture, int most, const void* codes, size_t size) {
    Bytes bytes;
    const std::string header = fmt::format("P6\n{} {}\n{}\n", picture.width, picture.height, most);
    append(bytes, header.data(), header.size());
    append(bytes, codes, size);
    return bytes;
}

}  // namespace

Result<Bytes> encode_ppm(const Picture& picture) {
    const auto colors = ppm_colors(picture);
    if (!colors) return tl::unexpected(colors.error());
    const std::vector<uint8_t> codes = encode_8bit(picture, *colors, false);
    return ppm(picture, 255, codes.data(), codes.size());
}

Result<Bytes> encode_deep_ppm(const Picture& picture) {
    const auto colors = ppm_colors(picture);
    if (!colors) return tl::unexpected(colors.error());
    std::vector<uint8_t> bytes;   // the upper one first
    for (const uint16_t code : encode_16bit(picture, *colors, false)) bytes.push_back(uint8_t(code >> 8)), bytes.push_back(uint8_t(code));
    return ppm(picture, 65535, bytes.data(), bytes.size());
}

Result<Bytes> encode_pfm(const Picture& picture) {
    ColorChannels colors = color_channels(picture);
    if (colors.count == 0) return tl::unexpected(std::string("PFM holds colour, but the picture has no channels R, G, B or Y"));
    Bytes bytes;
    const bool little = std::endian::native == std::endian::little;
    const std::string header = fmt::format("{}\n{} {}\n{}\n", colors.count == 3 ? "PF" : "Pf", picture.width, picture.height, little ? "-1.0" : "1.0");
    append(bytes, header.data(), header.size());
    for (int y = picture.height - 1; y >= 0; --y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < colors.count; ++c) append(bytes, picture.at(x, y) + colors.index[c], sizeof(float));
    return bytes;
}

}  // namespace alidade::image
