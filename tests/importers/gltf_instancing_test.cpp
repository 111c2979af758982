// SPDX-License-Identifier: Apache-2.0
/// EXT_mesh_gpu_instancing, against the same copies written as nodes.
#include "scene/queries.h"
#include "tests/importers/gltf_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

using testing::HasSubstr;

/// A triangle (accessor 0), three translations (1), rotations as floats (2), shorts (3) and bytes (4), and scales (5).
std::string accessors() {
    const std::string data = packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + packed<float>({1, 2, 3, 4, 5, 6, 7, 8, 9}) +
                             packed<float>({0, 0, 0, 1, 0.6f, 0, 0, 0.8f, 0, 1, 0, 0}) + packed<float>({1, 1, 1, 2, 3, 4, -1, 1, 1}) +
                             packed<int16_t>({0, 0, 0, 32767, 19660, 0, 0, 26214, 0, 32767, 0, 0}) + packed<int8_t>({0, 0, 0, 127, 76, 0, 0, 102, 0, 127, 0, 0});
    return R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"},
        {"bufferView":0,"byteOffset":72,"componentType":5126,"count":3,"type":"VEC4"},{"bufferView":0,"byteOffset":156,"componentType":5122,"normalized":true,"count":3,"type":"VEC4"},
        {"bufferView":0,"byteOffset":180,"componentType":5120,"normalized":true,"count":3,"type":"VEC4"},{"bufferView":0,"byteOffset":120,"componentType":5126,"count":3,"type":"VEC3"},
        {"bufferView":0,"componentType":5126,"count":2,"type":"VEC3"},{"componentType":5126,"count":20000000,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":192}],"buffers":[)" + buffer_json(data) + "]";
}

std::string instanced(const std::string& attributes, const std::string& more = "", const std::string& primitives = R"({"attributes":{"POSITION":0},"material":0})") {
    return fmt::format(R"("scenes":[{{"nodes":[0]}}],"nodes":[{{"translation":[10,0,0],"children":[1]}},{{"name":"many","mesh":0,"scale":[2,2,2]{},"extensions":{{"EXT_mesh_gpu_instancing":{{"attributes":{{{}}}}}}}}}],
        "meshes":[{{"primitives":[{}]}}],"materials":[{{}}],"extensionsUsed":["EXT_mesh_gpu_instancing"],"extensionsRequired":["EXT_mesh_gpu_instancing"],{})", more, attributes, primitives, accessors());
}

/// Where the shapes of a scene stand.
std::vector<Transform> places(const Scene& scene) {
    std::vector<Transform> out;
    visit_paths(scene, [&](const Visit& visit) {
        if (std::holds_alternative<ShapeId>(scene.nodes[visit.node.index].what)) out.push_back(visit.to_world);
        return true;
    });
    return out;
}

double largest_difference(const std::vector<Transform>& a, const std::vector<Transform>& b) {
    double largest = a.size() == b.size() ? 0 : kInf;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        for (const Vec3& p : {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) largest = std::max(largest, length(a[i].point(p) - b[i].point(p)));
    return largest;
}

TEST(Instances, StandWhereNodesOfTheSameTransformsDo) {
    const Scene nodes = scene_of(R"("scenes":[{"nodes":[0]}],"nodes":[{"translation":[10,0,0],"scale":[2,2,2],"children":[1,2,3]},{"mesh":0,"translation":[1,2,3]},
        {"mesh":0,"translation":[4,5,6],"rotation":[0.6,0,0,0.8],"scale":[2,3,4]},{"mesh":0,"translation":[7,8,9],"rotation":[0,1,0,0],"scale":[-1,1,1]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)" + accessors());
    const std::vector<Transform> want = places(nodes);
    ASSERT_EQ(want.size(), 3u);
    // A byte is 1/254 off at the most, over lengths of up to 8.
    const std::pair<int, double> rotations[] = {{2, 1e-6}, {3, 1e-3}, {4, 0.2}};
    for (const auto& [accessor, bound] : rotations)
        EXPECT_LT(largest_difference(places(scene_of(instanced(fmt::format(R"("TRANSLATION":1,"ROTATION":{},"SCALE":5)", accessor)))), want), bound) << accessor;
    EXPECT_GT(largest_difference(places(scene_of(instanced(R"("TRANSLATION":1)"))), want), 1.0) << "the comparison must see rotations";
}

TEST(Instances, ShareTheMeshAndItsNode) {
    const Scene scene = scene_of(instanced(R"("TRANSLATION":1,"_ID":1)"));
    EXPECT_EQ(scene.shapes.size(), 1u);
    ASSERT_EQ(scene.nodes.size(), 2u + 1u + 3u) << "of the file, of the mesh, of the instances";
    EXPECT_EQ(scene.nodes[1].children, (std::vector<NodeId>{NodeId{3}, NodeId{4}, NodeId{5}}));
    for (uint32_t i = 3; i < 6; ++i) EXPECT_EQ(scene.nodes[i].children, std::vector<NodeId>{NodeId{2}});
    EXPECT_EQ(scene.nodes[2].materials, std::vector<std::optional<MaterialId>>{MaterialId{0}});
    EXPECT_EQ(scene.nodes[4].from.pointer, "/nodes/1");
}

/// A mesh of two parts, beside a camera: the camera is there once, both parts of the mesh three times.
TEST(Instances, OfAMeshInPartsBesideACamera) {
    const Scene scene = scene_of(instanced(R"("SCALE":5)", R"(,"camera":0)", R"({"attributes":{"POSITION":0}},{"attributes":{"POSITION":0,"NORMAL":1}})") +
                                 R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1}}])");
    EXPECT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(places(scene).size(), 6u);
    size_t cameras = 0;
    visit_paths(scene, [&](const Visit& visit) {
        cameras += std::holds_alternative<CameraId>(scene.nodes[visit.node.index].what);
        return true;
    });
    EXPECT_EQ(cameras, 1u);
}

TEST(Instances, AttributesOfAnApplicationAloneCountToo) { EXPECT_EQ(places(scene_of(instanced(R"("_ID":1)"))).size(), 3u); }
TEST(Instances, WithoutAttributesTheMeshIsThereOnce) { EXPECT_EQ(places(scene_of(instanced(""))).size(), 1u); }

struct Broken {
    const char *attributes, *message;
};
void PrintTo(const Broken& b, std::ostream* out) { *out << b.attributes; }
class BrokenInstances : public testing::TestWithParam<Broken> {};

TEST_P(BrokenInstances, AreRefusedAtTheirPlace) {
    const auto result = import_text(with_asset(instanced(GetParam().attributes)));
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().text(), HasSubstr(std::string("test.gltf:/nodes/1/extensions/EXT_mesh_gpu_instancing") + GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(Rules, BrokenInstances, testing::Values(
    Broken{R"("TRANSLATION":2)", "/attributes/TRANSLATION: error: must be a VEC3 accessor of floats"},
    Broken{R"("SCALE":3)", "/attributes/SCALE: error: must be a VEC3 accessor of floats"},
    Broken{R"("ROTATION":1)", "/attributes/ROTATION: error: must be a VEC4 accessor of floats, or of normalised bytes or shorts"},
    Broken{R"("SCALE":5,"TRANSLATION":6)", "/attributes/TRANSLATION: error: has 2 elements, but another attribute of the instances has 3"},
    Broken{R"("TRANSLATION":99)", "/attributes/TRANSLATION: error: index 99 is out of range"},
    Broken{R"("TRANSLATION":7)", ": error: the instances here and before are far more than the file holds data for"}));

}  // namespace
}  // namespace alidade::gltf_test
