// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/primitives.h"
#include "tests/importers/gltf_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

using testing::HasSubstr;

/// Four vertices of a unit square in xy, and room for other attributes.
const std::string kSquare = packed<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});

/// A file with one buffer of `bytes`, a view of all of it, `accessors`, and one mesh with `primitives`.
std::string mesh_file(const std::string& bytes, const std::string& accessors, const std::string& primitives, const std::string& more = "") {
    return fmt::format(
        R"("buffers":[{}],"bufferViews":[{{"buffer":0,"byteLength":{}}}],"accessors":[{}],"meshes":[{{"primitives":[{}]{}}}],"nodes":[{{"mesh":0}}])",
        buffer_json(bytes), bytes.size(), accessors, primitives, more);
}
std::string accessor(int component, const char* type, size_t count, size_t offset, const char* more = "") {
    return fmt::format(R"({{"bufferView":0,"byteOffset":{},"componentType":{},"count":{},"type":"{}"{}}})", offset, component, count, type, more);
}
const std::string kPositions = accessor(5126, "VEC3", 4, 0);

std::string said_of_mesh(const std::string& members) {
    const auto result = import_text(with_asset(members));
    return result ? result->diagnostics.text() : result.error().text();
}
std::string text(const std::vector<Index3>& triangles) {
    std::string out;
    for (const Index3& t : triangles) out += fmt::format("({} {} {})", t.x, t.y, t.z);
    return out;
}

/// glTF 2.0, section 3.7.2.1: strips alternate their winding, fans turn about their first vertex.
TEST(Triangles, AreAssembledByMode) {
    const std::vector<uint32_t> v = {0, 1, 2, 3, 4, 5};
    EXPECT_EQ(text(gltf::assemble_triangles(v, 4)), "(0 1 2)(3 4 5)");
    EXPECT_EQ(text(gltf::assemble_triangles(v, 5)), "(0 1 2)(1 3 2)(2 3 4)(3 5 4)");
    EXPECT_EQ(text(gltf::assemble_triangles(v, 6)), "(1 2 0)(2 3 0)(3 4 0)(4 5 0)");
    EXPECT_EQ(text(gltf::assemble_triangles({0, 1, 2, 2, 3, 3, 4, 5}, 5)), "(0 1 2)(3 5 4)") << "stitches are dropped";
    for (const int mode : {4, 5, 6}) EXPECT_EQ(text(gltf::assemble_triangles({0, 1}, mode)), "");
}

TEST(Meshes, IndicesOfEverySize) {
    const std::string i8 = packed<uint8_t>({0, 1, 2, 2, 3, 0}), i16 = packed<uint16_t>({0, 1, 2, 2, 3, 0}),
                      i32 = packed<uint32_t>({0, 1, 2, 2, 3, 0});
    for (const auto& [component, bytes] : {std::pair(5121, i8), {5123, i16}, {5125, i32}}) {
        const Scene scene = scene_of(
            mesh_file(kSquare + bytes, kPositions + "," + accessor(component, "SCALAR", 6, 48), R"({"attributes":{"POSITION":0},"indices":1})"));
        EXPECT_EQ(text(mesh_of(scene).triangles), "(0 1 2)(2 3 0)") << component;
        EXPECT_EQ(mesh_of(scene).positions.size(), 4u);
        EXPECT_EQ(mesh_of(scene).positions[2], Vec3f(1, 1, 0));
        EXPECT_FALSE(mesh_of(scene).normals.present()) << "without normals the mesh is flat";
    }
}

