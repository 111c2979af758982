// SPDX-License-Identifier: Apache-2.0
/// Every kind of PNG that the standard knows, written by libpng with known samples.
#include "core/deep_png.h"
#include "core/image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <random>

namespace alidade {
namespace {

struct Kind {
    const char* name;
    int color_type, bits;
    bool transparency;   ///< with a tRNS chunk
    bool interlaced;
};

constexpr int kWidth = 13, kHeight = 11;   // all seven passes of Adam7 are different

struct Sampled {
    std::vector<std::byte> file;
    std::vector<unsigned> samples;   ///< as stored, channels interleaved
};

int channels_of(int color_type) {
    switch (color_type) {
        case PNG_COLOR_TYPE_RGB: return 3;
        case PNG_COLOR_TYPE_RGB_ALPHA: return 4;
        case PNG_COLOR_TYPE_GRAY_ALPHA: return 2;
        default: return 1;
    }
}

png_color palette_entry(unsigned i) { return {png_byte(i * 7 + 3), png_byte(255 - i), png_byte(i * 31)}; }
constexpr png_byte kPaletteAlpha[] = {0, 100, 200};   // the entries after these are opaque
constexpr unsigned kKey = 1;                           // the sample that tRNS makes transparent in gray and true-colour pictures

void put(png_structp png, png_bytep data, size_t size) {
    auto* out = static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
    out->insert(out->end(), reinterpret_cast<std::byte*>(data), reinterpret_cast<std::byte*>(data) + size);
}

std::vector<std::vector<png_byte>> pack_rows(const std::vector<unsigned>& samples, int channels, int bits) {
    std::vector<std::vector<png_byte>> rows;
    const size_t per_row = size_t(kWidth * channels);
    for (size_t y = 0; y < kHeight; ++y) {
        std::vector<png_byte> row((per_row * size_t(bits) + 7) / 8);
        for (size_t i = 0; i < per_row; ++i) {
            const unsigned s = samples[y * per_row + i];
            if (bits == 16) row[2 * i] = png_byte(s >> 8), row[2 * i + 1] = png_byte(s);
            else row[i * size_t(bits) / 8] |= png_byte(s << (8 - size_t(bits) - i * size_t(bits) % 8));
        }
        rows.push_back(row);
    }
    return rows;
}

Sampled make_png(const Kind& kind) {
    Sampled out;
    const int channels = channels_of(kind.color_type);
    std::mt19937 random{unsigned(kind.bits)};
    out.samples.resize(size_t(kWidth * kHeight * channels));
    for (unsigned& s : out.samples) s = unsigned(random()) & ((1u << kind.bits) - 1);
    std::fill_n(out.samples.begin(), channels, kKey);   // the first pixel is the key colour

    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &out.file, put, nullptr);
    png_set_IHDR(png, info, kWidth, kHeight, kind.bits, kind.color_type, kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_color> palette;
    for (unsigned i = 0; i < 1u << std::min(kind.bits, 8); ++i) palette.push_back(palette_entry(i));
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), int(palette.size()));
    const png_color_16 key{0, kKey, kKey, kKey, kKey};
    const bool in_palette = kind.color_type == PNG_COLOR_TYPE_PALETTE;
    const int palette_alphas = std::min(3, 1 << kind.bits);
    if (kind.transparency) png_set_tRNS(png, info, in_palette ? kPaletteAlpha : nullptr, in_palette ? palette_alphas : 0, in_palette ? nullptr : &key);
    png_set_gAMA(png, info, 0.9);   // which must not be applied
    png_write_info(png, info);
    auto rows = pack_rows(out.samples, channels, kind.bits);
    std::vector<png_bytep> pointers;
    for (auto& row : rows) pointers.push_back(row.data());
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return out;
}

