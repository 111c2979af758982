// SPDX-License-Identifier: Apache-2.0
/// Writing pictures and reading them back: what is exact is exact, what is rounded is rounded as the standard says, and a failure leaves nothing.
#include "core/image.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <random>

namespace alidade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder of its own for each test, removed afterwards.
class ImageFiles : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = testing::TempDir() + "alidade-image-XXXXXX";
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    size_t files() const { return size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

    fs::path folder_;
};

std::vector<uint32_t> bits(const Picture& picture) {
    std::vector<uint32_t> out;
    for (const float value : picture.values) out.push_back(std::bit_cast<uint32_t>(value));
    return out;
}

/// Any float at all: NaNs, infinities, denormals.
Picture random_floats(int width, int height, std::vector<std::string> names, uint32_t seed) {
    Picture picture(width, height, std::move(names));
    std::mt19937 random(seed);
    for (float& value : picture.values) value = std::bit_cast<float>(uint32_t(random()));
    return picture;
}

void expect_same(const Picture& got, const Picture& want) {
    EXPECT_EQ(got.width, want.width);
    EXPECT_EQ(got.height, want.height);
    EXPECT_EQ(got.names, want.names);
    EXPECT_EQ(bits(got), bits(want));
}

TEST_F(ImageFiles, ExrKeepsEveryBitOfEveryChannel) {
    const std::vector<std::string> names = {"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z"};
    for (const auto& [width, height] : {std::pair(1, 1), {17, 5}, {64, 33}}) {
        const Picture picture = random_floats(width, height, names, uint32_t(width));
        ASSERT_TRUE(write_picture(path("a.exr"), picture));
        const auto read = read_picture(path("a.exr"), Encoding::automatic);
        ASSERT_TRUE(read) << read.error();
        expect_same(*read, picture);
    }
    EXPECT_EQ(files(), 1u) << "temporary files were left";
}

TEST_F(ImageFiles, PfmKeepsEveryBit) {
    for (const auto& names : {std::vector<std::string>{"R", "G", "B"}, std::vector<std::string>{"Y"}}) {
        const Picture picture = random_floats(7, 9, names, 1);
        ASSERT_TRUE(write_picture(path("a.pfm"), picture));
        const auto read = read_picture(path("a.pfm"), Encoding::automatic);
        ASSERT_TRUE(read) << read.error();
        expect_same(*read, picture);
    }
}

/// The codes of 16 bits are those of PNG files.
TEST_F(ImageFiles, DeepPpmHoldsWhatDeepPngHolds) {
    for (const auto& names : {std::vector<std::string>{"R", "G", "B"}, std::vector<std::string>{"Y"}}) {
        Picture picture = random_floats(7, 9, names, 2);
        for (size_t i = 0; i < picture.values.size(); i += 2) picture.values[i] = float(i) / float(picture.values.size());
        ASSERT_TRUE(write_picture(path("a.ppm"), picture, 16));
        ASSERT_TRUE(write_picture(path("a.png"), picture, 16));
        const auto read = read_picture(path("a.ppm"), Encoding::automatic), want = read_picture(path("a.png"), Encoding::automatic);
        ASSERT_TRUE(read && want);
        ASSERT_EQ(read->channels, 3);
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 7; ++x)
                for (int c = 0; c < 3; ++c) EXPECT_EQ(read->at(x, y)[c], want->at(x, y)[want->channels == 3 ? c : 0]);
    }
}

/// The table was worked out from IEC 61966-2-1 by hand: code = round(255 f(linear)), f(x) = 12.92 x below 0.0031308, else 1.055 x^(1/2.4) - 0.055.
TEST_F(ImageFiles, PngCodesAreTheNearestOnTheStandardCurve) {
    const struct { float linear; int code; } rows[] = {
        {0, 0}, {0.0001f, 0}, {0.0002f, 1}, {0.001f, 3}, {0.0031308f, 10}, {0.01f, 25}, {0.05f, 63}, {0.18f, 118}, {0.2140411f, 127}, {0.5f, 188},
        {0.7f, 218}, {0.9f, 243}, {0.99f, 254}, {1, 255}, {2, 255}, {-1, 0}, {std::nanf(""), 0}, {INFINITY, 255}, {-INFINITY, 0}};
    Picture picture(int(std::size(rows)), 1, {"R", "G", "B"});
    for (size_t i = 0; i < std::size(rows); ++i) std::fill_n(picture.at(int(i), 0), 3, rows[i].linear);
    ASSERT_TRUE(write_picture(path("a.png"), picture));
    const auto read = read_picture(path("a.png"), Encoding::linear);
    ASSERT_TRUE(read) << read.error();
    ASSERT_EQ(read->channels, 3) << "an opaque picture has no alpha channel";
    for (size_t i = 0; i < std::size(rows); ++i) EXPECT_EQ(std::lround(read->at(int(i), 0)[1] * 255), rows[i].code) << rows[i].linear;
}

