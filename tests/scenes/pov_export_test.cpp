// SPDX-License-Identifier: Apache-2.0
/// POV-Ray scenes written as POV-Ray scenes: read again, they give the same pictures, bit for bit; and POV-Ray takes them without a warning.
#include "core/image.h"
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "tests/povray/povray.h"
#include "tests/scenes/pov_pictures.h"
#include "tests/scenes/sample_pictures.h"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <sstream>

namespace alidade {
namespace {

using namespace test;

constexpr int kExportWidth = 64, kExportHeight = 48;

class PovExport : public testing::TestWithParam<PovPicture> {
  protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        write_sample_pictures(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string path(const char* name) const { return (folder_ / name).string(); }

    /// The scene of a file, with the picture's size.
    static std::optional<Scene> read(const std::string& path) {
        ImportOptions options;
        options.frame.image_width = kExportWidth, options.frame.image_height = kExportHeight;
        auto imported = import_scene(path, options);
        EXPECT_TRUE(imported) << (imported ? "" : imported.error().text());
        if (!imported) return std::nullopt;
        EXPECT_EQ(said_beyond_povray(imported->diagnostics), "") << path;
        return std::move(imported->scene);
    }

    static std::vector<float> drawn(Scene scene) {
        Diagnostics said;
        const auto compiled = compile(std::move(scene), {}, said);
        RenderOptions options;
        options.width = kExportWidth, options.height = kExportHeight, options.threads = 1;
        if (!compiled) return {};
        const auto film = render(*compiled, options);
        return film ? film->picture.values : std::vector<float>();
    }

    std::string text(const char* name) const {
        std::ifstream in(path(name));
        std::stringstream all;
        all << in.rdbuf();
        return all.str();
    }

    /// What POV-Ray says of a scene that it draws, or that it does not.
    std::string povray(const char* scene, const char* picture) const {
        const std::string run = fmt::format("cd '{}' && povray +I{} +O{} +W{} +H{} -A -D +WT1 > said.txt 2>&1", folder_.string(), scene, picture, kExportWidth, kExportHeight);
        return std::system(run.c_str()) == 0 ? text("said.txt") : "Error: " + text("said.txt");
    }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("alidade_pov_export_{}", std::random_device{}());
};

/// The warnings among what POV-Ray says, without their places.
std::set<std::string> warnings(const std::string& said) {
    std::set<std::string> out;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);)
        if (const size_t at = line.find("Warning: "); at != std::string::npos) out.insert(line.substr(at));
    return out;
}

/// Pictures that stood before assumed_gamma, and were decoded as nothing behind it is.
bool loses_gamma(const Exported& exported) {
    return std::any_of(exported.losses.begin(), exported.losses.end(), [](const Loss& loss) { return loss.what.find("pictures decoded by the words") != std::string::npos; });
}

/// Letters are written as prisms, which are not read yet.
bool has_letters(const Scene& scene) {
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const ShapeEntry& s) { return std::holds_alternative<Extrusion>(s.geometry); });
}

TEST_P(PovExport, GivesTheSamePicture) {
    std::ofstream(path("scene.pov")) << GetParam().scene << "\n";
    const auto scene = read(path("scene.pov"));
    ASSERT_TRUE(scene);
    const auto exported = export_scene(*scene, path("out.pov"));
    ASSERT_TRUE(exported) << exported.error();
    if (has_letters(*scene)) GTEST_SKIP() << "letters become prisms";
    if (loses_gamma(*exported)) GTEST_SKIP() << "behind assumed_gamma there are no words for it: told as a loss";
    const auto again = read(path("out.pov"));
    ASSERT_TRUE(again);
    const std::vector<float> before = drawn(*scene), after = drawn(*again);
    ASSERT_FALSE(before.empty());
    EXPECT_TRUE(before == after) << text("out.pov");
}

class PovExportToPovRay : public PovExport {};

TEST_P(PovExportToPovRay, IsTaken) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    std::ofstream(path("scene.pov")) << GetParam().scene << "\n";
    const auto scene = read(path("scene.pov"));
    ASSERT_TRUE(scene);
    const auto exported = export_scene(*scene, path("out.pov"));
    ASSERT_TRUE(exported);
    if (loses_gamma(*exported)) GTEST_SKIP() << "behind assumed_gamma there are no words for it: told as a loss";
    const std::string said = povray("out.pov", "out.png");
    EXPECT_FALSE(said.starts_with("Error:")) << said << text("out.pov");   // a "Possible Parse Error" is a warning
    const std::string said_before = povray("scene.pov", "scene.png");
    ASSERT_FALSE(said_before.starts_with("Error:"));
    const std::set<std::string> before = warnings(said_before);
    for (const std::string& warning : warnings(said))   // what is said of bounds that cost time alone does not count
        EXPECT_TRUE(before.contains(warning) || warning == "Warning: Unnecessary bounding object removed.") << warning << "\n" << text("out.pov");
    const auto own = read_picture(path("out.png"), Encoding::linear), theirs = read_picture(path("scene.png"), Encoding::linear);
    ASSERT_TRUE(own && theirs);
    int differ = 0;
    for (int y = 0; y < kExportHeight; ++y)
        for (int x = 0; x < kExportWidth; ++x) {
            double most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(double(own->at(x, y)[c]) - double(theirs->at(x, y)[c])));
            differ += most * 255 > 1.5;
        }
    EXPECT_LE(differ, kExportWidth * kExportHeight / 200) << "pixels that differ by more than one step of 255";
}

/// Two runs of POV-Ray are a second and a half: the shorter list takes each seventh scene.
std::vector<PovPicture> for_povray() {
    const std::vector<PovPicture> all = pov_pictures();
    const size_t step = std::getenv("ALIDADE_FULL") ? 1 : 7;
    std::vector<PovPicture> out;
    for (size_t i = 0; i < all.size(); i += step) out.push_back(all[i]);
    return out;
}

INSTANTIATE_TEST_SUITE_P(All, PovExport, testing::ValuesIn(pov_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(All, PovExportToPovRay, testing::ValuesIn(for_povray()), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace alidade
