// SPDX-License-Identifier: Apache-2.0
/// Nodes, cameras, lights, skins and animations.
#include "tests/importers/gltf_text.h"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

using testing::HasSubstr;

std::string said(const std::string& members) {
    const auto result = import_text(with_asset(members));
    return result ? result->diagnostics.text() : result.error().text();
}

TEST(Nodes, MatricesAndParts) {
    const Scene scene = scene_of(
        R"("nodes":[{"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]},{"translation":[1,2,3],"rotation":[0,0,0.70710678118654752,0.70710678118654752],"scale":[2,3,-4]}])");
    EXPECT_FALSE(scene.nodes[0].trs) << "a matrix is not taken apart";
    EXPECT_EQ(scene.nodes[0].to_parent.point(Vec3(1, 0, 0)), Vec3(5, 7, 7));
    ASSERT_TRUE(scene.nodes[1].trs);
    EXPECT_EQ(scene.nodes[1].trs->scale, Vec3(2, 3, -4));
    const Vec3 p = scene.nodes[1].to_parent.point(Vec3(1, 1, 1));   // scaled (2, 3, -4), turned (-3, 2, -4), moved
    EXPECT_LT(length(p - Vec3(-2, 4, -1)), 1e-12);
    EXPECT_LT(scene.nodes[1].to_parent.determinant(), 0);
    EXPECT_EQ(scene.nodes[1].from.pointer, "/nodes/1");
}

TEST(Nodes, TheSceneThatIsShown) {
    const std::string nodes = R"("nodes":[{"children":[1]},{},{}])";
    EXPECT_EQ(scene_of(nodes).roots, (std::vector<NodeId>{NodeId{0}, NodeId{2}})) << "without scenes: all roots";
    EXPECT_EQ(scene_of(nodes + R"(,"scenes":[{"nodes":[2]},{"nodes":[0]}])").roots, std::vector<NodeId>{NodeId{2}}) << "the first";
    EXPECT_EQ(scene_of(nodes + R"(,"scenes":[{"nodes":[2]},{"nodes":[0]}],"scene":1)").roots, std::vector<NodeId>{NodeId{0}}) << "the chosen one";
    EXPECT_TRUE(scene_of(nodes + R"(,"scenes":[{}])").roots.empty());
}

TEST(Nodes, AFileThatShowsNothingIsToldOfWhereItIsDrawn) {
    ImportOptions shown;
    shown.shown_only = true;
    for (const char* members : {"", R"("nodes":[{}])", R"("nodes":[{}],"scenes":[{}])"}) {
        EXPECT_THAT(import_text(with_asset(members), shown)->diagnostics.text(), HasSubstr("warning: the scene is empty")) << members;
        EXPECT_EQ(said(members).find("empty"), std::string::npos) << "it can be converted";
    }
}

TEST(Nodes, Visibility) {
    const Scene scene = scene_of(R"("nodes":[{"extensions":{"KHR_node_visibility":{"visible":false}}},{"extensions":{"KHR_node_visibility":{}}}])");
    EXPECT_FALSE(scene.nodes[0].flags.visible);
    EXPECT_TRUE(scene.nodes[1].flags.visible);
}

TEST(Nodes, OneThingEach) {
    const Scene scene = scene_of(
        R"("nodes":[{"name":"both","camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}}],"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1}}],
        "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}})");
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<Nothing>(scene.nodes[0].what));
    EXPECT_EQ(scene.nodes[0].children, (std::vector<NodeId>{NodeId{1}, NodeId{2}}));
    EXPECT_EQ(std::get<LightId>(scene.nodes[1].what), LightId{0});
    EXPECT_EQ(std::get<CameraId>(scene.nodes[2].what), CameraId{0});
    EXPECT_EQ(scene.cameras[0].name, "both") << "a camera without a name has its node's";
}

