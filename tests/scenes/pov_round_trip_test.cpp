// SPDX-License-Identifier: Apache-2.0
/// Scenes of other formats, written for POV-Ray and read again: the same surfaces with the same coordinates and the colours of their pictures, pixel by pixel.
#include "eval/flat_triangle.h"
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "tracer/render.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace alidade {
namespace {

constexpr int kTripWidth = 96, kTripHeight = 72;

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
    options.width = kTripWidth, options.height = kTripHeight, options.threads = 1, options.spp = 1;
    options.aovs = {"depth", "uv", "albedo", "normal", "id", "coverage"};
    auto film = compiled ? render(*compiled, options) : tl::unexpected(std::string());
    EXPECT_TRUE(film);
    return film ? std::optional(std::move(film->picture)) : std::nullopt;
}

/// Two pictures of one scene, pixel by pixel.
struct Pair {
    Picture before, after;

    /// Are the first `count` channels from `first` on the same, bit for bit?
    bool same(const std::string& first, int count, int x, int y) const {
        const Layer a = layer(before, first), b = layer(after, first);
        return std::equal(a.at(x, y), a.at(x, y) + count, b.at(x, y));
    }
    float difference(const std::string& first, int count, int x, int y) const {
        const Layer a = layer(before, first), b = layer(after, first);
        float most = 0;
        for (int c = 0; c < count; ++c) most = std::max(most, std::abs(a.at(x, y)[c] - b.at(x, y)[c]));
        return most;
    }
};

class PovRoundTrip : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The picture of a scene, and that of what was written of it.
    std::optional<Pair> both(const std::string& path) {
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
        for (const Material& material : scene->scene.materials) bent_ = bent_ || has_normal_map(material);
        for (const ShapeEntry& shape : scene->scene.shapes) nudged_ = nudged_ || would_be_flat(shape);
        auto before = drawn(std::move(scene->scene)), after = drawn(std::move(again->scene));
        if (!before || !after) return std::nullopt;
        return Pair{std::move(*before), std::move(*after)};
    }

    static bool has_normal_map(const Material& material) {
        const auto* pbr = material.layers.empty() ? nullptr : std::get_if<GltfPbr>(&material.layers.front());
        return pbr && pbr->normal;
    }

    /// Does POV-Ray take a triangle's normals for none?
    static bool would_be_flat(const ShapeEntry& shape) {
        const auto* mesh = std::get_if<Mesh>(&shape.geometry);
        if (!mesh || !mesh->normals.present()) return false;
        for (size_t t = 0; t < mesh->triangles.size(); ++t) {
            std::array<Vec3, 3> corners, normals;
            for (int k = 0; k < 3; ++k) {
                corners[size_t(k)] = Vec3(mesh->positions[mesh->triangles[t][k]]);
                normals[size_t(k)] = Vec3(mesh->normals.values[mesh->normals.index(t, k, mesh->triangles[t])]);
            }
            if (is_drawn_flat(corners, normals)) return true;
        }
        return false;
    }

    bool bent_ = false;     ///< normal maps are not written
    bool nudged_ = false;   ///< by 1.5e-5 at one corner
    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("alidade_pov_round_trip_{}", std::random_device{}());
};

