// SPDX-License-Identifier: Apache-2.0
/// Files from the world: scenes exported by Blender, and a collection of valid and broken ones, where they are present.
#include "importers/gltf/gltf.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tests/importers/manifest.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <span>
#include <tuple>

namespace alidade {
namespace {

const std::string kData = SHARED_DATA;

/// Triangles of the shapes, and of the shapes as often as nodes show them.
struct Count {
    size_t mesh_nodes = 0, unique = 0, instanced = 0, mirrored = 0;
};
Count count(const Scene& scene) {
    Count out;
    for (const ShapeEntry& s : scene.shapes) out.unique += std::get<Mesh>(s.geometry).triangles.size();
    visit_paths(scene, [&](const Visit& visit) {
        const auto* shape = std::get_if<ShapeId>(&scene.nodes[visit.node.index].what);
        if (!shape) return true;
        ++out.mesh_nodes;
        out.instanced += std::get<Mesh>(scene.shapes[shape->index].geometry).triangles.size();
        out.mirrored += visit.to_world.determinant() < 0;
        return true;
    });
    return out;
}

class Blender : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(kData + "/blender")) GTEST_SKIP() << "the shared scenes are not here";
    }
    Scene load(const std::string& name) const {
        const auto result = import_scene(kData + "/blender/" + name + GetParam());
        EXPECT_TRUE(result) << (result ? "" : result.error().text());
        if (!result) return {};
        EXPECT_EQ(result->diagnostics.list().size(), 0u) << result->diagnostics.text();
        return result->scene;
    }
};

TEST_P(Blender, Instances) {
    const Scene scene = load("instances");
    const Count n = count(scene);
    EXPECT_EQ(scene.shapes.size(), 7u) << "geometry must not be copied";
    EXPECT_EQ(n.mesh_nodes, 242u);
    EXPECT_EQ(n.unique, 78734u);
    EXPECT_EQ(n.instanced, 3778574u);
    EXPECT_EQ(n.mirrored, 18u);
    EXPECT_NEAR(scene.lights.at(0).intensity.x, 3, 1e-6) << "a sun of strength 3 W/m^2 in Blender";
}

TEST_P(Blender, Textured) {
    const Scene scene = load("textured");
    EXPECT_EQ(scene.images.size(), 6u);
    size_t lookups = 0;
    for (const Signal& s : scene.signals) lookups += std::holds_alternative<ImageSignal>(s.what);
    EXPECT_EQ(lookups, 6u);
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_NEAR(scene.lights[0].intensity.x, 1500 / (4 * kPi), 1e-3) << "a spot of 1500 W in Blender";
    EXPECT_NEAR(scene.lights[1].intensity.x, 1, 1e-6);
}

TEST_P(Blender, Primitives) {
    const Scene scene = load("prims");
    EXPECT_EQ(scene.shapes.size(), 7u);
    EXPECT_NEAR(scene.lights.at(0).intensity.x, 1000 / (4 * kPi), 1e-3) << "a point light of 1000 W in Blender";
}

/// The text file and the binary one hold the same scene.
TEST_P(Blender, BothFormsAgree) {
    for (const char* name : {"instances", "prims"}) {
        Scene one = load(name);
        auto other = import_scene(kData + "/blender/" + name + ".glb");
        ASSERT_TRUE(other);
        one.files = other->scene.files;
        EXPECT_TRUE(dump(one) == dump(other->scene)) << name;
    }
}
INSTANTIATE_TEST_SUITE_P(Files, Blender, testing::Values(".glb", "_sep.gltf"), [](const auto& info) { return info.index ? "text" : "binary"; });

// ---- the collection ----

/// Valid files that are refused, each for a reason that the message gives.
constexpr const char* kRefusedForAReason[] = {
    "ACMEBox.gltf",                            // requires an extension that nobody knows
    "integer_written_as_float.gltf",           // its buffers are placeholders without data
    "teapots_galore_id.gltf",                  // a buffer view ends after its buffer
};