/// In the scene graph materials are inherited, so the mesh of a node with children stands beside them: a child without a material keeps the default one.
TEST(Nodes, AMeshKeepsItsMaterialForItself) {
    const std::string bytes = R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}])";
    const Scene scene = scene_of(bytes + R"(,"materials":[{}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]},
        {"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0,"children":[1]},{"mesh":1}])");
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_TRUE(scene.nodes[0].materials.empty());
    EXPECT_EQ(scene.nodes[0].children, (std::vector<NodeId>{NodeId{1}, NodeId{2}}));
    EXPECT_EQ(scene.nodes[2].materials, (std::vector<std::optional<MaterialId>>{MaterialId{0}}));
    EXPECT_EQ(scene.nodes[1].materials, (std::vector<std::optional<MaterialId>>{std::nullopt}));
}

/// The edges of the picture are yfov / 2 from the axis.
TEST(Cameras, PerspectiveAndOrthographic) {
    const Scene scene = scene_of(
        R"("cameras":[{"type":"perspective","perspective":{"yfov":1.2,"aspectRatio":2,"znear":1}},{"type":"perspective","perspective":{"yfov":1.2,"znear":1,"zfar":9}},
        {"type":"orthographic","orthographic":{"xmag":3,"ymag":2,"zfar":9,"znear":0}}])");
    const Camera& wide = scene.cameras[0];
    EXPECT_NEAR(std::atan2(wide.up.y / 2, -wide.direction.z), 0.6, 1e-12);
    EXPECT_NEAR(wide.right.x, 2 * wide.up.y, 1e-12);
    EXPECT_EQ(wide.fit, Fit::show_all);
    EXPECT_EQ(scene.cameras[1].fit, Fit::height);
    EXPECT_NEAR(scene.cameras[1].right.x, scene.cameras[1].up.y, 1e-12);
    EXPECT_EQ(scene.cameras[2].projection, Projection::orthographic);
    EXPECT_EQ(scene.cameras[2].right, Vec3(6, 0, 0));
    EXPECT_EQ(scene.cameras[2].up, Vec3(0, 4, 0));
}

std::string lights_by(const std::string& generator) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0","generator":"{}"}},"extensions":{{"KHR_lights_punctual":{{"lights":[{{"type":"point","intensity":683,"color":[1,0.5,0]}},
        {{"type":"spot","range":7,"spot":{{"innerConeAngle":0.25,"outerConeAngle":0.5}}}},{{"type":"directional"}},{{"type":"lamp"}},{{"type":"point","name":"last"}}]}}}},
        "nodes":[{{"extensions":{{"KHR_lights_punctual":{{"light":4}}}}}},{{"extensions":{{"KHR_lights_punctual":{{"light":3}}}}}}]}})",
        generator);
}

TEST(Lights, KindsAndReferences) {
    const auto result = import_text(lights_by("somebody"));
    ASSERT_TRUE(result) << result.error().text();
    const Scene& scene = result->scene;
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(scene.lights[0].intensity, Color(683, 341.5, 0));
    EXPECT_EQ(scene.lights[0].range, kInf);
    EXPECT_EQ(std::get<SpotLight>(scene.lights[1].kind).outer_angle, 0.5);
    EXPECT_EQ(scene.lights[1].range, 7);
    EXPECT_TRUE(std::holds_alternative<DirectionalLight>(scene.lights[2].kind));
    EXPECT_EQ(std::get<LightId>(scene.nodes[0].what), LightId{3}) << "ids skip the light that is left out";
    EXPECT_TRUE(std::holds_alternative<Nothing>(scene.nodes[1].what));
}

/// Blender's exporter 3.4 and newer writes photometric numbers; the user has the last word.
TEST(Lights, Units) {
    const auto first_intensity = [](const std::string& generator, LightUnitsOption option) {
        ImportOptions options;
        options.light_units = option;
        const auto result = import_text(lights_by(generator), options);
        EXPECT_TRUE(result);
        EXPECT_NE(result->scene.settings.why_light_units, "");
        EXPECT_EQ(result->scene.settings.light_units == LightUnits::photometric, result->scene.lights[0].intensity.x < 10) << generator;
        return result->scene.lights[0].intensity.x;
    };
    const auto automatic = LightUnitsOption::automatic;
    EXPECT_NEAR(first_intensity("Khronos glTF Blender I/O v3.4.50", automatic), 1, 1e-12);
    EXPECT_NEAR(first_intensity("Khronos glTF Blender I/O v5.0.16", automatic), 1, 1e-12);
    EXPECT_EQ(first_intensity("Khronos glTF Blender I/O v3.3.99", automatic), 683);
    EXPECT_EQ(first_intensity("Khronos glTF Blender I/O v", automatic), 683);
    EXPECT_EQ(first_intensity("THREE.GLTFExporter", automatic), 683);
    EXPECT_EQ(first_intensity("Khronos glTF Blender I/O v3.4.50", LightUnitsOption::raw), 683);
    EXPECT_NEAR(first_intensity("THREE.GLTFExporter", LightUnitsOption::photometric), 1, 1e-12);
}

