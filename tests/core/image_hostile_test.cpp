// SPDX-License-Identifier: Apache-2.0
/// Broken picture files: an error each, never a crash, never memory for what a file merely claims.
#include "core/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <random>

namespace alidade {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::byte>;

Bytes bytes_of(std::string_view text) {
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

Picture noise(int width, int height) {
    Picture picture(width, height, {"R", "G", "B", "A"});
    std::mt19937 random(5);
    for (float& value : picture.values) value = std::uniform_real_distribution<float>(0, 1)(random);
    return picture;
}

/// The bytes of a small picture in the format of `ending`.
Bytes sample_file(const std::string& ending) {
    const std::string path = testing::TempDir() + "alidade-sample-" + std::to_string(getpid()) + ending;
    EXPECT_TRUE(write_picture(path, noise(9, 7)));
    Bytes bytes = *read_file(path);
    unlink(path.c_str());
    return bytes;
}

std::string error_of(const Bytes& bytes) {
    const auto picture = decode_picture(bytes, Encoding::automatic);
    return picture ? "read" : picture.error();
}

class EveryFormat : public testing::TestWithParam<const char*> {};

TEST_P(EveryFormat, TruncatedAnywhereIsAnError) {
    const Bytes whole = sample_file(GetParam());
    ASSERT_EQ(error_of(whole), "read");
    for (size_t length = 0; length < whole.size(); ++length) {
        const auto picture = decode_picture(std::span(whole).first(length), Encoding::automatic);
        ASSERT_FALSE(picture) << "of " << whole.size() << " bytes only " << length << " were there";
        ASSERT_FALSE(picture.error().empty());
    }
}

/// What is read in spite of the damage must at least be whole: as many values as it says, one name a channel.
TEST_P(EveryFormat, DamagedAnywhereIsAnErrorOrAPicture) {
    const Bytes whole = sample_file(GetParam());
    std::mt19937 random(11);
    size_t refused = 0;
    for (size_t round = 0; round < 4000; ++round) {
        Bytes damaged = whole;
        // Every byte once, then several at once.
        damaged[round % whole.size()] = std::byte(random());
        for (size_t more = round / whole.size(); more > 0; --more) damaged[random() % whole.size()] = std::byte(random());
        const auto picture = decode_picture(damaged, Encoding::automatic);
        if (!picture) {
            ++refused;
            continue;
        }
        ASSERT_EQ(picture->values.size(), size_t(picture->width) * size_t(picture->height) * size_t(picture->channels));
        ASSERT_EQ(picture->names.size(), size_t(picture->channels));
    }
    EXPECT_GT(refused, 100u) << "the damage must matter";
}

INSTANTIATE_TEST_SUITE_P(Own, EveryFormat, testing::Values(".png", ".exr", ".ppm", ".pfm"),
                         [](const auto& info) { return std::string(info.param + 1); });

TEST(HostileImages, ThatAreNoPictures) {
    EXPECT_THAT(error_of({}), HasSubstr("empty"));
    EXPECT_THAT(error_of(bytes_of("hello, world, this is no picture at all")), HasSubstr("no picture format"));
    EXPECT_THAT(error_of(bytes_of("P6")), HasSubstr("header"));
    EXPECT_THAT(error_of(bytes_of("P6 2 2 0 aaaaaaaaaaaa")), HasSubstr("maximum sample"));
    EXPECT_THAT(error_of(bytes_of("P6 -2 2 255 aaaaaaaaaaaa")), HasSubstr("header"));
    EXPECT_THAT(error_of(bytes_of("P2 2 1 255 12 x")), HasSubstr("not a number"));
    EXPECT_THAT(error_of(bytes_of("P2 2 1 9 12 3")), HasSubstr("12 is greater than the maximum 9"));
    EXPECT_THAT(error_of(bytes_of("PF 1 1 0 aaaaaaaaaaaa")), HasSubstr("header"));
    EXPECT_THAT(error_of(bytes_of("PF 0 1 1 aaaaaaaaaaaa")), HasSubstr("0 x 1 pixels"));
}

/// The PNG's width or the EXR's data window says more than the file can hold: refused, and without asking for the memory first.
TEST(HostileImages, ClaimsAreNotBelieved) {
    EXPECT_THAT(error_of(bytes_of("P5 900000 900000 255 aaaa")), HasSubstr("limit"));
    EXPECT_THAT(error_of(bytes_of("P5 30000 30000 255 aaaa")), HasSubstr("has only"));
    EXPECT_THAT(error_of(bytes_of("P5 99999999999999999999 1 255 aaaa")), HasSubstr("header"));
    EXPECT_THAT(error_of(bytes_of("PF 20000 10000 -1 aaaa")), HasSubstr("has only"));

    Bytes exr = sample_file(".exr");
    for (const std::string_view window : {"dataWindow", "displayWindow"}) {
        Bytes claims = exr;
        const std::string_view text(reinterpret_cast<const char*>(claims.data()), claims.size());
        const size_t value = text.find(window) + window.size() + 1 + std::strlen("box2i") + 1 + 4;   // name, type, size, then xMin yMin xMax yMax
        for (const int32_t side : {0x7ffffffe, 1 << 20, 30000}) {
            std::memcpy(claims.data() + value + 8, &side, 4);
            std::memcpy(claims.data() + value + 12, &side, 4);
            EXPECT_NE(error_of(claims), "read") << window << " " << side;
        }
    }
    EXPECT_LT(mallinfo2().hblkhd, size_t(64) << 20) << "large blocks are still held";
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    EXPECT_LT(usage.ru_maxrss, 1 << 20) << "kB: memory was filled for a claim";
}

TEST(Pnm, PlainAndRawAnd16BitAgree) {
    const std::string header = "# a comment\n2 # another\n 2\n";
    const auto plain = decode_picture(bytes_of("P2\n" + header + "1000\n0 1000\n 500\t7\n"), Encoding::linear);
    const std::string raw("\x00\x00\x03\xe8\x01\xf4\x00\x07", 8);
    const auto binary = decode_picture(bytes_of("P5\n" + header + "1000\n" + raw), Encoding::linear);
    ASSERT_TRUE(plain) << plain.error();
    ASSERT_TRUE(binary) << binary.error();
    EXPECT_EQ(plain->values, (std::vector<float>{0, 1, 0.5f, 0.007f}));
    EXPECT_EQ(binary->values, plain->values);
    EXPECT_EQ(plain->names, std::vector<std::string>{"Y"});
    const auto curved = decode_picture(bytes_of("P2\n" + header + "1000\n0 1000\n 500\t7\n"), Encoding::automatic);
    for (size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(curved->values[i], float(srgb_to_linear(double(plain->values[i]))));
}

TEST(Pfm, BothByteOrdersAndRowsFromTheBottom) {
    const std::string little("\x00\x00\x80\x3f\x00\x00\x00\x40", 8), big("\x3f\x80\x00\x00\x40\x00\x00\x00", 8);   // 1, then 2
    for (const std::string& file : {"Pf 1 2 -1.0\n" + little, "Pf 1 2 1.0\n" + big}) {
        const auto picture = decode_picture(bytes_of(file), Encoding::automatic);
        ASSERT_TRUE(picture) << picture.error();
        EXPECT_EQ(picture->values, (std::vector<float>{2, 1})) << "the file's first row is the lowest";
    }
}

}  // namespace
}  // namespace alidade