/// On either side of the value that is halfway between two codes, one step of a float away.
TEST_F(ImageFiles, PngCodesChangeHalfwayBetweenTwo) {
    Picture picture(255, 2, {"R", "G", "B"});
    for (int k = 0; k < 255; ++k) {
        const float halfway = float(srgb_to_linear((k + 0.5) / 255));
        std::fill_n(picture.at(k, 0), 3, std::nextafter(halfway, 0.0f));
        std::fill_n(picture.at(k, 1), 3, halfway);
    }
    ASSERT_TRUE(write_picture(path("a.png"), picture));
    const auto read = read_picture(path("a.png"), Encoding::linear);
    ASSERT_TRUE(read) << read.error();
    for (int k = 0; k < 255; ++k) {
        EXPECT_EQ(std::lround(read->at(k, 0)[1] * 255), k);
        EXPECT_EQ(std::lround(read->at(k, 1)[1] * 255), k + 1);
    }
}

/// All 256 codes come back as themselves, in every channel: decoding and encoding are inverses.
TEST_F(ImageFiles, PngReadThenWrittenIsTheSamePicture) {
    Picture picture(256, 1, {"R", "G", "B"});
    for (int k = 0; k < 256; ++k)
        for (int c = 0; c < 3; ++c) picture.at(k, 0)[c] = float(srgb_to_linear((c == 1 ? 255 - k : k) / 255.0));
    ASSERT_TRUE(write_picture(path("a.png"), picture));
    const auto read = read_picture(path("a.png"), Encoding::automatic);
    ASSERT_TRUE(read) << read.error();
    expect_same(*read, picture);
    ASSERT_TRUE(write_picture(path("b.png"), *read));
    EXPECT_EQ(*read_file(path("a.png")), *read_file(path("b.png")));
}

TEST(Srgb, CurvesAreInverseAndContinuous) {
    for (int i = 0; i <= 10000; ++i) {
        const double x = i / 10000.0;
        EXPECT_NEAR(linear_to_srgb(srgb_to_linear(x)), x, 2e-7) << x;   // the standard's two pieces miss each other by 1e-7 at the joint
    }
    EXPECT_EQ(srgb_to_linear(0), 0);
    EXPECT_EQ(srgb_to_linear(1), 1);
    EXPECT_DOUBLE_EQ(linear_to_srgb(1), 1);
    EXPECT_NEAR(srgb_to_linear(0.5), 0.21404114, 1e-8);
}

TEST_F(ImageFiles, PngAlphaIsStraight) {
    Picture picture(4, 1, {"R", "G", "B", "A"});
    const float pixels[4][4] = {{0.25f, 0.5f, 0, 0.5f}, {0.5f, 0.5f, 0.5f, 1}, {0, 0, 0, 0}, {0.2f, 0, 0, 0}};
    std::memcpy(picture.values.data(), pixels, sizeof pixels);
    ASSERT_TRUE(write_picture(path("a.png"), picture));
    const auto read = read_picture(path("a.png"), Encoding::automatic);
    ASSERT_TRUE(read) << read.error();
    ASSERT_EQ(read->names, (std::vector<std::string>{"R", "G", "B", "A"}));
    const float want[4][4] = {{0.5f, 1, 0, 0.5f}, {0.5f, 0.5f, 0.5f, 1}, {0, 0, 0, 0}, {0.2f, 0, 0, 0}};   // colour / alpha, where alpha is not 0
    for (int x = 0; x < 4; ++x)
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(read->at(x, 0)[c], want[x][c], 0.005) << x << " " << c;
    EXPECT_EQ(std::lround(read->at(0, 0)[3] * 255), 128) << "alpha is not gamma-encoded";
}

/// What reads the files of an animation finds one kind of picture in all of them.
TEST_F(ImageFiles, PngHasTheAlphaOfAPictureThatIsNowhereTransparent) {
    Picture picture(2, 1, {"R", "G", "B", "A"});
    picture.values = {0.25f, 0.5f, 0, 1, 1, 1, 1, 1};
    ASSERT_TRUE(write_picture(path("a.png"), picture));
    const auto read = read_picture(path("a.png"), Encoding::automatic);
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->names, (std::vector<std::string>{"R", "G", "B", "A"}));
}

TEST_F(ImageFiles, PpmIsOverBlackAndSrgb) {
    Picture picture(2, 1, {"R", "G", "B", "A"});
    const float pixels[2][4] = {{0.5f, 0, 1, 0.5f}, {0.18f, 0.05f, 0, 0}};
    std::memcpy(picture.values.data(), pixels, sizeof pixels);
    ASSERT_TRUE(write_picture(path("a.ppm"), picture));
    const auto bytes = read_file(path("a.ppm"));
    ASSERT_TRUE(bytes);
    const std::string want = "P6\n2 1\n255\n" + std::string({char(188), 0, char(255), char(118), 63, 0});
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()), want);
}