// ---- skins and animations: one triangle, joints and weights, keys ----

/// 0 positions, 1 joints, 2 weights, 3 two matrices, 4 times 0 1, 5 the same time twice, 6 two vectors, 7 two quaternions as bytes, 8 six vectors
std::string animated(const std::string& more) {
    const std::string floats = packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::string joints = packed<uint8_t>({0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0});
    std::string weights, matrices;
    for (int i = 0; i < 3; ++i) weights += packed<float>({0.5f, 0.5f, 0, 0});
    for (int i = 0; i < 2; ++i) matrices += packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, float(i), 2, 3, 1});
    const std::string times = packed<float>({0, 1, 1, 1}), vectors = packed<float>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18});
    const std::string quaternions = packed<int8_t>({0, 0, 0, 127, 0, 127, 0, 0});
    const std::string all = floats + joints + weights + matrices + times + vectors + quaternions;
    const size_t w = 36 + 12, m = w + 48, t = m + 128, v = t + 16, q = v + 72;
    return fmt::format(R"("buffers":[{}],"bufferViews":[{{"buffer":0,"byteLength":{}}}],"accessors":[
        {{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},{{"bufferView":0,"byteOffset":36,"componentType":5121,"count":3,"type":"VEC4"}},
        {{"bufferView":0,"byteOffset":{},"componentType":5126,"count":3,"type":"VEC4"}},{{"bufferView":0,"byteOffset":{},"componentType":5126,"count":2,"type":"MAT4"}},
        {{"bufferView":0,"byteOffset":{},"componentType":5126,"count":2,"type":"SCALAR"}},{{"bufferView":0,"byteOffset":{},"componentType":5126,"count":2,"type":"SCALAR"}},
        {{"bufferView":0,"byteOffset":{},"componentType":5126,"count":2,"type":"VEC3"}},{{"bufferView":0,"byteOffset":{},"componentType":5120,"count":2,"type":"VEC4","normalized":true}},
        {{"bufferView":0,"byteOffset":{},"componentType":5126,"count":6,"type":"VEC3"}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}},"targets":[{{"POSITION":0}},{{"POSITION":0}}]}}]}},{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],{})",
                       buffer_json(all), all.size(), w, m, t, t + 8, v, q, v, more);
}

TEST(Skins, JointsAndMatrices) {
    const Scene scene = scene_of(animated(R"("nodes":[{"mesh":0,"skin":0},{},{}],"skins":[{"joints":[1,2],"inverseBindMatrices":3}])"));
    ASSERT_EQ(scene.skins.size(), 1u);
    EXPECT_EQ(scene.nodes[0].skin, SkinId{0});
    EXPECT_EQ(scene.skins[0].joints, (std::vector<NodeId>{NodeId{1}, NodeId{2}}));
    EXPECT_EQ(scene.skins[0].inverse_bind.at(1).translation, Vec3(1, 2, 3));
    const Mesh& mesh = std::get<Mesh>(scene.shapes[0].geometry);
    EXPECT_EQ(mesh.joint_sets.at(0).joints.at(2), Joints4(1, 1, 0, 0));
    EXPECT_EQ(mesh.joint_sets.at(0).weights.at(2), Vec4f(0.5f, 0.5f, 0, 0));
}

