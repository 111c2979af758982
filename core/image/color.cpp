// SPDX-License-Identifier: Apache-2.0
/// The sRGB curve, and the way from linear floats to 8-bit codes.
#include "core/image_colors.h"

#include "core/image/codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace alidade {

// Both directions: IEC 61966-2-1:1999.
double srgb_to_linear(double encoded) { return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4); }
double linear_to_srgb(double linear) { return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055; }

std::vector<int> color_channels(const Picture& picture) {
    const image::ColorChannels found = image::color_channels(picture);
    std::vector<int> all(found.index, found.index + found.count);
    if (found.count > 0 && found.alpha >= 0) all.push_back(found.alpha);
    return all;
}

Picture select_channels(const Picture& picture, const std::vector<int>& from, std::vector<std::string> names) {
    Picture out(picture.width, picture.height, std::move(names));
    size_t at = 0;
    for (size_t p = 0; p < size_t(picture.width) * size_t(picture.height); ++p)
        for (const int c : from) out.values[at++] = picture.values[p * size_t(picture.channels) + size_t(c)];
    return out;
}

tl::expected<Picture, std::string> colors_alone(Picture picture) {
    const std::vector<int> from = color_channels(picture);
    if (from.empty()) return tl::unexpected(fmt::format("it has no channels R, G, B or Y: its channels are {}", fmt::join(picture.names, ", ")));
    std::vector<std::string> names;
    for (const int c : from) names.push_back(picture.names[size_t(c)]);
    return names == picture.names ? std::move(picture) : select_channels(picture, from, std::move(names));
}

namespace image {
namespace {

/// The code whose encoded value k / 255 is nearest to linear_to_srgb(a linear value). Asked of the inverse curve at the 255 midpoints, so it is monotonic by construction and needs no power;
/// a value's exponent and five digits more tell all but the last two steps.
class SrgbCodes {
  public:
    SrgbCodes() {
        for (size_t k = 0; k < kMidpoints; ++k) midpoints_[k] = float(srgb_to_linear((double(k) + 0.5) / 255));
        midpoints_[kMidpoints] = std::numeric_limits<float>::infinity();
        for (uint32_t i = 0; i < kSteps; ++i) {
            const float least = std::bit_cast<float>((kFirst + i) << kDropped);
            first_[i] = uint8_t(std::upper_bound(midpoints_.begin(), midpoints_.end(), least) - midpoints_.begin());
        }
    }
    uint8_t of(float linear) const {
        if (!(linear > kLeast)) return 0;
        if (linear >= 1) return 255;
        uint8_t code = first_[(std::bit_cast<uint32_t>(linear) >> kDropped) - kFirst];
        while (linear >= midpoints_[code]) ++code;
        return code;
    }

  private:
    static constexpr float kLeast = 0x1p-13f;   // below the first midpoint
    static constexpr size_t kMidpoints = 255;
    static constexpr uint32_t kDropped = 18, kFirst = std::bit_cast<uint32_t>(kLeast) >> kDropped, kSteps = (std::bit_cast<uint32_t>(1.0f) >> kDropped) - kFirst;
    std::array<float, kMidpoints + 1> midpoints_{};
    std::array<uint8_t, kSteps> first_{};
};

uint8_t linear_code(float value) { return uint8_t(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); }

/// Of 16 bits; NaN is 0.
uint16_t deep_code(double encoded) { return encoded > 0 ? uint16_t(std::min(encoded, 1.0) * 65535 + 0.5) : uint16_t(0); }

}  // namespace

ColorChannels color_channels(const Picture& picture) {
    auto find = [&](const char* name) {
        const auto at = std::find(picture.names.begin(), picture.names.end(), name);
        return at == picture.names.end() ? -1 : int(at - picture.names.begin());
    };
    ColorChannels found{3, {find("R"), find("G"), find("B")}, find("A")};
    if (found.index[0] < 0 || found.index[1] < 0 || found.index[2] < 0) {
        const int y = find("Y");
        found = {y < 0 ? 0 : 1, {y, y, y}, found.alpha};
    }
    return found;
}

std::vector<float> straight_colors(const Picture& picture, const ColorChannels& colors, bool with_alpha) {
    const size_t pixels = size_t(picture.width) * size_t(picture.height);
    std::vector<float> out(pixels * size_t(colors.count + with_alpha));
    float* to = out.data();
    for (size_t p = 0; p < pixels; ++p) {
        const float* pixel = &picture.values[p * size_t(picture.channels)];
        const float alpha = colors.alpha < 0 ? 1.0f : pixel[colors.alpha];
        for (int c = 0; c < colors.count; ++c) *to++ = alpha == 0 || alpha == 1 ? pixel[colors.index[c]] : pixel[colors.index[c]] / alpha;
        if (with_alpha) *to++ = alpha;
    }
    return out;
}

std::vector<uint8_t> encode_8bit(const Picture& picture, const ColorChannels& colors, bool with_alpha) {
    static const SrgbCodes srgb;
    const std::vector<float> values = straight_colors(picture, colors, with_alpha);
    std::vector<uint8_t> codes(values.size());
    for (size_t i = 0; i < values.size();) {
        for (int c = 0; c < colors.count; ++c, ++i) codes[i] = srgb.of(values[i]);
        if (with_alpha) codes[i] = std::isnan(values[i]) ? uint8_t(0) : linear_code(values[i]), ++i;
    }
    return codes;
}

std::vector<uint16_t> encode_16bit(const Picture& picture, const ColorChannels& colors, bool with_alpha) {
    const std::vector<float> values = straight_colors(picture, colors, with_alpha);
    std::vector<uint16_t> codes(values.size());
    for (size_t i = 0; i < values.size();) {
        for (int c = 0; c < colors.count; ++c, ++i) codes[i] = deep_code(linear_to_srgb(double(values[i])));
        if (with_alpha) codes[i] = deep_code(double(values[i])), ++i;
    }
    return codes;
}

}  // namespace image
}  // namespace alidade
