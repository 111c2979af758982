// SPDX-License-Identifier: Apache-2.0
/// Joints and weights: what the specification, section 3.7.3.3, says of them, and what files do.
#include "scene/queries.h"
#include "tests/importers/gltf_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A triangle with two sets of joints, moved by joints at z = 1 and z = 2, and `weights` for each vertex in each set.
struct Skinned {
    std::string weights_0 = packed<float>({1, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0, 0, 0}), weights_1 = packed<float>({0, 0, 0, 0, 0.5f, 0, 0, 0, 1, 0, 0, 0});
    std::string joints_1 = packed<uint8_t>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const char* attributes = R"("POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,"JOINTS_1":3,"WEIGHTS_1":4)";
    int matrices = 2;

    std::string text() const {
        const std::string positions = packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), joints_0(12, '\0');
        std::string bind;
        for (int i = 0; i < 2; ++i) bind += packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
        const std::string all = positions + joints_0 + weights_0 + joints_1 + weights_1 + bind;
        return fmt::format(R"("buffers":[{}],"bufferViews":[{{"buffer":0,"byteLength":{}}}],"accessors":[
            {{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},{{"bufferView":0,"byteOffset":36,"componentType":5121,"count":3,"type":"VEC4"}},
            {{"bufferView":0,"byteOffset":48,"componentType":5126,"count":3,"type":"VEC4"}},{{"bufferView":0,"byteOffset":96,"componentType":5121,"count":3,"type":"VEC4"}},
            {{"bufferView":0,"byteOffset":108,"componentType":5126,"count":3,"type":"VEC4"}},{{"bufferView":0,"byteOffset":156,"componentType":5126,"count":{},"type":"MAT4"}}],
            "meshes":[{{"primitives":[{{"attributes":{{{}}}}}]}}],"nodes":[{{"mesh":0,"skin":0}},{{"translation":[0,0,1]}},{{"translation":[0,0,2]}}],
            "skins":[{{"joints":[1,2],"inverseBindMatrices":5}}])",
                           buffer_json(all), all.size(), matrices, attributes);
    }
    std::string said() const {
        const auto result = import_text(with_asset(text()));
        return result ? result->diagnostics.text() : result.error().text();
    }
};

TEST(SkinSets, AreAllRead) {
    const Skinned file;
    EXPECT_THAT(file.said(), Not(HasSubstr("warning")));
    const Scene posed = deform(scene_of(file.text()));
    const Mesh& mesh = std::get<Mesh>(posed.shapes.at(1).geometry);
    EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 1}, {1, 0, 1.5f}, {0, 1, 2}}));
}

TEST(SkinSets, WithoutTheirOtherHalfAreLeftOut) {
    Skinned file;
    file.attributes = R"("POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,"WEIGHTS_1":4)";
    EXPECT_THAT(file.said(), HasSubstr("/meshes/0/primitives/0/attributes: warning: JOINTS_1 and WEIGHTS_1 are only used together"));
    EXPECT_EQ(std::get<Mesh>(scene_of(file.text()).shapes[0].geometry).joint_sets.size(), 1u);
    file.attributes = R"("POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,"JOINTS_8":1,"WEIGHTS_8":2)";
    EXPECT_THAT(file.said(), HasSubstr("/attributes/JOINTS_8: warning: only 8 sets are supported"));
}

TEST(SkinSets, WeightsThatDoNotAddUpAreScaled) {
    Skinned file;
    file.weights_1 = packed<float>({0, 0, 0, 0, 1.5f, 0, 0, 0, 1, 0, 0, 0});
    EXPECT_THAT(file.said(), HasSubstr("/meshes/0/primitives/0/attributes: warning: the joint weights of 1 vertices do not add up to 1: they are scaled; "
                                       "the first is vertex 1"));
    const Scene posed = deform(scene_of(file.text()));
    EXPECT_EQ(std::get<Mesh>(posed.shapes.at(1).geometry).positions[1], Vec3f(1, 0, 1.75f)) << "a quarter and three quarters";
    file.weights_1 = packed<float>({0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_THAT(file.said(), HasSubstr("warning: 1 vertices have no joint weights: no joint moves them"));
}

TEST(SkinSets, Errors) {
    Skinned file;
    file.weights_1 = packed<float>({0, 0, 0, 0, 0.5f, 0, 0, -0.25f, 1, 0, 0, 0});
    EXPECT_THAT(file.said(), HasSubstr("/meshes/0/primitives/0/attributes/WEIGHTS_1: error: vertex 1 has a negative weight"));
    file.weights_1 = packed<float>({0, 0, 0, 0, 0.5f, 0, 0, std::numeric_limits<float>::quiet_NaN(), 1, 0, 0, 0});
    EXPECT_THAT(file.said(), HasSubstr("/accessors/4: error: element 1 is not a number"));
    file = Skinned();
    file.joints_1[4] = 2;
    EXPECT_THAT(file.said(), HasSubstr("/nodes/0: error: vertices of the mesh name joints that the skin does not have: it has 2"));
    file = Skinned();
    file.matrices = 1;
    EXPECT_THAT(file.said(), HasSubstr("/skins/0/inverseBindMatrices: error: must be a MAT4 accessor of floats with an element for each of the 2 joints"));
}

}  // namespace
}  // namespace alidade::gltf_test
