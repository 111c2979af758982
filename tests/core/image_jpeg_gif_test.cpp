// SPDX-License-Identifier: Apache-2.0
/// JPEG and GIF, which are read without the module: against the module, where it is there.
#include "core/image/codec.h"
#include "tests/core/gif.h"
#include "tests/core/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace alidade {
namespace {

using namespace test;
using testing::HasSubstr;

std::vector<JpegKind> jpeg_kinds() {
    std::vector<JpegKind> kinds;
    for (const int components : {1, 3})
        for (const bool progressive : {false, true})
            for (const bool subsampled : {false, true}) kinds.push_back({.components = components, .progressive = progressive, .subsampled = subsampled, .restart_rows = subsampled ? 1 : 0});
    kinds.push_back({.width = 1, .height = 1}), kinds.push_back({.width = 640, .height = 8});
    return kinds;
}

TEST(Jpeg, HasThePixelsThatTheModuleReads) {
    for (const JpegKind& kind : jpeg_kinds()) {
        const std::vector<std::byte> bytes = jpeg_file(kind);
        const auto module = image::decode_by_module(bytes);
        if (!module) GTEST_SKIP() << module.error();
        const auto read = decode_stored_picture(bytes);
        ASSERT_TRUE(read) << read.error();
        EXPECT_EQ(read->format, "jpeg");
        EXPECT_EQ(read->levels, module->levels);
        EXPECT_EQ(read->picture.names, module->picture.names);
        EXPECT_EQ(read->picture.width, kind.width);
        ASSERT_EQ(read->picture.values, module->picture.values) << kind.components << " components, " << (kind.progressive ? "progressive" : "in one scan");
    }
}

TEST(Jpeg, OfFourComponentsIsReadByTheModule) {
    const auto read = decode_stored_picture(jpeg_file({.components = 4}));
    if (!read) GTEST_SKIP() << read.error();
    EXPECT_EQ(read->picture.channels, 3);
}

/// A directory with two entries, the second being the orientation 6.
TEST(Jpeg, TellsItsOrientation) {
    const std::string little("II*\0\x08\0\0\0\x02\0\x00\x01\x03\0\x01\0\0\0\x09\0\0\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0", 34), big("MM\0*\0\0\0\x08\0\x02\x01\x00\0\x03\0\0\0\x01\0\x09\0\0\x01\x12\0\x03\0\0\0\x01\0\x06\0\0", 34);
    for (const std::string& exif : {little, big}) {
        const auto read = decode_stored_picture(jpeg_file({.exif = exif}));
        ASSERT_TRUE(read);
        EXPECT_THAT(read->left_out, testing::ElementsAre(HasSubstr("its orientation (6")));
        for (size_t length = 1; length < exif.size(); ++length) EXPECT_TRUE(decode_stored_picture(jpeg_file({.exif = exif.substr(0, length)}))) << length;
    }
}

TEST(Jpeg, WhatIsMissingOrDamagedIsAnErrorWithItsPlace) {
    const std::vector<std::byte> whole = jpeg_file({});
    for (size_t length = 3; length < whole.size(); ++length) {
        const auto read = decode_stored_picture(std::span(whole).first(length));
        ASSERT_FALSE(read) << "of " << length << " bytes";
        EXPECT_THAT(read.error(), testing::MatchesRegex("broken JPEG: .*, (ahead of the pixels|in row [0-9]+ of 29)"));
    }
    std::vector<std::byte> cut(whole.begin(), whole.end() - 40);
    EXPECT_THAT(decode_stored_picture(cut).error(), HasSubstr("Premature end of JPEG file, in row"));
    std::mt19937 random(1);
    for (int round = 0; round < 300; ++round) {
        std::vector<std::byte> damaged = jpeg_file({.progressive = round % 2 == 0});
        for (int i = 0; i < 3; ++i) damaged[3 + random() % (damaged.size() - 3)] = std::byte(random());
        const auto read = decode_stored_picture(damaged);
        if (read) {
            ASSERT_EQ(read->picture.values.size(), size_t(read->picture.width) * size_t(read->picture.height) * size_t(read->picture.channels));
        }
    }
}

TEST(Jpeg, HugeSizesAreRefusedBeforeAnythingIsDecoded) {
    for (const bool progressive : {false, true}) {
        std::vector<std::byte> bytes = jpeg_file({.progressive = progressive});
        const std::byte frame[] = {std::byte(0xff), std::byte(progressive ? 0xc2 : 0xc0)};
        const auto at = std::search(bytes.begin(), bytes.end(), std::begin(frame), std::end(frame));
        std::fill_n(at + 5, 4, std::byte(0xf0));
        EXPECT_THAT(decode_stored_picture(bytes).error(), HasSubstr("it claims 61680 x 61680 pixels of 3 channels"));
    }
}

/// Each scan takes the time of all pixels, and may have a few bytes.
TEST(Jpeg, TooManyScansAreRefused) {
    const auto tells = [](const JpegKind& kind) {
        const auto read = decode_stored_picture(jpeg_file(kind));
        return read ? std::string() : read.error();
    };
    EXPECT_EQ(tells({.components = 1, .scans_a_coefficient = 1}), "");
    EXPECT_THAT(tells({.components = 1, .scans_a_coefficient = 2}), HasSubstr("it has more than 100 scans"));
}

TEST(Gif, HasTheColoursThatTheModuleReads) {
    const std::string colors("\1\2\3\x40\x50\x60\x90\xa0\xb0\xf0\xe0\xd0", 12), rows("\0\1\2\3\0\1\2\3\0\1\1\1\3\2\0", 15);
    for (const std::string& frames : {gif_frame({3, 5}, rows), gif_frame({3, 5}, rows, true), gif_clear(2) + gif_frame({3, 5}, rows)}) {
        const std::string file = gif_file({3, 5}, colors, frames);
        const auto module = image::decode_by_module(std::as_bytes(std::span(file)));
        if (!module) GTEST_SKIP() << module.error();
        const auto read = decode_stored_picture(std::as_bytes(std::span(file)));
        ASSERT_TRUE(read) << read.error();
        ASSERT_EQ(read->picture.names, module->picture.names);
        for (size_t i = 0; i < 15; ++i) {
            const float *here = &read->picture.values[4 * i], *there = &module->picture.values[4 * i];
            ASSERT_EQ(here[3], there[3]) << i;
            if (here[3] == 0) continue;   // what is clear has no colour in the module
            ASSERT_TRUE(std::equal(here, here + 3, there)) << i;
        }
    }
}

/// Probed: POV-Ray takes each number that a block ahead of the picture names for clear, and a block that names none changes nothing.
TEST(Gif, EachControlBlockNamesWhatIsClear) {
    const std::string colors(12, '\x40'), rows("\0\1\2\3", 4), none("\x21\xf9\4\0\0\0\3\0", 8);
    const auto clear_in = [&](const std::string& blocks) {
        const std::string file = gif_file({2, 2}, colors, blocks + gif_frame({2, 2}, rows));
        const auto read = decode_stored_picture(std::as_bytes(std::span(file)));
        std::string clear;
        for (size_t i = 0; read && i < 4; ++i) clear += read->picture.values[4 * i + 3] == 0 ? char('0' + i) : '.';
        return clear;
    };
    EXPECT_EQ(clear_in(none), "....");
    EXPECT_EQ(clear_in(gif_clear(2)), "..2.");
    EXPECT_EQ(clear_in(gif_clear(2) + none), "..2.");
    EXPECT_EQ(clear_in(gif_clear(2) + gif_clear(0)), "0.2.");
}

TEST(Gif, WhatIsMissingOrHugeIsAnError) {
    const std::string whole = gif_file({3, 5}, std::string(12, '\x40'), gif_frame({3, 5}, std::string(15, '\1')));
    EXPECT_THAT(decode_stored_picture(std::as_bytes(std::span(whole).first(30))).error(), HasSubstr("broken GIF: "));
    EXPECT_THAT(decode_stored_picture(std::as_bytes(std::span(whole).first(whole.size() - 8))).error(), testing::MatchesRegex("broken GIF: .*, in row [0-4] of 5"));
    std::string huge = whole;
    const size_t frame = huge.find(',');
    for (const size_t at : {size_t(6), frame + 5}) huge.replace(at, 4, "\xf0\xf0\xf0\xf0");
    EXPECT_THAT(decode_stored_picture(std::as_bytes(std::span(huge))).error(), HasSubstr("it claims 61680 x 61680 pixels of 4 channels"));
}

}  // namespace
}  // namespace alidade
