// SPDX-License-Identifier: Apache-2.0
/// glTF files from import to picture: does what a file holds show?
#include "core/bounds.h"
#include "core/image.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tests/core/run_size.h"
#include "tests/importers/manifest.h"
#include "tracer/render.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace alidade {
namespace {

std::optional<Film> picture_of(Scene scene, RenderOptions options, std::string& why) {
    Diagnostics said;
    const auto compiled = compile(std::move(scene), {}, said);
    why = said.text();
    if (!compiled) return std::nullopt;
    auto film = render(*compiled, options);
    if (!film) why = film.error();
    return film ? std::optional(std::move(*film)) : std::nullopt;
}

/// A channel of every pixel.
std::vector<float> channel(const Picture& p, const std::string& name) {
    const size_t c = size_t(std::find(p.names.begin(), p.names.end(), name) - p.names.begin());
    std::vector<float> out;
    for (size_t i = 0; c < p.names.size() && i < size_t(p.width) * size_t(p.height); ++i) out.push_back(p.values[i * size_t(p.channels) + c]);
    return out;
}

// ---- EXT_texture_webp ----

/// A folder of its own with a red WebP and a green PNG.
class WebpTextures : public testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::create_directory(folder_);
        const auto write = [&](const char* name, const float (&color)[3]) {
            Picture p(8, 8, {"R", "G", "B"});
            for (size_t i = 0; i < p.values.size(); ++i) p.values[i] = color[i % 3];
            return write_picture(folder_ + "/" + name, p);
        };
        ASSERT_TRUE(write("green.png", {0, 1, 0}));
        if (const auto written = write("red.webp", {1, 0, 0}); !written) GTEST_SKIP() << "OpenImageIO here writes no WebP: " << written.error();
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The colour of an unlit square with the texture `texture`; images 0 and 1 are the WebP and the PNG, 2 is not there.
    Color shown(const std::string& texture, const std::string& extensions) {
        const float corners[] = {-9, -9, 0, 9, -9, 0, 0, 9, 0};
        std::ofstream(folder_ + "/t.bin", std::ios::binary).write(reinterpret_cast<const char*>(corners), sizeof corners);
        std::ofstream(folder_ + "/t.gltf") << fmt::format(R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["EXT_texture_webp","KHR_materials_unlit"],{}
            "images":[{{"uri":"red.webp"}},{{"uri":"green.png"}},{{"uri":"gone.webp"}}],"textures":[{}],
            "materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}},"extensions":{{"KHR_materials_unlit":{{}}}}}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"material":0}}]}}],"accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}}],"buffers":[{{"byteLength":36,"uri":"t.bin"}}],"cameras":[{{"type":"perspective","perspective":{{"yfov":0.1,"znear":1}}}}],
            "nodes":[{{"mesh":0}},{{"camera":0,"translation":[0,0,5]}}],"scenes":[{{"nodes":[0,1]}}]}})", extensions, texture);
        auto imported = import_scene(folder_ + "/t.gltf");
        EXPECT_TRUE(imported) << imported.error().text();
        if (!imported) return Color(0);
        RenderOptions options;
        options.width = options.height = 1, options.spp = 1, options.threads = 1;
        std::string why;
        const auto film = picture_of(std::move(imported->scene), options, why);
        EXPECT_TRUE(film) << why;
        return film ? Color(film->picture.values[0], film->picture.values[1], film->picture.values[2]) : Color(0);
    }

    /// WebP loses a little.
    static void expect_near(const Color& got, const Color& want) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 0.05) << c;
    }

    std::string folder_ = testing::TempDir() + "alidade-webp-" + std::to_string(getpid());
};