TEST(Meshes, BadIndicesAndAttributesAreErrors) {
    const std::string bytes = kSquare + packed<uint16_t>({0, 1, 4, 0xffff});
    const auto with_indices = [&](const std::string& indices) {
        return mesh_file(bytes, kPositions + "," + indices, R"({"attributes":{"POSITION":0},"indices":1})");
    };
    EXPECT_THAT(said_of_mesh(with_indices(accessor(5123, "SCALAR", 3, 48))),
                HasSubstr("/meshes/0/primitives/0/indices: error: index 2 is 4, but there are 4 vertices"));
    EXPECT_THAT(said_of_mesh(with_indices(accessor(5123, "SCALAR", 1, 54))),
                HasSubstr("index 0 is 65535, but there are 4 vertices\nhint: glTF does not allow primitive restart values"));
    EXPECT_THAT(said_of_mesh(with_indices(accessor(5126, "SCALAR", 3, 0))), HasSubstr("indices must be a SCALAR accessor of unsigned integers"));
    EXPECT_THAT(said_of_mesh(with_indices(accessor(5123, "VEC2", 2, 48))), HasSubstr("indices must be a SCALAR accessor of unsigned integers"));

    const auto with_attribute = [&](const char* name, const std::string& a) {
        return mesh_file(bytes, kPositions + "," + a, fmt::format(R"({{"attributes":{{"POSITION":0,"{}":1}}}})", name));
    };
    EXPECT_THAT(said_of_mesh(with_attribute("NORMAL", accessor(5126, "VEC3", 3, 0))),
                HasSubstr("/meshes/0/primitives/0/attributes/NORMAL: error: 3 elements, but POSITION has 4"));
    EXPECT_THAT(said_of_mesh(with_attribute("NORMAL", accessor(5126, "VEC2", 4, 0))), HasSubstr("/attributes/NORMAL: error: the accessor must be VEC3"));
    EXPECT_THAT(said_of_mesh(with_attribute("COLOR_0", accessor(5126, "VEC2", 4, 0))),
                HasSubstr("/attributes/COLOR_0: error: the accessor must be VEC3 or VEC4"));
    EXPECT_THAT(said_of_mesh(with_attribute("JOINTS_0", accessor(5126, "VEC4", 3, 0))),
                HasSubstr("/attributes/JOINTS_0: error: the accessor has the wrong component type"));
    EXPECT_THAT(said_of_mesh(with_attribute("TEXCOORD_4000000000", accessor(5126, "VEC2", 4, 0))),
                HasSubstr("/attributes/TEXCOORD_4000000000: warning: only 8 sets are supported"));
    EXPECT_THAT(said_of_mesh(with_attribute("TEXCOORD_99999999999", accessor(5126, "VEC2", 4, 0))),
                HasSubstr("/attributes/TEXCOORD_99999999999: warning: unknown attribute"));
    EXPECT_THAT(said_of_mesh(with_attribute("UV", accessor(5126, "VEC2", 4, 0))), HasSubstr("/attributes/UV: warning: unknown attribute"));
    EXPECT_THAT(said_of_mesh(with_attribute("_MINE", accessor(5126, "VEC2", 1, 0))), testing::Not(HasSubstr("_MINE"))) << "an application's own";
}

TEST(Meshes, WithoutASurfaceAreNamed) {
    EXPECT_THAT(said_of_mesh(mesh_file(kSquare, kPositions, R"({"attributes":{"POSITION":0},"mode":0})")),
                HasSubstr("/meshes/0/primitives/0: warning: points have no surface"));
    EXPECT_THAT(said_of_mesh(mesh_file(kSquare, kPositions, R"({"attributes":{"POSITION":0},"mode":3})")),
                HasSubstr("/meshes/0/primitives/0: warning: lines have no surface"));
    EXPECT_THAT(said_of_mesh(mesh_file(kSquare, kPositions, R"({"attributes":{}})")),
                HasSubstr("/meshes/0/primitives/0: warning: the primitive has no POSITION"));
    EXPECT_THAT(said_of_mesh(mesh_file(kSquare, kPositions, R"({"attributes":{"POSITION":0}})")),
                HasSubstr("warning: 4 vertices do not make whole triangles"));
}

