// SPDX-License-Identifier: Apache-2.0
/// Pictures that go through the OpenImageIO module. A program of its own: once the module is open, it stays so.
#include "core/image.h"
#include "tests/core/gif.h"
#include "tests/core/jpeg.h"
#include "tests/core/run_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <random>

namespace alidade {
namespace {

using namespace test;
using testing::HasSubstr;

class ModuleFiles : public testing::Test {
  protected:
    std::string path(const char* ending) const { return testing::TempDir() + "alidade-module-" + std::to_string(getpid()) + ending; }
    void TearDown() override {
        for (const char* ending : {".png", ".exr", ".jpg", ".webp", ".tif", ".hdr", ".tga", ".bmp"}) unlink(path(ending).c_str());
    }
};

bool maps_mention(const std::string& library) {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);)
        if (line.find(library) != std::string::npos) return true;
    return false;
}

/// Smooth, so that lossy formats come close; with alpha if asked. Premultiplied, as pictures in memory are that are to be written.
Picture gradient(bool with_alpha) {
    Picture picture(32, 24, with_alpha ? std::vector<std::string>{"R", "G", "B", "A"} : std::vector<std::string>{"R", "G", "B"});
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x) {
            const float alpha = with_alpha ? float(x + 1) / 32 : 1.0f;
            const float straight[] = {float(x) / 31, float(y) / 23, 0.5f};
            for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = straight[c] * alpha;
            if (with_alpha) picture.at(x, y)[3] = alpha;
        }
    return picture;
}

struct Errors {
    double largest = 0, mean = 0;
};

/// Differences in sRGB-encoded values of colour, after `written`'s alpha was divided out.
Errors color_errors(const Picture& read, const Picture& written) {
    Errors errors;
    for (int y = 0; y < read.height; ++y)
        for (int x = 0; x < read.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double alpha = written.channels == 4 && read.channels == 4 ? written.at(x, y)[3] : 1;
                const double error = std::abs(linear_to_srgb(read.at(x, y)[c]) - linear_to_srgb(written.at(x, y)[c] / alpha));
                errors.largest = std::max(errors.largest, error);
                errors.mean += error / (3.0 * read.width * read.height);
            }
    return errors;
}

/// A lossless WebP of `width` x `height` equal pixels, by RFC 9649: five prefix codes of one symbol each, after which pixels take no bits.
std::vector<std::byte> uniform_webp(unsigned width, unsigned height, const std::array<unsigned, 4>& rgba) {
    std::vector<unsigned char> data = {0x2f};
    unsigned bit = 8;
    const auto put = [&](unsigned value, unsigned bits) {
        for (unsigned i = 0; i < bits; ++i, ++bit) {
            if (bit / 8 == data.size()) data.push_back(0);
            data[bit / 8] |= static_cast<unsigned char>((value >> i & 1) << bit % 8);
        }
    };
    put(width - 1, 14), put(height - 1, 14), put(1, 1), put(0, 3);   // alpha is used, version 0
    put(0, 3);                                                       // no transform, colour cache or meta prefix codes
    for (const unsigned symbol : {rgba[1], rgba[0], rgba[2], rgba[3]}) put(1, 1), put(0, 1), put(1, 1), put(symbol, 8);
    put(1, 1), put(0, 1), put(0, 1), put(0, 1);                      // distances: the symbol 0
    if (data.size() % 2) data.push_back(0);
    const unsigned size = unsigned(data.size());
    std::string file = "RIFF____WEBPVP8L____";
    for (unsigned i = 0; i < 4; ++i) file[4 + i] = char((size + 12) >> 8 * i), file[16 + i] = char(size >> 8 * i);
    file.append(data.begin(), data.end());
    const auto* begin = reinterpret_cast<const std::byte*>(file.data());
    return {begin, begin + file.size()};
}

TEST_F(ModuleFiles, IsOpenedByTheFirstPictureThatNeedsIt) {
    ASSERT_FALSE(image_module_loaded());
    for (const char* ending : {".png", ".exr"}) {
        ASSERT_TRUE(write_picture(path(ending), gradient(false)));
        ASSERT_TRUE(read_picture(path(ending), Encoding::automatic));
    }
    ASSERT_TRUE(decode_picture(jpeg_file({}), Encoding::automatic));
    const std::string gif = gif_file({1, 1}, std::string(12, '\1'), gif_frame({1, 1}, std::string(1, '\1')));
    ASSERT_TRUE(decode_picture(std::as_bytes(std::span(gif)), Encoding::automatic));
    EXPECT_FALSE(write_picture(path(".xyz"), gradient(false)));
    EXPECT_FALSE(image_module_loaded());
    EXPECT_FALSE(maps_mention("libOpenImageIO")) << "the program itself must not link it";

    const auto written = write_picture(path(".jpg"), gradient(false));
    ASSERT_TRUE(written) << written.error();
    EXPECT_TRUE(image_module_loaded());
    EXPECT_TRUE(maps_mention("libOpenImageIO"));
}