/// What the standard says pixel `p` is, in 0..1: the stored samples over their maximum, looked up in the palette, with tRNS as alpha.
std::vector<float> expected_pixel(const Kind& kind, const Sampled& png, size_t p) {
    const size_t channels = size_t(channels_of(kind.color_type));
    const unsigned* s = &png.samples[p * channels];
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        const png_color c = palette_entry(s[0]);
        std::vector<float> out = {float(c.red / 255.0), float(c.green / 255.0), float(c.blue / 255.0)};
        if (kind.transparency) out.push_back(s[0] < 3 ? float(kPaletteAlpha[s[0]] / 255.0) : 1.0f);
        return out;
    }
    std::vector<float> out;
    bool is_key = true;
    for (size_t c = 0; c < channels; ++c) {
        out.push_back(float(s[c] / double((1 << kind.bits) - 1)));
        is_key = is_key && s[c] == kKey;
    }
    if (kind.transparency) out.push_back(is_key ? 0.0f : 1.0f);
    return out;
}

std::vector<Kind> all_kinds() {
    std::vector<Kind> kinds;
    for (const bool interlaced : {false, true}) {
        for (const bool transparency : {false, true}) {
            for (const int bits : {1, 2, 4, 8, 16}) kinds.push_back({"gray", PNG_COLOR_TYPE_GRAY, bits, transparency, interlaced});
            for (const int bits : {1, 2, 4, 8}) kinds.push_back({"palette", PNG_COLOR_TYPE_PALETTE, bits, transparency, interlaced});
            for (const int bits : {8, 16}) kinds.push_back({"rgb", PNG_COLOR_TYPE_RGB, bits, transparency, interlaced});
        }
        for (const int bits : {8, 16}) {
            kinds.push_back({"gray-alpha", PNG_COLOR_TYPE_GRAY_ALPHA, bits, false, interlaced});
            kinds.push_back({"rgba", PNG_COLOR_TYPE_RGB_ALPHA, bits, false, interlaced});
        }
    }
    return kinds;
}

class EveryPng : public testing::TestWithParam<Kind> {};

TEST_P(EveryPng, DecodesToItsSamples) {
    const Kind& kind = GetParam();
    const Sampled png = make_png(kind);
    const auto picture = decode_picture(png.file, Encoding::linear);
    ASSERT_TRUE(picture) << picture.error();
    ASSERT_EQ(picture->width, kWidth);
    ASSERT_EQ(picture->height, kHeight);
    for (size_t p = 0; p < kWidth * kHeight; ++p) {
        const float* pixel = &picture->values[p * size_t(picture->channels)];
        ASSERT_EQ(std::vector<float>(pixel, pixel + picture->channels), expected_pixel(kind, png, p)) << "pixel " << p;
    }
}

TEST_P(EveryPng, KeepsTheNumbersOfItsPalette) {
    const Sampled sampled = make_png(GetParam());
    const auto stored = decode_stored_picture(sampled.file);
    ASSERT_TRUE(stored) << stored.error();
    EXPECT_FALSE(stored->srgb) << "it does not say so";
    const std::vector<unsigned> numbers(stored->palette.begin(), stored->palette.end());
    EXPECT_EQ(numbers, GetParam().color_type == PNG_COLOR_TYPE_PALETTE ? sampled.samples : std::vector<unsigned>());
}

/// Automatic means sRGB for 8 and 16 bits; the curve is applied to colour and never to alpha.
TEST_P(EveryPng, DecodesColourByTheCurveButNotAlpha) {
    const Kind& kind = GetParam();
    const Sampled png = make_png(kind);
    const auto picture = decode_picture(png.file, Encoding::automatic);
    ASSERT_TRUE(picture) << picture.error();
    const bool has_alpha = picture->channels % 2 == 0;
    for (size_t p = 0; p < kWidth * kHeight; ++p) {
        const std::vector<float> stored = expected_pixel(kind, png, p);
        for (int c = 0; c < picture->channels; ++c) {
            const bool is_alpha = has_alpha && c == picture->channels - 1;
            const float want = is_alpha ? stored[size_t(c)] : float(srgb_to_linear(stored[size_t(c)]));
            ASSERT_NEAR(picture->values[p * size_t(picture->channels) + size_t(c)], want, 1e-6) << "pixel " << p << " channel " << c;
        }
    }
}

std::string kind_name(const testing::TestParamInfo<Kind>& info) {
    std::string name = info.param.name + std::to_string(info.param.bits);
    if (info.param.transparency) name += "_tRNS";
    if (info.param.interlaced) name += "_Adam7";
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Standard, EveryPng, testing::ValuesIn(all_kinds()), kind_name);