TEST(Skins, Errors) {
    EXPECT_THAT(said(animated(R"("nodes":[{"mesh":0,"skin":0},{}],"skins":[{"joints":[1]}])")),
                HasSubstr("/nodes/0: error: vertices of the mesh name joints that the skin does not have: it has 1"));
    EXPECT_THAT(said(animated(R"("nodes":[{"mesh":1,"skin":0},{}],"skins":[{"joints":[1]}])")),
                HasSubstr("/nodes/0: warning: the node has a skin, but its mesh names no joints"));
    EXPECT_THAT(said(animated(R"("nodes":[{},{},{}],"skins":[{"joints":[0,1,2],"inverseBindMatrices":3}])")),
                HasSubstr("/skins/0/inverseBindMatrices: error: must be a MAT4 accessor of floats with"));
}

std::string animation(const char* path, int input, int output, const char* interpolation = "LINEAR", int node = 0) {
    return animated(fmt::format(
        R"("nodes":[{{"mesh":0}},{{"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}},{{"mesh":1}}],"animations":[{{"name":"a","samplers":[{{"input":{},"output":{},"interpolation":"{}"}}],
        "channels":[{{"sampler":0,"target":{{"node":{},"path":"{}"}}}}]}}])",
        input, output, interpolation, node, path));
}

TEST(Animations, ChannelsAreKeptAsData) {
    const Scene moved = scene_of(animation("translation", 4, 6, "STEP"));
    const Channel& step = moved.animations.at(0).channels.at(0);
    EXPECT_EQ(step.path, ChannelPath::translation);
    EXPECT_EQ(step.interpolation, Interpolation::step);
    EXPECT_EQ(step.times, (std::vector<float>{0, 1}));
    EXPECT_EQ(step.values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(step.width, 3u);

    const Scene turned = scene_of(animation("rotation", 4, 7));
    EXPECT_EQ(turned.animations[0].channels[0].values, (std::vector<float>{0, 0, 0, 1, 0, 1, 0, 0})) << "normalised bytes";
    EXPECT_EQ(turned.animations[0].channels[0].width, 4u);

    const Scene smooth = scene_of(animation("scale", 4, 8, "CUBICSPLINE"));
    EXPECT_EQ(smooth.animations[0].channels[0].interpolation, Interpolation::cubic);
    EXPECT_EQ(smooth.animations[0].channels[0].values.size(), 18u) << "two tangents and a value for each key";
}

TEST(Animations, Errors) {
    EXPECT_THAT(said(animation("translation", 6, 6)), HasSubstr("/animations/0/samplers/0/input: error: must be a SCALAR accessor of floats"));
    EXPECT_THAT(said(animation("rotation", 4, 6)), HasSubstr("/animations/0/samplers/0/output: error: the accessor has the wrong type"));
    EXPECT_THAT(said(animation("scale", 4, 8)), HasSubstr("/animations/0/samplers/0/output: error: 6 elements, but 2 keys need 2"));
    EXPECT_THAT(said(animation("scale", 5, 6)),
                HasSubstr("/animations/0/samplers/0/input: warning: the times do not increase after key 0: the channel is left out"));
    EXPECT_THAT(
        said(animation("scale", 4, 6, "LINEAR", 1)),
        HasSubstr("/animations/0/channels/0: warning: the target's transform is a matrix, which cannot be animated: the channel is left out"));
    EXPECT_THAT(said(animation("weights", 4, 4, "LINEAR", 1)), HasSubstr("/animations/0/channels/0: warning: the target has no mesh to morph"));
    EXPECT_THAT(said(animation("weights", 4, 4, "LINEAR", 2)),
                HasSubstr("/animations/0/channels/0: warning: the target's mesh has no morph targets"));
    EXPECT_THAT(said(animation("weights", 4, 4)), HasSubstr("/animations/0/samplers/0/output: error: 2 elements, but 2 keys need 4"));
    EXPECT_THAT(said(R"("nodes":[{}],"accessors":[],"animations":[{"samplers":[],"channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}]}])"),
                HasSubstr("/animations/0/channels/0/sampler: error: index 0 is out of range: the animation has 0 samplers"));
}

}  // namespace
}  // namespace alidade::gltf_test
