// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tests/scene/sample_scene.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Dump, GoldenText) {
    EXPECT_EQ(dump(test::sample_scene()),
              R"(file 0 path="sample.gltf"
settings
atmosphere
  fog
  rainbow
  sky pigments=[4]
  medium
roots nodes=[0]
node 0 name="root" to_parent=<1 0 0><0 1 0><0 0 1><0 0 1> children=[1 3 4 5 8]
node 1 shape=3 trs translation=<0 0 0> rotation=<0 0 0 1> scale=<1 1 1> materials=[0 none] children=[2] skin=0 morph_weights=[0.25] from=0:0:0:"/nodes/1"
node 2
node 3 shape=0 inside_material=1 interior=0 csg=difference clips=[6]
node 4 shape=1
node 5 light=0
node 6 shape=2
node 7 shape=2
node 8 camera=0
shape 0 sphere name="ball" center=<0 0 0> radius=1
shape 1 plane name="floor" normal=<0 1 0> distance=0
shape 2 box a=<-1 -1 -1> b=<1 1 1>
shape 3 mesh name="quad" from=0:0:0:"/meshes/0"
  positions values=[<0 0 0> <1 0 0> <1 1 0> <0 1 0>] exact=[<0 0 0> <1 0 0> <1 1 0> <0 1 0>]
  triangles vertices=[<0 1 2> <0 2 3>] slots=[0 1] faces=[0 0]
  normals values=[<0 0 1>] corners=[0 0 0 0 0 0]
  uv 0 values=[<0 0> <1 0> <1 1> <0 1>]
  tangents values=[<1 0 0 1> <1 0 0 1> <1 0 0 1> <1 0 0 1>]
  colors 0 values=[<1 0.5 0.25 1> <1 0.5 0.25 1> <1 0.5 0.25 1> <1 0.5 0.25 1>]
  morph 0 positions=[<0 0 0.1> <0 0 0.1> <0 0 0.1> <0 0 0.1>]
  morph weights values=[0.5]
  joints 0 joints=[<0 0 0 0> <0 0 0 0> <0 0 0 0> <0 0 0 0>] weights=[<1 0 0 0> <1 0 0 0> <1 0 0 0> <1 0 0 0>]
image 0 name="wood" path="wood.png"
image 1 name="embedded" bytes=2 fnv1a=082f2407b4e8902a
signal 0 constant value=<0.8 0.7 0.6 1>
signal 1 image image=0
signal 2 product a=0 b=1
signal 3 channel of=1 channel=2
signal 4 pattern pattern="agate"
  map value=0 signal=0
  map value=1 signal=5
  warp kind=transform
signal 5 pattern pattern="function" function=0
signal 6 relief
  pattern pattern="bumps"
material 0
  gltf base_color=2 roughness=3
material 1
  pov pigment=4 normal=6
  pov pigment=4 normal=6
material 2
  map pattern=4 textures=[1 1]
interior 0
  medium density=[4]
light 0 point looks_like=7
camera 0 projection=perspective
skin 0 joints=[2] inverse_bind=[<1 0 0><0 1 0><0 0 1><0 0 0>]
animation 0
  channel node=1 path=translation interpolation=linear times=[0 1] values=[0 0 0 1 2 3]
  channel node=1 path=weights interpolation=cubic width=1 times=[0 1] values=[0 0 0 0 1 0]
function 0
  number value=2.5
  number value=2.5
  argument
  transform b=1
  transform to=<1 0 0><0 1 0><0 0 1><0 0 0>
  spline linear
    knot at=0 value=[1 2 3 4 5]
)");
}

TEST(Dump, NumbersReadBack) {
    Scene s;
    s.shapes = {{"", Sphere{Vec3(0.1, 1.0 / 3, -0.0), 1e-300}, {}}};
    EXPECT_NE(dump(s).find("shape 0 sphere center=<0.1 0.3333333333333333 -0> radius=1e-300\n"), std::string::npos) << dump(s);
}

TEST(Dump, TextIsQuoted) {
    Scene s;
    s.files = {{"a \"b\"\\c\n\x01.obj"}};
    EXPECT_EQ(dump(s).substr(0, dump(s).find('\n')), R"(file 0 path="a \"b\"\\c\x0a\x01.obj")");
}

TEST(Dump, MeshesListsMayStandAsFingerprints) {
    Scene s = test::sample_scene();
    const std::string brief = dump(s, MeshLists::fingerprints);
    EXPECT_NE(brief.find("  positions values=4:"), std::string::npos) << brief;
    EXPECT_EQ(brief.find("<1 1 0>"), std::string::npos) << brief;
    EXPECT_EQ(brief, dump(test::sample_scene(), MeshLists::fingerprints));
    for (ShapeEntry& entry : s.shapes)
        if (auto* mesh = std::get_if<Mesh>(&entry.geometry)) mesh->positions[2].x = 1.5f;
    EXPECT_NE(brief, dump(s, MeshLists::fingerprints));
}

TEST(Dump, EqualScenesGiveEqualText) { EXPECT_EQ(dump(test::sample_scene()), dump(test::sample_scene())); }

}  // namespace
}  // namespace alidade