TEST(Meshes, AttributesOfEveryKind) {
    const std::string bytes =
        kSquare + packed<uint8_t>({0, 255, 51, 0, 255, 255, 0, 0}) + packed<uint8_t>({255, 0, 51, 0, 255, 0, 51, 0, 255, 0, 51, 0, 255, 0, 51, 0});
    const std::string accessors = kPositions + "," + accessor(5121, "VEC2", 4, 48, R"(,"normalized":true)") +
                                  R"(,{"bufferView":1,"componentType":5121,"count":4,"type":"VEC3","normalized":true})";
    std::string file = mesh_file(bytes, accessors, R"({"attributes":{"POSITION":0,"TEXCOORD_1":1,"COLOR_0":2},"mode":6})");
    file.replace(file.find("\"bufferViews\":["), 15, R"("bufferViews":[)");
    const std::string second = fmt::format(R"(,{{"buffer":0,"byteOffset":56,"byteLength":16,"byteStride":4}}],"accessors")");
    file.replace(file.find("],\"accessors\""), 13, second);
    const Scene scene = scene_of(file);
    const Mesh& mesh = mesh_of(scene);
    ASSERT_EQ(mesh.uvs.size(), 2u) << "sets keep their numbers";
    EXPECT_FALSE(mesh.uvs[0].present());
    EXPECT_EQ(mesh.uvs[1].values[1], Vec2f(0.2f, 0));
    ASSERT_EQ(mesh.colors.size(), 1u);
    EXPECT_EQ(mesh.colors[0].values[3], Vec4f(1, 0, 0.2f, 1)) << "RGB is opaque";
    EXPECT_EQ(text(mesh.triangles), "(1 2 0)(2 3 0)");
}

/// Primitives of one mesh with the same attributes are slots of one shape; a node that uses the mesh again shares it.
TEST(Meshes, PrimitivesBecomeSlots) {
    const std::string bytes = kSquare + packed<uint16_t>({0, 1, 2, 2, 3, 0});
    const std::string accessors = kPositions + "," + accessor(5123, "SCALAR", 3, 48) + "," + accessor(5123, "SCALAR", 3, 54);
    std::string file = mesh_file(
        bytes, accessors,
        R"({"attributes":{"POSITION":0},"indices":1,"material":1},{"attributes":{"POSITION":0,"NORMAL":0},"indices":1,"material":0},{"attributes":{"POSITION":0},"indices":2})");
    file += R"(,"materials":[{},{}])";
    file.replace(file.find("\"nodes\":[{\"mesh\":0}]"), 20, "\"nodes\":[{\"mesh\":0},{\"mesh\":0}]");
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(mesh_of(scene).slots, (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(mesh_of(scene).triangles.size(), 2u);
    EXPECT_EQ(mesh_of(scene).positions[mesh_of(scene).triangles[1].y], Vec3f(0, 1, 0));
    EXPECT_TRUE(mesh_of(scene, 1).normals.present());
    // Each node has two parts, which are children of their own.
    ASSERT_EQ(scene.nodes.size(), 6u);
    EXPECT_EQ(scene.nodes[0].children, (std::vector<NodeId>{NodeId{2}, NodeId{3}}));
    EXPECT_EQ(scene.nodes[1].children, (std::vector<NodeId>{NodeId{4}, NodeId{5}}));
    for (const size_t part : {2, 4}) {
        EXPECT_EQ(std::get<ShapeId>(scene.nodes[part].what), ShapeId{0});
        EXPECT_EQ(scene.nodes[part].materials, (std::vector<std::optional<MaterialId>>{MaterialId{1}, std::nullopt}));
        EXPECT_EQ(std::get<ShapeId>(scene.nodes[part + 1].what), ShapeId{1});
    }
}

/// Two meshes that differ in their materials alone have one shape.
TEST(Meshes, EqualGeometryIsShared) {
    std::string file = mesh_file(kSquare, kPositions, R"({"attributes":{"POSITION":0},"mode":6,"material":0})");
    file.replace(file.find("],\"nodes\""), 9, R"(,{"primitives":[{"attributes":{"POSITION":0},"mode":6,"material":1}]}],"nodes")");
    file.replace(file.find("\"nodes\":[{\"mesh\":0}]"), 20, "\"nodes\":[{\"mesh\":0},{\"mesh\":1}]");
    const Scene scene = scene_of(file + R"(,"materials":[{},{}])");
    EXPECT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.nodes[0].materials[0], MaterialId{0});
    EXPECT_EQ(scene.nodes[1].materials[0], MaterialId{1});
}

/// A small piece of a large vertex array takes only its own vertices with it.
TEST(Meshes, UnusedVerticesAreLeftOut) {
    std::string bytes;
    for (int i = 0; i < 1000; ++i) bytes += packed<float>({float(i), 0, float(i % 7)});
    bytes += packed<uint16_t>({900, 17, 500});
    const Scene scene = scene_of(mesh_file(bytes, accessor(5126, "VEC3", 1000, 0) + "," + accessor(5123, "SCALAR", 3, 12000),
                                           R"({"attributes":{"POSITION":0,"NORMAL":0},"indices":1})"));
    const Mesh& mesh = mesh_of(scene);
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.positions[mesh.triangles[0].x].x, 900);
    EXPECT_EQ(mesh.positions[mesh.triangles[0].y].x, 17);
    EXPECT_EQ(mesh.normals.values[mesh.triangles[0].z], Vec3f(500, 0, 500 % 7));
}

