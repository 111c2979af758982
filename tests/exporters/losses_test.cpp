// SPDX-License-Identifier: Apache-2.0
/// Nothing is left out in silence, and nothing hostile gets through.
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tests/core/folder_test.h"
#include "tests/exporters/samples.h"
#include "tests/scene/sample_scene.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>

namespace alidade::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Losing : public FolderTest {
  protected:
    /// "what: count" of each loss, a line each.
    std::string losses(const Scene& scene, const std::string& name) {
        const auto exported = export_scene(scene, (folder_ / name).string());
        EXPECT_TRUE(exported) << name << ": " << (exported ? "" : exported.error());
        std::string out;
        if (exported)
            for (const Loss& loss : exported->losses) out += fmt::format("{}: {}\n", loss.what, loss.count);
        return out;
    }
    bool reads(const std::string& name) {
        const auto read = import_scene((folder_ / name).string());
        EXPECT_TRUE(read) << name << ": " << (read ? "" : read.error().text());
        return bool(read);
    }
};

/// Everything that a scene can hold, in every format: it is written, can be read, and what is gone is said.
TEST_F(Losing, ASceneOfEverything) {
    const Scene scene = sample_scene();
    ASSERT_FALSE(validate(scene).has_errors());
    for (const char* name : {"all.gltf", "all.glb", "all.obj", "all.ply"}) {
        const std::string lost = losses(scene, name);
        EXPECT_TRUE(reads(name));
        for (const char* what : {"solids (intersections, differences, merges, clips)", "interiors: 1", "materials of insides: 1", "fogs: 1", "rainbows: 1", "sky spheres: 1", "media: 1",
                                 "other closed forms", "endless shapes"})
            EXPECT_THAT(lost, HasSubstr(what)) << name;
    }
}

TEST_F(Losing, FormatsWithoutNodesSayWhatHasNone) {
    for (const char* name : {"all.obj", "all.ply"})
        for (const char* what : {"lights: 1", "cameras: 1", "animations: 1", "skins: 1", "morph targets: 1"})
            EXPECT_THAT(losses(sample_scene(), name), HasSubstr(what)) << name;
    EXPECT_THAT(losses(sample_scene(), "all.ply"), HasSubstr("materials: 3"));
}

TEST_F(Losing, NothingIsLostOfATriangle) {
    for (const char* name : {"t.gltf", "t.glb", "t.obj"}) EXPECT_EQ(losses(triangle_scene(), name), name == std::string("t.obj") ? "single-sided materials: 1\n" : "");
    EXPECT_EQ(losses(triangle_scene(), "t.ply"), "");
}

TEST_F(Losing, NamesCannotBreakALine) {
    Scene scene = triangle_scene();
    GltfPbr pbr;
    pbr.base_color = SignalId{0};
    scene.signals.push_back({ConstantSignal{Vec4(0.5, 0.25, 0.125, 1)}, {}});
    const std::string evil = "a\nv 9 9 9\r\"../../etc/passwd\\\n#\t'\x01";
    scene.materials.push_back({evil, {pbr}, {}});
    scene.materials.push_back({evil, {pbr}, {}});
    scene.nodes[0].materials = {MaterialId{0}};
    scene.nodes[0].name = evil;
    scene.shapes[0].name = "\xff\xfe not UTF-8";
    scene.nodes.push_back(scene.nodes[0]);
    scene.nodes[1].materials = {MaterialId{1}};
    scene.roots.push_back({1});
    EXPECT_THAT(losses(scene, "evil.obj"), HasSubstr("characters in names"));
    for (const char* file : {"evil.obj", "evil.mtl"}) {
        EXPECT_THAT(text(file), Not(HasSubstr("9 9 9"))) << file;
        EXPECT_THAT(text(file), Not(HasSubstr("/etc"))) << file;
        EXPECT_THAT(text(file), Not(HasSubstr("\\"))) << file;
    }
    const auto read = import_scene((folder_ / "evil.obj").string());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->diagnostics.warnings(), 0u) << read->diagnostics.text();
    EXPECT_EQ(read->scene.materials.size(), 2u) << "two materials of one name stay two";
    losses(scene, "evil.gltf");
    const auto gltf = import_scene((folder_ / "evil.gltf").string());
    ASSERT_TRUE(gltf) << gltf.error().text();
    EXPECT_EQ(gltf->scene.nodes[0].name, evil) << "JSON can hold any name";
}