TEST_F(WebpTextures, WithoutAFallback) {
    expect_near(shown(R"({"extensions":{"EXT_texture_webp":{"source":0}}})", R"("extensionsRequired":["EXT_texture_webp"],)"), Color(1, 0, 0));
}
TEST_F(WebpTextures, BeforeTheirFallback) { expect_near(shown(R"({"source":1,"extensions":{"EXT_texture_webp":{"source":0}}})", ""), Color(1, 0, 0)); }
TEST_F(WebpTextures, TheFallbackWhereTheyAreGone) { expect_near(shown(R"({"source":1,"extensions":{"EXT_texture_webp":{"source":2}}})", ""), Color(0, 1, 0)); }

// ---- the collection ----

/// How far the triangles that the scene shows reach; nothing if it shows none that have an area.
std::optional<Bounds> extent(const Scene& scene) {
    Bounds box;
    visit_paths(scene, [&](const Visit& visit) {
        const Node& node = scene.nodes[visit.node.index];
        const auto* shape = std::get_if<ShapeId>(&node.what);
        const auto* mesh = shape ? std::get_if<Mesh>(&scene.shapes[shape->index].geometry) : nullptr;
        for (size_t i = 0; mesh && i < mesh->triangles.size(); ++i) {
            Vec3 corner[3];
            for (int c = 0; c < 3; ++c) corner[c] = visit.to_world.point(Vec3(mesh->positions[mesh->triangles[i][c]]));
            if (!(length(cross(corner[1] - corner[0], corner[2] - corner[0])) > 0)) continue;
            for (const Vec3& p : corner) box.extend(p);
        }
        return true;
    });
    return box.empty() ? std::nullopt : std::optional(box);
}

/// Looks at the box from a direction in which no flat mesh of the collection is a line.
void look_at(const Bounds& box, Scene& scene) {
    const Vec3 centre = box.center(), forward = normalized(Vec3(-0.5, -0.6, -0.8)), right = normalized(cross(forward, Vec3(0, 1, 0)));
    const double size = std::max(length(box.extent()), 1e-30);
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.location = centre - forward * size;
    camera.direction = forward;
    camera.right = right * size;
    camera.up = cross(right, forward) * size;
    scene.cameras = {camera};
    for (Node& node : scene.nodes)
        if (std::holds_alternative<CameraId>(node.what)) node.what = Nothing();
    Node node;
    node.what = CameraId{0};
    scene.roots.push_back(NodeId{uint32_t(scene.nodes.size())});
    scene.nodes.push_back(node);
}

/// A picture that frames all triangles of a scene shows some of them. Alpha may hide a whole mesh; nothing else may.
TEST(Collection, WhateverHasTrianglesShows) {
    const std::string data = ALIDADE_SHARED_DATA;
    const auto rows = gltf_test::gltf_manifest(data);
    if (rows.empty()) GTEST_SKIP() << "the collection is not here";
    RenderOptions options;
    options.width = options.height = 24, options.spp = 1;
    options.integrator = "cast";
    options.aovs = {"coverage"};
    const bool sampled = test::run_scale() < 1;
    size_t good = 0, shown = 0;
    for (const auto& row : rows) {
        if (row.kind != "good" || (sampled && ++good % 4 != 0)) continue;   // a picture of each takes minutes under a sanitizer
        auto imported = import_scene(data + "/" + row.file);
        if (!imported) continue;
        const auto box = extent(imported->scene);
        if (!box) continue;
        for (Material& m : imported->scene.materials)
            if (auto* pbr = std::get_if<GltfPbr>(&m.layers[0])) pbr->alpha_mode = AlphaMode::opaque;
        look_at(*box, imported->scene);
        std::string why;
        const auto film = picture_of(std::move(imported->scene), options, why);
        ASSERT_TRUE(film) << row.file << ": " << why;
        const auto coverage = channel(film->picture, "coverage.Y");
        EXPECT_TRUE(std::any_of(coverage.begin(), coverage.end(), [](float c) { return c > 0; })) << row.file << " shows nothing";
        ++shown;
    }
    EXPECT_GE(shown, sampled ? 25u : 100u);
}

}  // namespace
}  // namespace alidade
