// SPDX-License-Identifier: Apache-2.0
/// Small scenes rendered by POV-Ray and by Alidade: the 8-bit codes must be the same, but for the few pixels where an edge goes through a centre.
#include "core/image.h"
#include "importers/importer.h"
#include "tests/povray/povray.h"
#include "tests/scenes/pov_pictures.h"
#include "tests/scenes/sample_pictures.h"
#include "tracer/render.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

using namespace test;

constexpr int kWidth = 64, kHeight = 48;

class Folder {
  public:
    Folder() : path_(std::filesystem::temp_directory_path() / fmt::format("alidade_pov_pictures_{}", std::random_device{}())) { std::filesystem::create_directories(path_); }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string operator/(const char* name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

std::optional<Picture> ours(const std::string& path, const std::string& out, const PovPicture& asked, std::string& why) {
    ImportOptions options;
    options.quality = asked.quality;
    options.frame.image_width = kWidth, options.frame.image_height = kHeight;
    auto imported = import_scene(path, options);
    if (!imported) return why = imported.error().text(), std::nullopt;
    why = said_beyond_povray(imported->diagnostics);
    Diagnostics said;
    const auto compiled = compile(std::move(imported->scene), {}, said);
    why += said.text();
    if (!compiled) return std::nullopt;
    RenderOptions render_options;
    render_options.width = kWidth, render_options.height = kHeight, render_options.threads = 1;
    render_options.supersampling = asked.supersampling, render_options.alpha = asked.alpha ? Alpha::straight : Alpha::none;
    auto film = render(*compiled, render_options);
    if (!film || !write_picture(out, film->picture)) return std::nullopt;
    auto read = read_picture(out, Encoding::linear);
    return read ? std::optional(std::move(*read)) : std::nullopt;
}

int code(const Picture& p, int x, int y, int c) { return int(std::lround(p.at(x, y)[c] * 255)); }

class PovPictures : public testing::TestWithParam<PovPicture> {};

TEST_P(PovPictures, AreThoseOfPovRay) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const Folder folder;
    write_sample_pictures(folder / "");
    std::ofstream(folder / "scene.pov") << GetParam().scene << "\n";
    ASSERT_EQ(std::system(fmt::format("cd '{}' && povray +Iscene.pov +Oref.png +W{} +H{} {} +Q{} {} -D +WT1 > said.txt 2>&1", folder / "", kWidth, kHeight, GetParam().words, GetParam().quality, GetParam().alpha ? "+UA" : "-UA").c_str()), 0);
    const auto theirs = read_picture(folder / "ref.png", Encoding::linear);
    ASSERT_TRUE(theirs);
    std::string said;
    const auto own = ours(folder / "scene.pov", folder / "own.png", GetParam(), said);
    ASSERT_TRUE(own) << said;
    ASSERT_EQ(own->channels, theirs->channels);
    EXPECT_EQ(said, "") << "nothing in the scene is left out";
    int differ = 0, seen = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            int most = 0;
            for (int c = 0; c < own->channels; ++c) most = std::max(most, std::abs(code(*own, x, y, c) - code(*theirs, x, y, c)));
            differ += most > 1;
            seen += code(*theirs, x, y, 0) != code(*theirs, 0, 0, 0);
        }
    EXPECT_GT(seen, 100) << "the picture shows something";
    EXPECT_LE(differ, kWidth * kHeight / 200) << "pixels that differ by more than one step of 255";
}

/// The mean square distance of the light from the picture's centre, in pixels.
double spread(const Picture& picture) {
    double light = 0, sum = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double v = picture.at(x, y)[0], dx = x + 0.5 - kWidth / 2.0, dy = y + 0.5 - kHeight / 2.0;
            light += v, sum += v * (dx * dx + dy * dy);
        }
    return sum / light;
}