/// Half a step of 16 bits, wherever alpha is.
TEST(LinearPng, KeepsLinearValues) {
    Picture picture(5, 3, {"R", "G", "B", "A"});
    for (int i = 0; i < 15; ++i)
        for (int c = 0; c < 4; ++c) picture.values[size_t(4 * i + c)] = c == 3 ? float(i + 1) / 15 : float(i + 1) / 15 * float(i * (c + 1)) / 45;
    const auto bytes = encode_linear_png(picture);
    ASSERT_TRUE(bytes) << bytes.error();
    const auto stored = decode_stored_picture(*bytes);
    ASSERT_TRUE(stored) << stored.error();
    EXPECT_EQ(stored->levels, 65535u);
    EXPECT_EQ(stored->gamma, 1);
    for (int i = 0; i < 15; ++i) {
        const float* pixel = stored->picture.at(i % 5, i / 5);
        const double alpha = (i + 1) / 15.0;
        EXPECT_NEAR(double(pixel[3]), alpha, 0.51 / 65535);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(pixel[c]) * alpha, double(picture.values[size_t(4 * i + c)]), 1.1 / 65535);
    }
    EXPECT_FALSE(encode_linear_png(Picture(1, 1, {"Y"})));
    Picture odd(1, 1, {"R", "G", "B"});
    odd.values = {NAN, -INFINITY, INFINITY};
    EXPECT_EQ(decode_stored_picture(*encode_linear_png(odd))->picture.values, (std::vector<float>{0, 0, 1}));
}

/// Half a step of 16 bits of the standard's curve, in every kind of picture; alpha is straight and on no curve.
TEST(DeepPng, KeepsColoursToHalfAStep) {
    for (const std::vector<std::string>& names : {std::vector<std::string>{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}) {
        const bool with_alpha = names.back() == "A";
        Picture picture(5, 3, names);
        const int channels = picture.channels;
        for (int i = 0; i < 15 * channels; ++i) {
            const bool is_alpha = with_alpha && i % channels == channels - 1;
            picture.values[size_t(i)] = is_alpha ? 0.5f : float(i * i) / float(225 * channels * channels) * (with_alpha ? 0.5f : 1.0f);
        }
        const auto bytes = encode_picture(picture, ".png", 16);
        ASSERT_TRUE(bytes) << bytes.error();
        const auto stored = decode_stored_picture(*bytes);
        ASSERT_TRUE(stored) << stored.error();
        EXPECT_EQ(stored->levels, 65535u);
        EXPECT_TRUE(stored->srgb);
        ASSERT_EQ(stored->picture.names, names);
        for (int i = 0; i < 15 * channels; ++i) {
            const bool is_alpha = with_alpha && i % channels == channels - 1;
            const double linear = double(picture.values[size_t(i)]) / (with_alpha ? 0.5 : 1);
            EXPECT_NEAR(double(stored->picture.values[size_t(i)]), is_alpha ? 0.5 : linear_to_srgb(linear), 0.51 / 65535);
        }
    }
    Picture odd(1, 1, {"R", "G", "B"});
    odd.values = {NAN, -INFINITY, INFINITY};
    EXPECT_EQ(decode_stored_picture(*encode_picture(odd, ".png", 16))->picture.values, (std::vector<float>{0, 0, 1}));
    EXPECT_FALSE(encode_picture(Picture(1, 1, {"depth.Z"}), ".png", 16));
}

TEST(EncodePicture, GivesTheBytesOfAFile) {
    Picture picture(3, 2, {"R", "G", "B"});
    for (size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = float(srgb_to_linear(double(i * 14) / 255));
    const auto bytes = encode_picture(picture, ".png");
    ASSERT_TRUE(bytes);
    const auto codes = decode_picture(*bytes, Encoding::linear);
    ASSERT_TRUE(codes);
    for (size_t i = 0; i < picture.values.size(); ++i) EXPECT_FLOAT_EQ(codes->values[i], float(i * 14) / 255);
    EXPECT_EQ(encode_picture(Picture{}, ".png").error(), "the picture is empty");
    EXPECT_EQ(encode_picture(picture, "").error(), "the name has no ending that says which format to write");
}

}  // namespace
}  // namespace alidade