/// Depth, coverage, texture coordinates and normals are the same bit for bit, also of what is seen through a picture's holes; base colours to single precision.
TEST_P(PovRoundTrip, KeepsCoordinatesAndColours) {
    std::string path = std::string(ALIDADE_ROOT) + "/assets/scenes/" + GetParam();
    if (!std::filesystem::exists(path)) path = std::string(ALIDADE_SHARED_DATA) + "/blender/" + GetParam();
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "the shared data is not there";
    const auto pictures = both(path);
    ASSERT_TRUE(pictures);
    int hits = 0, depth = 0, coverage = 0, uv = 0, nudged = 0, bent = 0, colours = 0, ids = 0;
    float most = 0;
    std::map<float, float> id_of;
    for (int y = 0; y < kTripHeight; ++y)
        for (int x = 0; x < kTripWidth; ++x) {
            const float there = *layer(pictures->before, "coverage.Y").at(x, y);
            coverage += (there == 0 || there == 1) && there != *layer(pictures->after, "coverage.Y").at(x, y);   // of POV-Ray's surfaces all is there that is no hole
            const bool hit = std::isfinite(*layer(pictures->before, "depth.Z").at(x, y));
            depth += !pictures->same("depth.Z", 1, x, y), uv += !pictures->same("uv.U", 2, x, y);
            if (!hit) continue;
            ++hits;
            const float id = *layer(pictures->before, "id.Y").at(x, y), other = *layer(pictures->after, "id.Y").at(x, y);
            ids += id_of.try_emplace(id, other).first->second != other;
            if (!pictures->same("normal.X", 3, x, y)) (pictures->difference("normal.X", 3, x, y) < 2e-5f ? nudged : bent) += 1;
            const float apart = pictures->difference("albedo.R", 3, x, y);
            most = std::max(most, apart), colours += apart > 2e-6f;
        }
    if (std::getenv("ALIDADE_FIGURES"))
        std::printf("%s: %d hits; differ: depth %d coverage %d uv %d ids %d normals nudged %d, bent %d, colours %d by up to %g\n", GetParam(), hits, depth, coverage, uv, ids, nudged, bent, colours, double(most));
    EXPECT_EQ(depth, 0);
    EXPECT_EQ(coverage, 0);
    EXPECT_EQ(uv, 0);
    EXPECT_EQ(ids, 0) << "a number stands for one instance in both";
    EXPECT_EQ(colours, 0) << most;
    if (!bent_) {
        EXPECT_EQ(bent, 0);
    }
    if (!nudged_) {
        EXPECT_EQ(nudged, 0);
    }
    EXPECT_GT(hits, 100);
}

/// The depth in the middle of what `text` shows.
float depth_of(const std::string& text, const char* integrator) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / fmt::format("alidade_pov_holes_{}.pov", std::random_device{}());
    std::ofstream(file) << text;
    auto read = import_scene(file.string());
    std::filesystem::remove(file);
    EXPECT_TRUE(read) << (read ? "" : read.error().text());
    Diagnostics said;
    const auto compiled = compile(std::move(read->scene), {}, said);
    RenderOptions options;
    options.width = options.height = 9, options.threads = 1, options.spp = 1, options.integrator = integrator, options.aovs = {"depth"};
    const auto film = render(*compiled, options);
    return *layer(film->picture, "depth.Z").at(4, 4);
}

/// Layers tell what is seen through a hole; a pane that reflects, or takes a little, is seen itself.
TEST(PovHoles, AreNoSurfaces) {
    const auto scene = [](const std::string& pane) {
        return "#version 3.7; camera { location -10*z look_at 0 } light_source { -50*z, 1 } sphere { 0, 1 pigment { rgb 1 } } box { <-2,-2,-5>, <2,2,-4.5> texture { " + pane + " } }";
    };
    const std::string hole = "pigment { rgbt 1 } finish { ambient 0 diffuse 0 }", map = "planar texture_map { [ 0.5 " + hole + " ] [ 0.5 pigment { rgb 1 } ] }";
    for (const char* integrator : {"cast", "whitted"}) {
        EXPECT_FLOAT_EQ(depth_of(scene(hole), integrator), 9);
        EXPECT_FLOAT_EQ(depth_of(scene(map + " translate 5*y"), integrator), 9);
        EXPECT_FLOAT_EQ(depth_of(scene(map), integrator), 5);
        EXPECT_FLOAT_EQ(depth_of(scene("pigment { rgbt 1 } finish { reflection 0.1 }"), integrator), 5);
        EXPECT_FLOAT_EQ(depth_of(scene("pigment { rgbt <1,1,1,0.99> }"), integrator), 5);
    }
}

INSTANTIATE_TEST_SUITE_P(Assets, PovRoundTrip, testing::Values("hero.glb", "materials.glb", "foliage.glb", "house.obj", "lens.glb", "motion.glb", "shell.ply", "gear.stl", "star.off", "prims.glb", "textured.glb", "instances.glb"),
                         [](const auto& info) { std::string name = info.param; name[name.find('.')] = '_'; return name; });

}  // namespace
}  // namespace alidade