/// A ball far out of focus becomes a disc. POV-Ray's points of the lens are not ours, so that the pictures are alike in their moments only.
TEST(PovLenses, AreAsWideAsPovRays) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const Folder folder;
    for (const double aperture : {0.4, 0.8}) {
        std::ofstream(folder / "scene.pov") << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -10*z look_at 0 angle 35 focal_point -7*z blur_samples 300 variance 0 aperture "
                                            << aperture << " }\nsphere { 0, 0.2 pigment { rgb 3 } finish { ambient 1 diffuse 0 } }\n";
        ASSERT_EQ(std::system(fmt::format("cd '{}' && povray +Iscene.pov +Oref.png +W{} +H{} -A -D +WT1 > said.txt 2>&1", folder / "", kWidth, kHeight).c_str()), 0);
        const auto theirs = read_picture(folder / "ref.png", Encoding::automatic);
        std::string said;
        const auto own = ours(folder / "scene.pov", folder / "own.png", PovPicture{"lens", {}}, said);
        ASSERT_TRUE(theirs && own) << said;
        const auto own_linear = read_picture(folder / "own.png", Encoding::automatic);
        ASSERT_TRUE(own_linear);
        EXPECT_NEAR(spread(*own_linear) / spread(*theirs), 1, 0.08) << aperture;
    }
}

/// A ball of glass that holds a part of the lens alone.
TEST(PovLenses, ALensThatIsAskedForStandsInTheSameGlass) {
    const Folder folder;
    std::ofstream(folder / "scene.pov") << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -4*z look_at 0 focal_point 0 aperture 1 blur_samples 16 variance 0 }\n"
                                        << "light_source { <5,5,-5> 1 }\nplane { y, -1 pigment { checker rgb 1 rgb x } }\nsphere { <.6,0,-4>, .59 pigment { rgbt .9 } interior { ior 1.3 } }\n";
    const auto picture = [&](bool pinhole, bool asked) {
        auto imported = import_scene(folder / "scene.pov", {});
        EXPECT_TRUE(imported);
        RenderOptions options;
        options.width = kWidth, options.height = kHeight, options.threads = 1;
        double& aperture = imported->scene.cameras[0].aperture;
        if (asked) options.aperture = aperture;
        if (pinhole) aperture = 0;
        Diagnostics said;
        const auto compiled = compile(std::move(imported->scene), {}, said);
        EXPECT_TRUE(compiled) << said.text();
        return render(*compiled, options)->picture.values;
    };
    const std::vector<float> own = picture(false, false);
    EXPECT_EQ(own, picture(true, true));
    EXPECT_NE(own, picture(true, false));
}

TEST(PovPictureFiles, ABrokenFileIsAnErrorAtItsName) {
    const Folder folder;
    std::ofstream(folder / "a.png") << "no picture";
    std::ofstream(folder / "scene.pov") << "sphere { z*5, 1\npigment { image_map { png \"a.png\" } } }\n";
    std::string said;
    EXPECT_FALSE(ours(folder / "scene.pov", folder / "own.png", {}, said));
    EXPECT_NE(said.find("scene.pov:2:"), std::string::npos) << said;
    EXPECT_NE(said.find("cannot be read"), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(Patterned, PovPictures, testing::ValuesIn(patterned_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Images, PovPictures, testing::ValuesIn(image_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Fogs, PovPictures, testing::ValuesIn(fog_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Effects, PovPictures, testing::ValuesIn(effect_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Cutaways, PovPictures, testing::ValuesIn(cutaway_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Defaults, PovPictures, testing::ValuesIn(default_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Insides, PovPictures, testing::ValuesIn(inside_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Bounds, PovPictures, testing::ValuesIn(bound_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Shadows, PovPictures, testing::ValuesIn(shadow_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Functions, PovPictures, testing::ValuesIn(function_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Flags, PovPictures, testing::ValuesIn(flag_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Qualities, PovPictures, testing::ValuesIn(quality_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Alpha, PovPictures, testing::ValuesIn(alpha_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(OldCameras, PovPictures, testing::ValuesIn(old_cameras()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Lights, PovPictures, testing::ValuesIn(light_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Antialiasing, PovPictures, testing::ValuesIn(sampled_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(All, PovPictures, testing::ValuesIn(other_pictures()), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace alidade
