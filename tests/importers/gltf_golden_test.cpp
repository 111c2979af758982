// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tests/importers/gltf_text.h"

namespace alidade::gltf_test {
namespace {

/// A whole small file and the whole scene that it must become.
TEST(Golden, ATriangleALightAndACamera) {
    const std::string positions = packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::string json = R"({"asset":{"version":"2.0","generator":"by hand"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[
        {"name":"all","children":[1,2,3]},{"name":"triangle","mesh":0,"translation":[1,2,3]},{"name":"eye","camera":0},{"name":"lamp","extensions":{"KHR_lights_punctual":{"light":0}}}],
        "meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0},"material":0}]}],"materials":[{"name":"red","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}],
        "cameras":[{"type":"orthographic","orthographic":{"xmag":2,"ymag":1,"zfar":9,"znear":0}}],
        "extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","name":"l","intensity":5}]}},
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36}]})";
    const auto result = import_text(glb(json, positions));
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->diagnostics.list().size(), 0u) << result->diagnostics.text();
    EXPECT_EQ(dump(result->scene), R"(file 0 path="test.gltf"
settings why_light_units="nothing says that the file holds candela and lux: intensities are used as they are" generator="by hand"
atmosphere
roots nodes=[0]
node 0 name="all" trs translation=<0 0 0> rotation=<0 0 0 1> scale=<1 1 1> children=[1 2 3] from=0:0:0:"/nodes/0"
node 1 name="triangle" shape=0 to_parent=<1 0 0><0 1 0><0 0 1><1 2 3> trs translation=<1 2 3> rotation=<0 0 0 1> scale=<1 1 1> materials=[0] from=0:0:0:"/nodes/1"
node 2 name="eye" camera=0 trs translation=<0 0 0> rotation=<0 0 0 1> scale=<1 1 1> from=0:0:0:"/nodes/2"
node 3 name="lamp" light=0 trs translation=<0 0 0> rotation=<0 0 0 1> scale=<1 1 1> from=0:0:0:"/nodes/3"
shape 0 mesh name="m" from=0:0:0:"/meshes/0"
  positions values=[<0 0 0> <1 0 0> <0 1 0>]
  triangles vertices=[<0 1 2>]
signal 0 constant value=<1 0 0 1> from=0:0:0:"/materials/0/pbrMetallicRoughness"
material 0 name="red" from=0:0:0:"/materials/0"
  gltf base_color=0
light 0 point name="l" intensity=<5 5 5> from=0:0:0:"/extensions/KHR_lights_punctual/lights/0"
camera 0 projection=orthographic name="eye" right=<4 0 0> up=<0 2 0> fit=show_all from=0:0:0:"/cameras/0"
)");
}

}  // namespace
}  // namespace alidade::gltf_test