TEST(Collection, GoodFilesLoadAndBadOnesAreRefused) {
    const auto rows = gltf_test::gltf_manifest(kData);
    if (rows.empty()) GTEST_SKIP() << "the collection is not here";
    size_t good = 0, refused = 0;
    for (const auto& row : rows) {
        const auto result = import_scene(kData + "/" + row.file);
        EXPECT_TRUE(result || result.error().has_errors()) << row.file;
        if (row.kind == "good") {
            const bool expected = std::none_of(std::begin(kRefusedForAReason), std::end(kRefusedForAReason),
                                               [&](const char* end) { return row.file.find(end) != std::string::npos; });
            EXPECT_EQ(bool(result), expected) << row.file << (result ? "" : "\n" + result.error().text());
            good += bool(result);
        } else if (row.must_be_refused()) {
            EXPECT_FALSE(result) << row.file << ": " << row.exercises;
            refused += !result;
        }
    }
    EXPECT_GE(good, 178u);
    EXPECT_GE(refused, 54u);
}

/// What nodes show, in order: where, and with which vertices.
struct Shown {
    Transform to_world;
    std::vector<Vec3f> positions;
    std::vector<Index3> triangles;
    size_t uvs = 0, morphs = 0;
    bool skinned = false;
};
std::vector<Shown> shown(const Scene& scene) {
    std::vector<Shown> out;
    visit_paths(scene, [&](const Visit& visit) {
        const Node& node = scene.nodes[visit.node.index];
        if (const auto* shape = std::get_if<ShapeId>(&node.what)) {
            const Mesh& mesh = std::get<Mesh>(scene.shapes[shape->index].geometry);
            out.push_back({visit.to_world, mesh.positions, mesh.triangles, mesh.uvs.size(), mesh.morphs.size(), node.skin.has_value()});
        }
        return true;
    });
    return out;
}

void expect_the_same_shown(const Scene& part, const Scene& whole, const std::string& file) {
    const std::vector<Shown> want = shown(whole), got = shown(part);
    ASSERT_EQ(got.size(), want.size()) << file;
    for (size_t i = 0; i < got.size(); ++i) {
        EXPECT_EQ(std::tie(got[i].positions, got[i].triangles, got[i].uvs, got[i].morphs, got[i].skinned), std::tie(want[i].positions, want[i].triangles, want[i].uvs, want[i].morphs, want[i].skinned)) << file;
        EXPECT_EQ(got[i].to_world.linear, want[i].to_world.linear) << file;
        EXPECT_EQ(got[i].to_world.translation, want[i].to_world.translation) << file;
    }
    EXPECT_EQ(part.animations.size(), whole.animations.size()) << file;
}

/// The text of the file with the first root alone in its scene; empty where there are not two.
std::string with_one_root(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    auto document = nlohmann::json::parse(in, nullptr, false);
    if (!document.is_object() || !document.contains("scenes")) return {};
    auto& scene = document["scenes"][document.value("scene", size_t(0))];
    if (!scene.contains("nodes") || scene["nodes"].size() < 2) return {};
    scene["nodes"] = nlohmann::json::array({scene["nodes"][0]});
    return document.dump();
}

/// Without what no node shows, every file shows what it shows with it: whole, and with most of it taken out of the scene.
TEST(Collection, WhatIsNotShownMayStayUnread) {
    const auto rows = gltf_test::gltf_manifest(kData);
    if (rows.empty()) GTEST_SKIP() << "the collection is not here";
    ImportOptions options;
    options.shown_only = true;
    size_t fewer = 0, compared = 0;
    for (const auto& row : rows) {
        const std::string path = kData + "/" + row.file;
        const auto whole = import_scene(path), part = import_scene(path, options);
        if (!whole) continue;
        ASSERT_TRUE(part) << row.file << "\n" << part.error().text();
        expect_the_same_shown(part->scene, whole->scene, row.file);
        ++compared;
        const std::string text = path.ends_with(".gltf") ? with_one_root(path) : "";
        if (text.empty()) continue;
        const auto bytes = std::as_bytes(std::span(text));
        const std::string folder = std::filesystem::path(path).parent_path().string();
        const auto all = import_gltf_bytes(bytes, row.file, folder, {}), one = import_gltf_bytes(bytes, row.file, folder, options);
        ASSERT_TRUE(all && one) << row.file << "\n" << (one ? "" : one.error().text());
        expect_the_same_shown(one->scene, all->scene, row.file);
        fewer += one->scene.shapes.size() < all->scene.shapes.size();
    }
    EXPECT_GE(compared, 178u);
    EXPECT_GE(fewer, 10u);
}

}  // namespace
}  // namespace alidade
