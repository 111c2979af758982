// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tests/scene/sample_scene.h"

#include <gtest/gtest.h>

#include <set>

namespace alidade {
namespace {

TEST(Dump, GoldenText) {
    EXPECT_EQ(dump(test::sample_scene()),
              R"(file 0 path="sample.gltf"
settings
atmosphere
  fog
  sky pigments=[4]
  medium
roots nodes=[0]
node 0 name="root" to_parent=<1 0 0><0 1 0><0 0 1><0 0 1> children=[1 3 4 5 8]
node 1 shape=3 trs translation=<0 0 0> rotation=<0 0 0 1> scale=<1 1 1> materials=[0 none] children=[2] skin=0 morph_weights=[0.25] from=0:0:0:"/nodes/1"
node 2
node 3 shape=0 inside_materials=[1] interior=0 csg=difference clips=[6]
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
signal 5 function program=0
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

Mesh& mesh(Scene& s) { return std::get<Mesh>(s.shapes[3].geometry); }
GltfPbr& gltf(Scene& s) { return std::get<GltfPbr>(s.materials[0].layers[0]); }
PovFinish& pov(Scene& s) { return std::get<PovFinish>(s.materials[1].layers[0]); }
ImageSignal& image(Scene& s) { return std::get<ImageSignal>(s.signals[1].what); }
PatternSignal& pattern(Scene& s) { return std::get<PatternSignal>(s.signals[4].what); }
AreaLight& area(Scene& s) {
    if (!std::holds_alternative<AreaLight>(s.lights[0].kind)) s.lights[0].kind = AreaLight();
    return std::get<AreaLight>(s.lights[0].kind);
}
ShadowGrid& grid(Scene& s) {
    if (!s.lights[0].shadow_grid) s.lights[0].shadow_grid.emplace();
    return *s.lights[0].shadow_grid;
}
ReliefSignal& relief(Scene& s) { return std::get<ReliefSignal>(s.signals[6].what); }
Fog& fog(Scene& s) { return s.atmosphere.fogs[0]; }
Interior::Medium& medium(Scene& s) { return s.interiors[0].media[0]; }
Channel& channel(Scene& s) { return s.animations[0].channels[0]; }

using Change = void (*)(Scene&);

/// Each sets one field of the sample scene to another value.
const Change kNodeChanges[] = {
    [](Scene& s) { s.roots.push_back(NodeId{1}); },
    [](Scene& s) { s.nodes[0].name = "other"; },
    [](Scene& s) { s.nodes[0].to_parent.linear[1][2] = 1e-17; },
    [](Scene& s) { s.nodes[0].to_parent.translation.z = 2; },
    [](Scene& s) { s.nodes[0].trs = Trs(); },
    [](Scene& s) { s.nodes[1].trs->translation.x = 1; },
    [](Scene& s) { s.nodes[1].trs->rotation.x = 1; },
    [](Scene& s) { s.nodes[1].trs->scale.x = 2; },
    [](Scene& s) { s.nodes[0].what = ShapeId{0}; },
    [](Scene& s) { s.nodes[1].what = ShapeId{0}; },
    [](Scene& s) { s.nodes[1].what = LightId{0}; },
    [](Scene& s) { s.nodes[1].what = CameraId{0}; },
    [](Scene& s) { s.nodes[1].materials.pop_back(); },
    [](Scene& s) { s.nodes[1].materials[1] = MaterialId{0}; },
    [](Scene& s) { s.nodes[1].inside_materials = {MaterialId{0}}; },
    [](Scene& s) { s.nodes[1].interior = InteriorId{0}; },
    [](Scene& s) { s.nodes[3].csg = CsgKind::merge; },
    [](Scene& s) { s.nodes[3].inverse = true; },
    [](Scene& s) { s.nodes[3].children = {NodeId{4}}; },
    [](Scene& s) { s.nodes[3].clips.clear(); },
    [](Scene& s) { s.nodes[3].bounds = {NodeId{6}}; },
    [](Scene& s) { s.nodes[3].flags.visible = false; },
    [](Scene& s) { s.nodes[3].flags.shadow = false; },
    [](Scene& s) { s.nodes[3].flags.image = false; },
    [](Scene& s) { s.nodes[3].flags.reflection = false; },
    [](Scene& s) { s.nodes[3].flags.hollow = true; },
    [](Scene& s) { s.nodes[3].flags.double_illuminate = true; },
    [](Scene& s) { s.nodes[3].light_group = {LightId{0}}; },
    [](Scene& s) { s.nodes[3].global_lights = false; },
    [](Scene& s) { s.nodes[3].skin = SkinId{0}; },
    [](Scene& s) { s.nodes[3].morph_weights = {0}; },
    [](Scene& s) { s.nodes[1].from.file = kNoFile; },
    [](Scene& s) { s.nodes[1].from.line = 1; },
    [](Scene& s) { s.nodes[1].from.column = 1; },
    [](Scene& s) { s.nodes[1].from.pointer = "/nodes/2"; },
};

const Change kShapeChanges[] = {
    [](Scene& s) { s.shapes[0].name = ""; },
    [](Scene& s) { s.shapes[0].from.line = 4; },
    [](Scene& s) { s.shapes[1].from.line = 4; },
    [](Scene& s) { s.shapes[2].from.line = 4; },
    [](Scene& s) { s.shapes[3].from.line = 4; },
    [](Scene& s) { s.shapes[0].geometry = Box(); },
    [](Scene& s) { s.shapes[0].geometry = Disc(); },
    [](Scene& s) { s.shapes[0].geometry = Disc{Vec3(1), Vec3(0, 1, 0), 1, 0}; },
    [](Scene& s) { s.shapes[0].geometry = Disc{Vec3(0), Vec3(1), 1, 0}; },
    [](Scene& s) { s.shapes[0].geometry = Disc{Vec3(0), Vec3(0, 1, 0), 2, 0}; },
    [](Scene& s) { s.shapes[0].geometry = Disc{Vec3(0), Vec3(0, 1, 0), 1, 0.5}; },
    [](Scene& s) { s.shapes[0].geometry = Cylinder(); },
    [](Scene& s) { s.shapes[0].geometry = Cylinder{Vec3(0), Vec3(1), 1, false}; },
    [](Scene& s) { s.shapes[0].geometry = Cylinder{Vec3(2), Vec3(1), 1, false}; },
    [](Scene& s) { s.shapes[0].geometry = Cylinder{Vec3(2), Vec3(1), 3, false}; },
    [](Scene& s) { s.shapes[0].geometry = Cylinder{Vec3(2), Vec3(1), 3, true}; },
    [](Scene& s) { s.shapes[0].geometry = Cone(); },
    [](Scene& s) { s.shapes[0].geometry = Cone{Vec3(2), Vec3(1), 1, 0, false}; },
    [](Scene& s) { s.shapes[0].geometry = Cone{Vec3(2), Vec3(1), 2, 0, false}; },
    [](Scene& s) { s.shapes[0].geometry = Cone{Vec3(2), Vec3(1), 2, 1, false}; },
    [](Scene& s) { s.shapes[0].geometry = Cone{Vec3(2), Vec3(1), 2, 1, true}; },
    [](Scene& s) { s.shapes[0].geometry = Torus(); }, [](Scene& s) { s.shapes[0].geometry = Torus{Vec3(1), 1, 0.25}; },
    [](Scene& s) { s.shapes[0].geometry = Torus{Vec3(0), 2, 0.25}; }, [](Scene& s) { s.shapes[0].geometry = Torus{Vec3(0), 1, 0.5}; },
    [](Scene& s) { s.shapes[0].geometry = Quadric(); }, [](Scene& s) { s.shapes[0].geometry = Quadric{Vec3(2), Vec3(0), Vec3(0), -1}; },
    [](Scene& s) { s.shapes[0].geometry = Quadric{Vec3(1), Vec3(1), Vec3(0), -1}; }, [](Scene& s) { s.shapes[0].geometry = Quadric{Vec3(1), Vec3(0), Vec3(1), -1}; },
    [](Scene& s) { s.shapes[0].geometry = Quadric{Vec3(1), Vec3(0), Vec3(0), 0}; }, [](Scene& s) { s.shapes[0].geometry = Polynomial(); },
    [](Scene& s) { s.shapes[0].geometry = Polynomial{3, Polynomial().coefficients}; }, [](Scene& s) { s.shapes[0].geometry = Polynomial{2, {1, 2}}; },
    [](Scene& s) { s.shapes[0].geometry = Polygon(); }, [](Scene& s) { s.shapes[0].geometry = Polygon{{{Vec3(0)}, {Vec3(1)}}}; },
    [](Scene& s) { s.shapes[0].geometry = Polygon{{{Vec3(0), Vec3(1)}}}; }, [](Scene& s) { s.shapes[0].geometry = Extrusion(); },
    [](Scene& s) { s.shapes[0].geometry = Extrusion{Extrusion().outlines, -1, 1, false}; }, [](Scene& s) { s.shapes[0].geometry = Extrusion{Extrusion().outlines, 0, 2, false}; },
    [](Scene& s) { s.shapes[0].geometry = Extrusion{Extrusion().outlines, 0, 1, true}; }, [](Scene& s) { s.shapes[0].geometry = Extrusion{{{{Vec2(0), Vec2(1)}}}, 0, 1, false}; },
    [](Scene& s) { std::get<Sphere>(s.shapes[0].geometry).center.x = 1; },
    [](Scene& s) { std::get<Sphere>(s.shapes[0].geometry).radius = -1; },
    [](Scene& s) { std::get<Plane>(s.shapes[1].geometry).normal.x = 1; },
    [](Scene& s) { std::get<Plane>(s.shapes[1].geometry).distance = 1; },
    [](Scene& s) { std::get<Box>(s.shapes[2].geometry).a.x = 0; },
    [](Scene& s) { std::get<Box>(s.shapes[2].geometry).b.x = 0; },
    [](Scene& s) { mesh(s).origin.x = 1; },
    [](Scene& s) { mesh(s).positions[3].z = 1e-30f; },
    [](Scene& s) { mesh(s).exact_positions.clear(); },
    [](Scene& s) { mesh(s).triangles[1].z = 1; },
    [](Scene& s) { mesh(s).slots[1] = 2; },
    [](Scene& s) { mesh(s).faces[1] = 1; },
    [](Scene& s) { mesh(s).normals.values[0].x = 1; },
    [](Scene& s) { mesh(s).normals.corners.clear(); },
    [](Scene& s) { mesh(s).uvs.push_back(mesh(s).uvs[0]); },
    [](Scene& s) { mesh(s).uvs[0].values[0].x = 1; },
    [](Scene& s) { mesh(s).tangents.values[0].w = -1; },
    [](Scene& s) { mesh(s).colors[0].values[0].w = 0; },
    [](Scene& s) { mesh(s).morphs.resize(2); },
    [](Scene& s) { mesh(s).morphs[0].positions[0].x = 1; },
    [](Scene& s) { mesh(s).morphs[0].normals.resize(4); },
    [](Scene& s) { mesh(s).morphs[0].tangents.resize(4); },
    [](Scene& s) { mesh(s).morph_weights[0] = 0; },
    [](Scene& s) { mesh(s).joint_sets[0].joints[0].x = 1; },
    [](Scene& s) { mesh(s).joint_sets[0].weights[0].x = 0; },
};

const Change kSurfaceChanges[] = {
    [](Scene& s) { s.images[0].name = "x"; },
    [](Scene& s) { s.images[0].path = "x"; },
    [](Scene& s) { s.images[0].from.line = 4; },
    [](Scene& s) { s.images[1].bytes[1] = std::byte(3); },
    [](Scene& s) { s.images[1].bytes.push_back(std::byte(0)); },
    [](Scene& s) { s.signals[0].what = ConstantSignal{Vec4(0)}; },
    [](Scene& s) { for (Signal& signal : s.signals) signal.from.line = 4; },
    [](Scene& s) { image(s).image = ImageId{1}; },
    [](Scene& s) { image(s).uv_set = 1; },
    [](Scene& s) { image(s).wrap_u = Wrap::once; },
    [](Scene& s) { image(s).wrap_v = Wrap::mirror; },
    [](Scene& s) { image(s).filter = Filter::nearest; },
    [](Scene& s) { image(s).srgb = true; },
    [](Scene& s) { image(s).uv_transform[2][0] = 0.5; },
    [](Scene& s) { s.signals[2].what = ProductSignal{SignalId{1}, SignalId{1}}; },
    [](Scene& s) { s.signals[2].what = ProductSignal{SignalId{0}, SignalId{0}}; },
    [](Scene& s) { s.signals[3].what = ChannelSignal{SignalId{0}, 2}; },
    [](Scene& s) { s.signals[3].what = ChannelSignal{SignalId{1}, 1}; },
    [](Scene& s) { s.signals[5].what = FunctionSignal{1}; },
    [](Scene& s) { pattern(s).pattern = "wood"; },
    [](Scene& s) { pattern(s).parameters = {1}; },
    [](Scene& s) { std::get<ConstantSignal>(s.signals[0].what).filter = 0.5; },
    [](Scene& s) { std::get<ConstantSignal>(s.signals[0].what).transmit = 0.5; },
    [](Scene& s) { pattern(s).turbulence.amount.y = 1; },
    [](Scene& s) { pattern(s).turbulence.octaves = 2; },
    [](Scene& s) { pattern(s).turbulence.omega = 0.7; },
    [](Scene& s) { pattern(s).turbulence.lambda = 3; },
    [](Scene& s) { pattern(s).noise = NoiseGenerator::perlin; },
    [](Scene& s) { pattern(s).wave = Wave::ramp; },
    [](Scene& s) { pattern(s).wave_exponent = 2; },
    [](Scene& s) { pattern(s).frequency = 1; },
    [](Scene& s) { pattern(s).phase = 0.5; },
    [](Scene& s) { pattern(s).map[1].value = 0.5; },
    [](Scene& s) { pattern(s).map[1].signal = SignalId{1}; },
    [](Scene& s) { relief(s).pattern.phase = 0.5; },
    [](Scene& s) { relief(s).amount = 1; },
    [](Scene& s) { relief(s).accuracy = 1; },
    [](Scene& s) { relief(s).scaled = false; },
    [](Scene& s) { relief(s).slopes = {{0, 0, 0}}; },
    [](Scene& s) { relief(s).slopes = {{1, 0, 0}}; },
    [](Scene& s) { relief(s).slopes = {{0, 1, 0}}; },
    [](Scene& s) { relief(s).slopes = {{0, 0, 1}}; },
    [](Scene& s) { std::get<PovTextureMap>(s.materials[2].layers[0]).pattern = SignalId{0}; },
    [](Scene& s) { std::get<PovTextureMap>(s.materials[2].layers[0]).textures.pop_back(); },
    [](Scene& s) { pattern(s).warps[0].kind = WarpKind::black_hole; },
    [](Scene& s) { pattern(s).warps[0].transform.translation.x = 1; },
    [](Scene& s) { pattern(s).warps[0].parameters = {1}; },
    [](Scene& s) { s.functions[0].parameters = {"x"}; },
    [](Scene& s) { s.functions[0].constants = {1}; },
    [](Scene& s) { s.functions[0].code = {1}; },
    [](Scene& s) { s.materials[0].name = "x"; },
    [](Scene& s) { s.materials[0].uv_mapped = true; },
    [](Scene& s) { s.materials[0].from.line = 4; },
    [](Scene& s) { s.materials[1].layers.pop_back(); },
    [](Scene& s) { gltf(s).base_color = SignalId{1}; },
    [](Scene& s) { gltf(s).metallic = SignalId{0}; },
    [](Scene& s) { gltf(s).roughness.reset(); },
    [](Scene& s) { gltf(s).normal = SignalId{0}; },
    [](Scene& s) { gltf(s).normal_scale = 2; },
    [](Scene& s) { gltf(s).occlusion = SignalId{0}; },
    [](Scene& s) { gltf(s).emissive = SignalId{0}; },
    [](Scene& s) { gltf(s).emissive_strength = 2; },
    [](Scene& s) { gltf(s).alpha_mode = AlphaMode::mask; },
    [](Scene& s) { gltf(s).alpha_cutoff = 0.25; },
    [](Scene& s) { gltf(s).double_sided = true; },
    [](Scene& s) { gltf(s).unlit = true; },
    [](Scene& s) { gltf(s).ior = 1.3; },
    [](Scene& s) { gltf(s).transmission = SignalId{0}; },
    [](Scene& s) { gltf(s).specular = SignalId{0}; },
    [](Scene& s) { gltf(s).specular_color = SignalId{0}; },
    [](Scene& s) { gltf(s).clearcoat = SignalId{0}; },
    [](Scene& s) { gltf(s).clearcoat_roughness = SignalId{0}; },
    [](Scene& s) { gltf(s).clearcoat_normal = SignalId{0}; },
    [](Scene& s) { pov(s).pigment = SignalId{0}; },
    [](Scene& s) { pov(s).normal.reset(); },
    [](Scene& s) { pov(s).ambient = Color(0); },
    [](Scene& s) { pov(s).emission = Color(1); },
    [](Scene& s) { pov(s).diffuse = 1; },
    [](Scene& s) { pov(s).brilliance = 2; },
    [](Scene& s) { pov(s).diffuse_back = 1; },
    [](Scene& s) { pov(s).phong = 1; },
    [](Scene& s) { pov(s).phong_size = 1; },
    [](Scene& s) { pov(s).specular = 1; },
    [](Scene& s) { pov(s).roughness = 1; },
    [](Scene& s) { pov(s).metallic = 1; },
    [](Scene& s) { pov(s).crand = 1; },
    [](Scene& s) { pov(s).reflection_min = Color(1); },
    [](Scene& s) { pov(s).reflection_max = Color(1); },
    [](Scene& s) { pov(s).reflection_falloff = 2; },
    [](Scene& s) { pov(s).reflection_exponent = 2; },
    [](Scene& s) { pov(s).reflection_metallic = 1; },
    [](Scene& s) { pov(s).reflection_fresnel = true; },
    [](Scene& s) { pov(s).conserve_energy = true; },
    [](Scene& s) { s.interiors[0].ior = 1.5; },
    [](Scene& s) { s.interiors[0].dispersion = 2; },
    [](Scene& s) { s.interiors[0].dispersion_samples = 8; },
    [](Scene& s) { s.interiors[0].caustics = 1; },
    [](Scene& s) { s.interiors[0].fade_distance = 1; },
    [](Scene& s) { s.interiors[0].fade_power = 1; },
    [](Scene& s) { s.interiors[0].fade_color = Color(1); },
    [](Scene& s) { s.interiors[0].attenuation_color = Color(0); },
    [](Scene& s) { s.interiors[0].attenuation_distance = 1; },
    [](Scene& s) { s.interiors[0].from.line = 4; },
    [](Scene& s) { s.interiors[0].media.clear(); },
    [](Scene& s) { medium(s).absorption = Color(1); },
    [](Scene& s) { medium(s).emission = Color(1); },
    [](Scene& s) { medium(s).scattering = Color(1); },
    [](Scene& s) { medium(s).scattering_type = 2; },
    [](Scene& s) { medium(s).eccentricity = 1; },
    [](Scene& s) { medium(s).extinction = 2; },
    [](Scene& s) { medium(s).density.clear(); },
};

const Change kOtherChanges[] = {
    [](Scene& s) { s.files[0].path = "x"; },
    [](Scene& s) { s.lights[0].name = "x"; },
    [](Scene& s) { s.lights[0].kind = SpotLight(); },
    [](Scene& s) { s.lights[0].kind = SpotLight{0.1, kPi / 4}; },
    [](Scene& s) { s.lights[0].kind = SpotLight{0, 1}; },
    [](Scene& s) { s.lights[0].kind = DirectionalLight(); },
    [](Scene& s) { area(s); },
    [](Scene& s) { area(s).form = AreaLight::Form::disc; },
    [](Scene& s) { area(s).width = 2; },
    [](Scene& s) { area(s).height = 2; },
    [](Scene& s) { area(s).radius = 2; },
    [](Scene& s) { s.lights[0].kind = CylinderLight{1, 2, 0}; },
    [](Scene& s) { s.lights[0].kind = CylinderLight{1, 3, 0}; },
    [](Scene& s) { s.lights[0].kind = CylinderLight{2, 3, 0}; },
    [](Scene& s) { s.lights[0].kind = CylinderLight{2, 3, 1}; },
    [](Scene& s) { grid(s); },
    [](Scene& s) { grid(s).axis1.y = 1; },
    [](Scene& s) { grid(s).axis2.x = 1; },
    [](Scene& s) { grid(s).size1 = 2; },
    [](Scene& s) { grid(s).size2 = 2; },
    [](Scene& s) { grid(s).adaptive = 1; },
    [](Scene& s) { grid(s).jitter = true; },
    [](Scene& s) { grid(s).circular = true; },
    [](Scene& s) { grid(s).orient = true; },
    [](Scene& s) { grid(s).illuminates = true; },
    [](Scene& s) { s.lights[0].intensity = Color(2); },
    [](Scene& s) { s.lights[0].range = 2; },
    [](Scene& s) { s.lights[0].fade = LightFade(); },
    [](Scene& s) { s.lights[0].fade = LightFade{1, 0}; },
    [](Scene& s) { s.lights[0].fade = LightFade{0, 1}; },
    [](Scene& s) { s.lights[0].inverse_square = false; },
    [](Scene& s) { s.lights[0].shadowless = true; },
    [](Scene& s) { s.lights[0].media_interaction = false; },
    [](Scene& s) { s.lights[0].looks_like.reset(); },
    [](Scene& s) { s.lights[0].projected_through = NodeId{7}; },
    [](Scene& s) { s.lights[0].from.line = 4; },
    [](Scene& s) { s.cameras[0].name = "x"; },
    [](Scene& s) { s.cameras[0].projection = Projection::omnimax; },
    [](Scene& s) { s.cameras[0].location.x = 1; },
    [](Scene& s) { s.cameras[0].direction.x = 1; },
    [](Scene& s) { s.cameras[0].right.y = 1; },
    [](Scene& s) { s.cameras[0].up.x = 1; },
    [](Scene& s) { s.cameras[0].fit = Fit::height; },
    [](Scene& s) { s.cameras[0].angle = 1; },
    [](Scene& s) { s.cameras[0].vertical_angle = 1; },
    [](Scene& s) { s.cameras[0].cylinder = 2; },
    [](Scene& s) { s.cameras[0].aperture = 1; },
    [](Scene& s) { s.cameras[0].focal_point.x = 1; },
    [](Scene& s) { s.cameras[0].blur_samples = 1; },
    [](Scene& s) { s.cameras[0].from.line = 4; },
    [](Scene& s) { s.skins[0].name = "x"; },
    [](Scene& s) { s.skins[0].joints.push_back(NodeId{1}); },
    [](Scene& s) { s.skins[0].inverse_bind[0].translation.x = 1; },
    [](Scene& s) { s.animations[0].name = "x"; },
    [](Scene& s) { channel(s).target = NodeId{2}; },
    [](Scene& s) { channel(s).path = ChannelPath::scale; },
    [](Scene& s) { channel(s).interpolation = Interpolation::step; },
    [](Scene& s) { channel(s).times[1] = 2; },
    [](Scene& s) { channel(s).values[1] = 2; },
    [](Scene& s) { channel(s).width = 4; },
    [](Scene& s) { s.atmosphere.background.x = 1; },
    [](Scene& s) { s.atmosphere.environment = Color(0); },
    [](Scene& s) { s.atmosphere.environment_image = ImageId{0}; },
    [](Scene& s) { s.atmosphere.environment_strength = 2; },
    [](Scene& s) { fog(s).ground = true; },
    [](Scene& s) { fog(s).distance = 1; },
    [](Scene& s) { fog(s).offset = 1; },
    [](Scene& s) { fog(s).altitude = 1; },
    [](Scene& s) { fog(s).turbulence.amount.y = 1; },
    [](Scene& s) { fog(s).turbulence.octaves = 2; },
    [](Scene& s) { fog(s).turbulence.omega = 0.7; },
    [](Scene& s) { fog(s).turbulence.lambda = 3; },
    [](Scene& s) { fog(s).turbulence_depth = 1; },
    [](Scene& s) { fog(s).noise = NoiseGenerator::perlin; },
    [](Scene& s) { fog(s).color.x = 1; },
    [](Scene& s) { fog(s).filter = 1; },
    [](Scene& s) { fog(s).transmit = 1; },
    [](Scene& s) { fog(s).up.x = 1; },
    [](Scene& s) { s.atmosphere.sky.reset(); },
    [](Scene& s) { s.atmosphere.sky->pigments.clear(); },
    [](Scene& s) { s.atmosphere.sky->emission.x = 0.5; },
    [](Scene& s) { s.atmosphere.sky->transform.translation.x = 1; },
    [](Scene& s) { s.atmosphere.media[0].emission = Color(1); },
    [](Scene& s) { s.settings.max_depth = 0; },
    [](Scene& s) { s.settings.adc_bailout = 0; },
    [](Scene& s) { s.settings.ambient_light = Color(0); },
    [](Scene& s) { s.settings.assumed_gamma = 2.2; },
    [](Scene& s) { s.settings.srgb_coded = true; },
    [](Scene& s) { s.settings.filter_dims_by_colour = true; },
    [](Scene& s) { s.settings.default_light = false; },
    [](Scene& s) { s.lights[0].parallel = true; },
    [](Scene& s) { s.lights[0].kind = ConeLight{0.1, 0.2, 0}; },
    [](Scene& s) { s.settings.light_units = LightUnits::photometric; },
    [](Scene& s) { s.settings.why_light_units = "x"; },
    [](Scene& s) { s.settings.default_spp = 1; },
    [](Scene& s) { s.settings.generator = "x"; },
};

template <size_t N> void expect_each_to_show(const Change (&changes)[N]) {
    std::set<std::string> texts = {dump(test::sample_scene())};
    for (size_t i = 0; i < N; ++i) {
        Scene scene = test::sample_scene();
        changes[i](scene);
        EXPECT_TRUE(texts.insert(dump(scene)).second) << "change " << i << " leaves no trace of its own";
    }
}

TEST(Dump, EveryFieldShows) {
    expect_each_to_show(kNodeChanges);
    expect_each_to_show(kShapeChanges);
    expect_each_to_show(kSurfaceChanges);
    expect_each_to_show(kOtherChanges);
}

TEST(Dump, EqualScenesGiveEqualText) { EXPECT_EQ(dump(test::sample_scene()), dump(test::sample_scene())); }

}  // namespace
}  // namespace alidade