TEST_F(Losing, WhatIsNoNumberIsNeverWritten) {
    Scene scene = triangle_scene();
    Mesh& mesh = std::get<Mesh>(scene.shapes[0].geometry);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    mesh.positions.emplace_back(nan, 0.0f, inf);
    mesh.triangles.emplace_back(0u, 1u, 3u);
    mesh.normals.values.assign(4, Vec3f(nan));
    mesh.uvs.resize(1), mesh.uvs[0].values.assign(4, Vec2f(inf, nan));
    mesh.colors.resize(1), mesh.colors[0].values.assign(4, Vec4f(nan, inf, 0.5f, nan));
    scene.nodes[0].materials = {MaterialId{0}};
    GltfPbr pbr;
    pbr.base_color = SignalId{0};
    pbr.emissive = SignalId{0};
    scene.signals.push_back({ConstantSignal{Vec4(double(nan), 0, 0, 1)}, {}});
    scene.materials.push_back({"m", {pbr}, {}});
    for (const char* name : {"n.gltf", "n.glb", "n.obj", "n.ply"}) {
        EXPECT_THAT(losses(scene, name), HasSubstr("triangles with a vertex that is not finite: 1")) << name;
        const auto read = import_scene((folder_ / name).string());
        ASSERT_TRUE(read) << name << read.error().text();
        EXPECT_THAT(dump(read->scene), Not(HasSubstr("nan"))) << name;
        EXPECT_THAT(dump(read->scene), Not(HasSubstr("inf "))) << name;
        EXPECT_EQ(std::get<Mesh>(read->scene.shapes.at(0).geometry).triangles.size(), 1u) << name;
    }
    for (const char* name : {"n.gltf", "n.obj", "n.mtl"}) {
        EXPECT_THAT(text(name), Not(HasSubstr("nan"))) << name;
        EXPECT_THAT(text(name), Not(HasSubstr("null"))) << name;
    }
}

/// Thirty nodes, each twice the child of the next: a billion paths.
TEST_F(Losing, AGraphWithTooManyPathsIsRefused) {
    Scene scene = triangle_scene();
    for (uint32_t i = 0; i < 30; ++i) {
        Node twice;
        twice.children = {NodeId{i}, NodeId{i}};
        scene.nodes.push_back(twice);
    }
    scene.roots = {NodeId{30}};
    const auto exported = export_scene(scene, (folder_ / "bomb.gltf").string());
    ASSERT_FALSE(exported);
    EXPECT_THAT(exported.error(), HasSubstr("paths"));
    EXPECT_TRUE(fs::is_empty(folder_));
}

/// A pattern is written as the mean of its map: here 1/4 of black, 1/4 of the way to red and half of red, which lets a fifth of the light through.
TEST_F(Losing, PatternsLeaveTheirMeanColour) {
    Scene scene = triangle_scene();
    scene.signals = {{ConstantSignal{Vec4(0, 0, 0, 1)}, {}}, {ConstantSignal{Vec4(1, 0, 0, 1), 0.2, 0}, {}}};
    PatternSignal pattern;
    pattern.pattern = "bozo";
    pattern.map = {{0.5, SignalId{1}}, {0.25, SignalId{0}}};
    scene.signals.push_back({pattern, {}});
    PovFinish finish;
    finish.pigment = SignalId{2}, finish.diffuse = 0.5;
    scene.materials.resize(1);
    scene.materials[0].layers = {finish};
    scene.nodes[0].materials = {MaterialId{0}};
    EXPECT_THAT(losses(scene, "mean.gltf"), HasSubstr("patterns, functions and products of pictures: 1"));
    const auto read = import_scene((folder_ / "mean.gltf").string());
    ASSERT_TRUE(read);
    const auto& pbr = std::get<GltfPbr>(read->scene.materials[0].layers[0]);
    const Vec4 color = std::get<ConstantSignal>(read->scene.signals[pbr.base_color.index].what).value;
    EXPECT_NEAR(color.x, 0.5 * 0.625, 1e-6);
    EXPECT_NEAR(color.w, 1 - 0.2 * 0.625, 1e-6);
}

}  // namespace
}  // namespace alidade::test