TEST(Meshes, MorphTargets) {
    const std::string bytes = kSquare + kSquare;
    const std::string accessors = kPositions + "," + accessor(5126, "VEC3", 4, 48) + "," + accessor(5126, "VEC3", 3, 48);
    const Scene scene = scene_of(
        mesh_file(bytes, accessors, R"({"attributes":{"POSITION":0},"mode":6,"targets":[{"POSITION":1},{"NORMAL":1}]})", R"(,"weights":[0.25,0.5])"));
    const Mesh& mesh = mesh_of(scene);
    ASSERT_EQ(mesh.morphs.size(), 2u);
    EXPECT_EQ(mesh.morphs[0].positions[2], Vec3f(1, 1, 0));
    EXPECT_TRUE(mesh.morphs[1].positions.empty());
    EXPECT_EQ(mesh.morph_weights, (std::vector<double>{0.25, 0.5}));
    EXPECT_THAT(said_of_mesh(mesh_file(bytes, accessors, R"({"attributes":{"POSITION":0},"mode":6,"targets":[{"POSITION":2}]})")),
                HasSubstr("/meshes/0/primitives/0/targets/0/POSITION: error: a morph target needs a VEC3 accessor of 4 elements"));
    EXPECT_THAT(said_of_mesh(mesh_file(bytes, accessors,
                               R"({"attributes":{"POSITION":0},"mode":6,"targets":[{"POSITION":1}]},{"attributes":{"POSITION":0},"mode":6})")),
                HasSubstr("/meshes/0/primitives/1: error: all primitives of a mesh need the same number of morph targets"));
    EXPECT_THAT(said_of_mesh(mesh_file(bytes, accessors, R"({"attributes":{"POSITION":0},"mode":6})", R"(,"weights":[1])")),
                HasSubstr("/meshes/0/weights: warning: 1 weights for 0 morph targets"));
}

/// An accessor without a buffer view is zeros, changed by its sparse values; indices of zeros are degenerate, not an error.
TEST(Meshes, SparsePositionsWithoutABufferView) {
    const std::string bytes = packed<uint16_t>({1, 2}) + packed<float>({5, 0, 0, 0, 5, 0});
    const Scene scene = scene_of(
        mesh_file(bytes, R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":0,"componentType":5123},
        "values":{"bufferView":0,"byteOffset":4}}})",
                  R"({"attributes":{"POSITION":0}})"));
    EXPECT_EQ(mesh_of(scene).positions, (std::vector<Vec3f>{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}}));
}

/// KHR_mesh_quantization: integer positions are integers.
TEST(Meshes, QuantizedPositions) {
    const std::string bytes = packed<int16_t>({-3, 0, 7, 0, 5, 0, 0, 0, 0, 9, 0, 0});
    std::string file = mesh_file(bytes, accessor(5122, "VEC3", 3, 0), R"({"attributes":{"POSITION":0}})");
    file.replace(file.find("\"byteLength\":24}]"), 17, "\"byteLength\":24,\"byteStride\":8}]");
    EXPECT_EQ(mesh_of(scene_of(file)).positions, (std::vector<Vec3f>{{-3, 0, 7}, {5, 0, 0}, {0, 9, 0}}));
}

}  // namespace
}  // namespace alidade::gltf_test