TEST_F(ImageFiles, SamePictureSameBytes) {
    Picture picture(50, 40, {"R", "G", "B", "A"});
    std::mt19937 random(3);
    for (float& value : picture.values) value = std::uniform_real_distribution<float>(0, 1)(random);
    for (const char* ending : {".png", ".exr", ".ppm", ".pfm"}) {
        ASSERT_TRUE(write_picture(path("a") + ending, picture));
        ASSERT_TRUE(write_picture(path("b") + ending, picture));
        EXPECT_EQ(*read_file(path("a") + ending), *read_file(path("b") + ending)) << ending;
    }
}

TEST_F(ImageFiles, FailuresNameTheFileAndLeaveNothing) {
    const Picture picture(2, 2, {"R", "G", "B"});
    const auto error = [&](const std::string& name, const Picture& p) {
        const auto written = write_picture(path(name), p);
        return written ? std::string("written") : written.error();
    };
    EXPECT_THAT(error("no/such/folder.png", picture), testing::AllOf(HasSubstr("folder.png"), HasSubstr("No such file")));
    EXPECT_THAT(error("a.xyz", picture), HasSubstr("no picture format that can be written has the ending .xyz"));
    EXPECT_THAT(error("a", picture), HasSubstr("no ending"));
    EXPECT_THAT(error("a.png", Picture(2, 2, {"depth.Z"})), HasSubstr("no channels R, G, B"));
    EXPECT_THAT(error("a.exr", Picture(2, 2, {"Z", "Z"})), HasSubstr("same name"));
    EXPECT_THAT(error("a.png", Picture()), HasSubstr("empty"));
    fs::create_directory(path("taken.png"));
    EXPECT_THAT(error("taken.png", picture), HasSubstr("directory"));
    EXPECT_EQ(files(), 1u) << "only the folder taken.png";
    EXPECT_THAT(read_picture(path("none.png"), Encoding::automatic).error(), testing::AllOf(HasSubstr("none.png"), HasSubstr("No such file")));
    EXPECT_THAT(read_file(path("taken.png")).error(), HasSubstr("directory"));
}

/// A limit on the size of files stands for a full disc: the write fails in the middle.
TEST_F(ImageFiles, FailureInTheMiddleKeepsTheOldFile) {
    ASSERT_TRUE(write_file(path("a.pfm"), std::vector<std::byte>(5)));
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{50, old.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = write_picture(path("a.pfm"), Picture(10, 10, {"R", "G", "B"}));
    setrlimit(RLIMIT_FSIZE, &old);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error(), testing::AllOf(HasSubstr("cannot write"), HasSubstr("a.pfm"), HasSubstr("too large")));
    EXPECT_EQ(read_file(path("a.pfm"))->size(), 5u);
    EXPECT_EQ(files(), 1u);
}

TEST_F(ImageFiles, ReadFileKeepsItsLimitAndRefusesPipes) {
    ASSERT_TRUE(write_file(path("a"), std::vector<std::byte>(100)));
    EXPECT_TRUE(read_file(path("a"), 100));
    EXPECT_THAT(read_file(path("a"), 99).error(), HasSubstr("limit"));
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_THAT(read_file(path("pipe")).error(), HasSubstr("not a regular file")) << "and it does not wait for a writer";
}

TEST_F(ImageFiles, LinksAreFollowedAndWhatIsNoFileStays) {
    ASSERT_TRUE(write_file(path("real"), std::vector<std::byte>(3)));
    fs::create_symlink("real", path("link"));
    fs::create_symlink(path("new"), path("dangling"));
    ASSERT_TRUE(write_file(path("link"), std::vector<std::byte>(7)));
    ASSERT_TRUE(write_file(path("dangling"), std::vector<std::byte>(9)));
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_TRUE(fs::is_symlink(path("dangling")));
    EXPECT_EQ(fs::file_size(path("real")), 7u);
    EXPECT_EQ(fs::file_size(path("new")), 9u);
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_THAT(write_file(path("pipe"), std::vector<std::byte>(1)).error(), HasSubstr("pipe")) << "and it does not wait for a reader";
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
    fs::create_symlink("/dev/full", path("full"));   // a link, so that a fault here spoils no device
    EXPECT_THAT(write_file(path("full"), std::vector<std::byte>(1)).error(), HasSubstr("No space left"));
    EXPECT_TRUE(fs::is_symlink(path("full")));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

/// Files there are files, though their path begins as a device's does.
TEST(ImageFilesInMemory, AreReplacedWhole) {
    if (!fs::is_directory("/dev/shm")) GTEST_SKIP() << "there is no /dev/shm";
    const std::string path = fmt::format("/dev/shm/alidade_test_{}", ::getpid());
    ASSERT_TRUE(write_file(path, std::vector<std::byte>(200)));
    ASSERT_TRUE(write_file(path, std::vector<std::byte>(3)));
    EXPECT_EQ(fs::file_size(path), 3u);
    fs::remove(path);
}

}  // namespace
}  // namespace alidade
