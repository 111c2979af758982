// SPDX-License-Identifier: Apache-2.0
/// Scenes of other formats, written for POV-Ray and read again: the same surfaces with the same coordinates and the colours of their pictures, pixel by pixel.
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "tracer/render.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

constexpr int kWidth = 96, kHeight = 72;

struct Layer {
    const Picture& picture;
    int first;
    const float* at(int x, int y) const { return picture.at(x, y) + first; }
};

Layer layer(const Picture& picture, const std::string& channel) {
    const auto at = std::find(picture.names.begin(), picture.names.end(), channel);
    EXPECT_NE(at, picture.names.end()) << channel;
    return {picture, int(at - picture.names.begin())};
}

std::optional<Picture> drawn(Scene scene) {
    Diagnostics said;
    const auto compiled = compile(std::move(scene), {}, said);
    EXPECT_TRUE(compiled) << said.text();
    RenderOptions options;
    options.width = kWidth, options.height = kHeight, options.threads = 1, options.spp = 1;
    options.aovs = {"depth", "uv", "albedo"};
    auto film = compiled ? render(*compiled, options) : tl::unexpected(std::string());
    EXPECT_TRUE(film);
    return film ? std::optional(std::move(film->picture)) : std::nullopt;
}

struct Asset {
    const char* name;
    int other_colours = 0;   ///< pixels of surfaces that emit: the pigment of a black one, and of a layer above the others, is the colour that they emit
};

class PovRoundTrip : public testing::TestWithParam<Asset> {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The picture of a scene, and that of what was written of it.
    std::optional<std::pair<Picture, Picture>> both(const std::string& path) {
        auto scene = import_scene(path);
        EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
        if (!scene) return std::nullopt;
        const std::string out = (folder_ / "out.pov").string();
        const auto written = export_scene(scene->scene, out);
        EXPECT_TRUE(written) << (written ? "" : written.error());
        auto again = import_scene(out);
        EXPECT_TRUE(again) << (again ? "" : again.error().text());
        if (!again) return std::nullopt;
        EXPECT_EQ(again->diagnostics.text(), "");
        auto before = drawn(std::move(scene->scene)), after = drawn(std::move(again->scene));
        if (!before || !after) return std::nullopt;
        return std::pair(std::move(*before), std::move(*after));
    }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("alidade_pov_round_trip_{}", std::random_device{}());
};

TEST_P(PovRoundTrip, KeepsCoordinatesAndColours) {
    std::string path = std::string(ALIDADE_ROOT) + "/assets/scenes/" + GetParam().name;
    if (!std::filesystem::exists(path)) path = std::string(ALIDADE_SHARED_DATA) + "/blender/" + GetParam().name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "the shared data is not there";
    const auto pictures = both(path);
    ASSERT_TRUE(pictures);
    const auto& [before, after] = *pictures;
    const Layer depths[] = {layer(before, "depth.Z"), layer(after, "depth.Z")}, uvs[] = {layer(before, "uv.U"), layer(after, "uv.U")}, colours[] = {layer(before, "albedo.R"), layer(after, "albedo.R")};
    int hits = 0, same_surface = 0, with_uv = 0, far = 0;
    float most_of_all = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (!std::isfinite(*depths[0].at(x, y))) continue;
            ++hits;
            const float nearest[] = {*depths[0].at(x, y), *depths[1].at(x, y)};
            if (nearest[0] != nearest[1]) {
                EXPECT_LT(nearest[1], nearest[0]) << "what a picture's alpha cuts out is a clear surface in POV-Ray";
                continue;
            }
            ++same_surface;
            const float *a = uvs[0].at(x, y), *b = uvs[1].at(x, y);
            with_uv += a[0] != 0 || a[1] != 0;
            ASSERT_EQ(a[0], b[0]) << "u at " << x << ", " << y;
            ASSERT_EQ(a[1], b[1]) << "v at " << x << ", " << y;
            float most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(colours[0].at(x, y)[c] - colours[1].at(x, y)[c]));
            far += most > 1e-6f, most_of_all = std::max(most_of_all, most);
        }
    if (std::getenv("ALIDADE_FIGURES")) std::printf("%s: %d hits, %d the same, %d with coordinates, %d of other colours, by up to %g\n", GetParam().name, hits, same_surface, with_uv, far, double(most_of_all));
    EXPECT_LE(far, GetParam().other_colours);
    EXPECT_GT(hits, 100);
    EXPECT_GT(same_surface, hits * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Assets, PovRoundTrip, testing::Values(Asset{"hero.glb"}, Asset{"materials.glb", 184}, Asset{"foliage.glb"}, Asset{"house.obj"}, Asset{"lens.glb"}, Asset{"motion.glb"}, Asset{"shell.ply"}, Asset{"gear.stl"}, Asset{"star.off"},
                         Asset{"prims.glb"}, Asset{"textured.glb", 447}, Asset{"instances.glb"}),
                         [](const auto& info) { std::string name = info.param.name; name[name.find('.')] = '_'; return name; });

}  // namespace
}  // namespace alidade
