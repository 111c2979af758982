// SPDX-License-Identifier: Apache-2.0
/// The files that an export leaves: their names, and that nothing of the user's is lost.
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "tests/core/folder_test.h"
#include "tests/exporters/samples.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>

namespace alidade::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\nnot decoded by anyone";

class Files : public FolderTest {
  protected:
    std::vector<std::string> there() const {
        std::vector<std::string> names;
        for (const auto& file : fs::directory_iterator(folder_)) names.push_back(file.path().filename().string());
        return names;
    }

    /// A triangle with a picture of these names.
    static Scene textured(const std::vector<std::string>& names) {
        Scene scene = triangle_scene();
        for (const std::string& name : names) {
            const auto bytes = std::as_bytes(std::span(kPng));
            scene.images.push_back({name, "", {bytes.begin(), bytes.end()}, {}});
            scene.images.back().bytes.push_back(std::byte(scene.images.size()));
            ImageSignal signal;
            signal.image = ImageId{uint32_t(scene.images.size() - 1)};
            scene.signals.push_back({signal, {}});
            GltfPbr pbr;
            pbr.base_color = SignalId{uint32_t(scene.signals.size() - 1)};
            scene.materials.push_back({name, {pbr}, {}});
            scene.nodes.push_back(scene.nodes[0]);
            scene.nodes.back().materials = {MaterialId{uint32_t(scene.materials.size() - 1)}};
            scene.roots.push_back({uint32_t(scene.nodes.size() - 1)});
        }
        return scene;
    }
};

TEST_F(Files, PicturesStandBesideByteByByte) {
    const Scene scene = textured({"wood.png", "../../wood", "wood"});
    ASSERT_TRUE(export_scene(scene, at("out.gltf")));
    EXPECT_THAT(there(), UnorderedElementsAre("out.gltf", "out.bin", "wood.png", "wood_2.png", "wood_3.png"));
    EXPECT_EQ(text("wood.png"), std::string(kPng) + '\1');
    EXPECT_EQ(text("wood_2.png"), std::string(kPng) + '\2');
    ASSERT_TRUE(export_scene(scene, at("out.gltf"))) << "a second time";
    EXPECT_EQ(there().size(), 5u) << "what is there with the same bytes is used";
    const auto read = import_scene(at("out.gltf"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->scene.images.size(), 3u);
}

TEST_F(Files, APictureOfAnotherIsNotOverwritten) {
    put("wood.png", "somebody's own");
    ASSERT_TRUE(export_scene(textured({"wood"}), at("out.obj")));
    EXPECT_EQ(text("wood.png"), "somebody's own");
    EXPECT_EQ(text("wood_2.png"), std::string(kPng) + '\1');
    EXPECT_THAT(text("out.mtl"), HasSubstr("map_Kd wood_2.png\n"));
}

TEST_F(Files, WhatWasReadIsNotOverwritten) {
    put("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto read = import_scene(at("in.obj"));
    ASSERT_TRUE(read);
    fs::create_hard_link(at("in.obj"), at("other_name.obj"));
    for (const char* name : {"in.obj", "other_name.obj", "./../in.obj"}) {
        const std::string path = name[0] == '.' ? (folder_ / ".." / folder_.filename() / "in.obj").string() : at(name);
        const auto exported = export_scene(read->scene, path);
        ASSERT_FALSE(exported) << name;
        EXPECT_THAT(exported.error(), HasSubstr("not overwritten"));
    }
    EXPECT_THAT(text("in.obj"), HasSubstr("v 0 0 0"));
    EXPECT_THAT(there(), UnorderedElementsAre("in.obj", "other_name.obj"));
}

TEST_F(Files, TheBufferOfAnotherFileIsNotOverwritten) {
    put("scene.bin", "the buffer of some other file");
    const auto exported = export_scene(triangle_scene(), at("scene.gltf"));
    ASSERT_FALSE(exported);
    EXPECT_THAT(exported.error(), HasSubstr("may belong to another file"));
    EXPECT_THAT(there(), ElementsAre("scene.bin"));
    ASSERT_TRUE(export_scene(triangle_scene(), at("scene.glb"))) << "which has no file beside it";
}

TEST_F(Files, AnUnknownEndingNamesTheKnownOnes) {
    const auto exported = export_scene(triangle_scene(), at("out.fbx"));
    ASSERT_FALSE(exported);
    EXPECT_THAT(exported.error(), HasSubstr(".gltf .glb .obj .ply"));
    EXPECT_EQ(find_exporter("a.GLB"), find_exporter("b.gltf"));
}

TEST_F(Files, PlainNames) {
    EXPECT_EQ(plain_name("Wood.001", "x"), "Wood.001");
    EXPECT_EQ(plain_name("a b/c\\d\"e\n", "x"), "a_b_c_d_e_");
    EXPECT_EQ(plain_name("", "x"), "x");
    EXPECT_EQ(plain_name("..", "x"), "x");
    EXPECT_EQ(plain_name("Bäume", "x"), "Bäume");
    EXPECT_LE(plain_name(std::string(300, 'a'), "x").size(), 100u);
    UniqueNames names;
    EXPECT_EQ(names.make("a", "x"), "a");
    EXPECT_EQ(names.make("a_2", "x"), "a_2");
    EXPECT_EQ(names.make("a", "x"), "a_3");
    EXPECT_EQ(names.make("a", "x"), "a_4");
}

}  // namespace
}  // namespace alidade::test