TEST_F(ModuleFiles, EveryWrittenFormatIsReadBack) {
    const struct { const char* ending; bool alpha; Errors allowed; } rows[] = {
        {".jpg", false, {0.15, 0.02}},   {".webp", false, {0.15, 0.02}}, {".tif", true, {0.003, 0.003}},
        {".tga", true, {0.003, 0.003}}, {".bmp", true, {0.003, 0.003}}, {".hdr", false, {0.015, 0.005}}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.ending);
        for (const bool with_alpha : {false, true}) {
            if (with_alpha && !row.alpha) continue;
            const Picture picture = gradient(with_alpha);
            const auto written = write_picture(path(row.ending), picture);
            ASSERT_TRUE(written) << written.error();
            const auto read = read_picture(path(row.ending), Encoding::automatic);
            ASSERT_TRUE(read) << read.error();
            ASSERT_EQ(read->width, 32);
            ASSERT_EQ(read->height, 24);
            ASSERT_EQ(read->names, picture.names);
            const Errors errors = color_errors(*read, picture);
            EXPECT_LT(errors.largest, row.allowed.largest);
            EXPECT_LT(errors.mean, row.allowed.mean);
            for (int x = 0; with_alpha && x < 32; ++x) EXPECT_NEAR(read->at(x, 5)[3], float(x + 1) / 32, 0.003) << x;
        }
    }
}

TEST_F(ModuleFiles, EachPixelOfAJpegHasItsOwnColour) {
    Picture stripes(32, 24, {"R", "G", "B"});
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x) stripes.at(x, y)[x % 2 ? 0 : 2] = 0.8f;
    ASSERT_TRUE(write_picture(path(".jpg"), stripes));
    const auto read = read_picture(path(".jpg"), Encoding::automatic);
    ASSERT_TRUE(read) << read.error();
    EXPECT_LT(color_errors(*read, stripes).mean, 0.02);
}

TEST_F(ModuleFiles, AlphaThatTheFormatLacksLeavesThePictureOverBlack) {
    const Picture picture = gradient(true);
    ASSERT_TRUE(write_picture(path(".jpg"), picture));
    const auto read = read_picture(path(".jpg"), Encoding::automatic);
    ASSERT_TRUE(read) << read.error();
    ASSERT_EQ(read->channels, 3);
    EXPECT_LT(color_errors(*read, picture).mean, 0.02);
}

TEST_F(ModuleFiles, WebpAlphaIsStraight) {
    for (const auto& rgba : {std::array<unsigned, 4>{200, 100, 50, 255}, {200, 100, 50, 128}, {255, 0, 20, 64}}) {
        const auto read = decode_picture(uniform_webp(5, 3, rgba), Encoding::linear);
        ASSERT_TRUE(read) << read.error();
        ASSERT_EQ(read->channels, 4);
        EXPECT_EQ(read->width, 5);
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(read->at(4, 2)[c] * 255, rgba[size_t(c)], 0.5 * 255 / rgba[3] + 0.01) << c;
    }
}

TEST_F(ModuleFiles, FloatsStayLinear) {
    Picture picture = gradient(false);
    for (float& value : picture.values) value = value * 40 + 0.25f;
    ASSERT_TRUE(write_picture(path(".hdr"), picture));
    const auto read = read_picture(path(".hdr"), Encoding::automatic);
    ASSERT_TRUE(read) << read.error();
    for (size_t i = 0; i < picture.values.size(); ++i) ASSERT_NEAR(read->values[i], picture.values[i], 0.26) << i;   // 8 bits at an exponent for 64
}

TEST_F(ModuleFiles, SamePictureSameBytes) {
    for (const char* ending : {".jpg", ".webp", ".tif", ".tga", ".bmp", ".hdr"}) {
        ASSERT_TRUE(write_picture(path(ending), gradient(false)));
        const auto first = read_file(path(ending));
        sleep(ending == std::string(".tif") ? 1 : 0);   // TIFF can hold the time of day
        ASSERT_TRUE(write_picture(path(ending), gradient(false)));
        EXPECT_EQ(*read_file(path(ending)), *first) << ending;
    }
}

TEST_F(ModuleFiles, TruncatedOrDamagedIsAnErrorOrAPicture) {
    for (const char* ending : {".jpg", ".webp", ".tga", ".bmp", ".hdr", ".tif"}) {
        SCOPED_TRACE(ending);
        ASSERT_TRUE(write_picture(path(ending), gradient(false)));
        const std::vector<std::byte> whole = *read_file(path(ending));
        const std::vector<float> pixels = decode_picture(whole, Encoding::automatic)->values;
        for (size_t length = 0; length < whole.size(); length += run_scale() < 1 ? 101 : 7) {
            const auto picture = decode_picture(std::span(whole).first(length), Encoding::automatic);
            ASSERT_TRUE(!picture || picture->values == pixels) << "half a picture, of " << length << " bytes, was taken for a whole one";
        }
        std::mt19937 random(1);
        for (int round = 0; round < 200; round += run_scale() < 1 ? 10 : 1) {
            std::vector<std::byte> damaged = whole;
            for (int i = 0; i <= round / 70; ++i) damaged[random() % std::min<size_t>(damaged.size(), 300)] = std::byte(random());
            const auto picture = decode_picture(damaged, Encoding::automatic);
            if (picture) {
                ASSERT_EQ(picture->values.size(), size_t(picture->width) * size_t(picture->height) * size_t(picture->channels));
            }
        }
    }
}

std::string frame_of(const std::string& numbers, bool interlaced, const std::string& own_colors = "") { return gif_frame({3, 5}, numbers, interlaced, own_colors); }
std::string gif_of(const std::string& frames, char screen_width = 3) { return gif_file({screen_width, 5}, std::string("\1\2\3\x40\x50\x60\x90\xa0\xb0\xf0\xe0\xd0", 12), frames); }

StoredPicture decoded(const std::string& bytes) {
    auto stored = decode_stored_picture(std::as_bytes(std::span(bytes)));
    EXPECT_TRUE(stored) << stored.error();
    return stored ? std::move(*stored) : StoredPicture();
}

const std::string kRows("\0\1\2\3\0\1\2\3\0\1\1\1\3\2\0", 15);
const std::string kInterlacedRows = kRows.substr(0, 3) + kRows.substr(12, 3) + kRows.substr(6, 3) + kRows.substr(3, 3) + kRows.substr(9, 3);   // 0 4 2 1 3

TEST(GifPalette, GivesNumbersAndColorsOfTheFirstPicture) {
    const std::vector<uint8_t> numbers(kRows.begin(), kRows.end());
    const std::string other = frame_of(std::string(15, '\3'), false), local("\x10\2\3\x20\x50\x60\x30\xa0\xb0\x50\xe0\xd0", 12);
    const std::string told = std::string("\x21\xfe\3abc\0", 7) + gif_clear(2);   // a comment; number 2 is transparent
    const struct {
        std::string frames;
        std::array<int, 4> reds;
        int clear;
    } cases[] = {{frame_of(kRows, false) + other, {1, 0x40, 0x90, 0xf0}, -1},
                 {frame_of(kInterlacedRows, true) + other, {1, 0x40, 0x90, 0xf0}, -1},
                 {frame_of(kRows, false, local) + other, {0x10, 0x20, 0x30, 0x50}, -1},
                 {told + frame_of(kRows, false), {1, 0x40, 0x90, 0xf0}, 2}};
    for (const auto& c : cases) {
        const StoredPicture stored = decoded(gif_of(c.frames));
        EXPECT_EQ(stored.format, "gif");
        ASSERT_EQ(stored.palette, numbers);
        ASSERT_EQ(stored.picture.channels, 4);
        for (int i = 0; i < 15; ++i) {
            const int number = numbers[size_t(i)];
            EXPECT_FLOAT_EQ(stored.picture.at(i % 3, i / 3)[0] * 255, float(c.reds[size_t(number)])) << i;
            EXPECT_EQ(stored.picture.at(i % 3, i / 3)[3], number == c.clear ? 0 : 1) << i;
        }
    }
    EXPECT_TRUE(decoded(gif_of(frame_of(kRows, false), 4)).palette.empty()) << "the picture does not fill the screen";
}

/// Equal numbers have equal colours, or there are none; nor are there any of a picture that is not whole.
TEST(GifPalette, DamagedHasAllNumbersOrNone) {
    std::mt19937 random(1);
    const std::string whole = gif_of(frame_of(kRows, false));
    const size_t last_number = whole.size() - 4;
    for (size_t round = 0; round < 3000; round += run_scale() < 1 ? 20 : 1) {
        std::string damaged = round < whole.size() ? whole.substr(0, round) : whole;
        for (size_t i = whole.size(); i < round; i += 500) damaged[6 + random() % (damaged.size() - 6)] = char(random());
        const auto stored = decode_stored_picture(std::as_bytes(std::span(damaged)));
        if (!stored || stored->palette.empty()) continue;
        ASSERT_GE(round, last_number) << "of a part of the file";
        std::array<const float*, 256> seen{};
        for (size_t i = 0; i < stored->palette.size(); ++i) {
            const float* const here = &stored->picture.values[i * size_t(stored->picture.channels)];
            const float*& first = seen[stored->palette[i]];
            if (!first) first = here;
            ASSERT_TRUE(std::equal(here, here + 3, first)) << round;
        }
    }
}

/// Where the module is missing, the error says what is missing and where it was looked for.
TEST(MissingModule, IsNamed) {
    const auto without_module = [] {
        setenv("ALIDADE_MODULES", "/no/such/folder", 1);
        const auto picture = decode_picture(std::as_bytes(std::span("RIFF    WEBPVP8 ")), Encoding::automatic);
        std::fprintf(stderr, "%s\n", picture ? "read" : picture.error().c_str());
        std::exit(image_module_loaded() ? 1 : 0);
    };
    testing::FLAGS_gtest_death_test_style = "threadsafe";   // in a new process: in this one the module may be open
    EXPECT_EXIT(without_module(), testing::ExitedWithCode(0), "alidade_oiio.so.*not in /no/such/folder.*ALIDADE_MODULES");
}

}  // namespace
}  // namespace alidade
