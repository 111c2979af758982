// SPDX-License-Identifier: Apache-2.0
#include "tests/scene/sample_scene.h"

namespace alidade::test {

namespace {

Mesh sample_mesh() {
    Mesh mesh;
    mesh.positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)};
    mesh.exact_positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    mesh.triangles = {Index3(0, 1, 2), Index3(0, 2, 3)};
    mesh.slots = {0, 1};
    mesh.faces = {0, 0};
    mesh.normals.values = {Vec3f(0, 0, 1)};
    mesh.normals.corners = {0, 0, 0, 0, 0, 0};
    mesh.uvs.resize(1);
    mesh.uvs[0].values = {Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1), Vec2f(0, 1)};
    mesh.tangents.values.assign(4, Vec4f(1, 0, 0, 1));
    mesh.colors.resize(1);
    mesh.colors[0].values.assign(4, Vec4f(1, 0.5f, 0.25f, 1));
    mesh.morphs.resize(1);
    mesh.morphs[0].positions.assign(4, Vec3f(0, 0, 0.1f));
    mesh.morph_weights = {0.5};
    mesh.joint_sets.resize(1);
    mesh.joint_sets[0].joints.assign(4, Joints4(0, 0, 0, 0));
    mesh.joint_sets[0].weights.assign(4, Vec4f(1, 0, 0, 0));
    return mesh;
}

void add_nodes(Scene& s) {
    s.nodes.resize(9);
    s.nodes[0].name = "root";
    s.nodes[0].children = {NodeId{1}, NodeId{3}, NodeId{4}, NodeId{5}, NodeId{8}};
    s.nodes[0].to_parent = Transform::translate({0, 0, 1});
    s.nodes[1].what = ShapeId{3};
    s.nodes[1].trs = Trs();
    s.nodes[1].children = {NodeId{2}};
    s.nodes[1].materials = {MaterialId{0}, std::nullopt};
    s.nodes[1].skin = SkinId{0};
    s.nodes[1].morph_weights = {0.25};
    s.nodes[1].from = {0, 0, 0, "/nodes/1"};
    s.nodes[3].what = ShapeId{0};
    s.nodes[3].csg = CsgKind::difference;
    s.nodes[3].inside_material = MaterialId{1};
    s.nodes[3].interior = InteriorId{0};
    s.nodes[3].clips = {NodeId{6}};
    s.nodes[4].what = ShapeId{1};
    s.nodes[5].what = LightId{0};
    s.nodes[6].what = ShapeId{2};
    s.nodes[7].what = ShapeId{2};
    s.nodes[8].what = CameraId{0};
    s.roots = {NodeId{0}};
}

void add_surfaces(Scene& s) {
    s.images = {{"wood", "wood.png", {}, {}}, {"embedded", "", {std::byte(1), std::byte(2)}, {}}};
    PatternSignal pattern;
    pattern.pattern = "agate";
    pattern.map = {{0, SignalId{0}}, {1, SignalId{5}}};
    pattern.warps.resize(1);
    s.signals.resize(7);
    s.signals[0].what = ConstantSignal{Vec4(0.8, 0.7, 0.6, 1)};
    s.signals[1].what = ImageSignal();
    s.signals[2].what = ProductSignal{SignalId{0}, SignalId{1}};
    s.signals[3].what = ChannelSignal{SignalId{1}, 2};
    s.signals[4].what = pattern;
    PatternSignal formula;
    formula.pattern = kFunctionPattern, formula.function = FunctionId{0};
    s.signals[5].what = formula;
    ReliefSignal relief;
    relief.pattern.pattern = "bumps";
    s.signals[6].what = relief;
    s.functions.resize(1);
    s.functions[0].steps = {{FunctionOp::argument, 0}, {FunctionOp::transform, 0, 1}};
    s.functions[0].steps.insert(s.functions[0].steps.begin(), 2, {FunctionOp::number, 0, 0, 2.5});
    s.functions[0].transforms.resize(1);
    s.functions[0].splines = {{SplineCurve::Type::linear, {{0, {1, 2, 3, 4, 5}}}}};
    GltfPbr gltf;
    gltf.base_color = SignalId{2};
    gltf.roughness = SignalId{3};
    PovFinish pov;
    pov.pigment = SignalId{4};
    pov.normal = SignalId{6};
    s.materials.resize(3);
    s.materials[0].layers = {gltf};
    s.materials[1].layers = {pov, pov};
    s.materials[2].layers = {PovTextureMap{SignalId{4}, {MaterialId{1}, MaterialId{1}}}};
    s.interiors.resize(1);
    s.interiors[0].media.resize(1);
    s.interiors[0].media[0].density = {SignalId{4}};
}

void add_motion(Scene& s) {
    s.skins.resize(1);
    s.skins[0].joints = {NodeId{2}};
    s.skins[0].inverse_bind.resize(1);
    Channel move;
    move.target = NodeId{1};
    move.times = {0, 1};
    move.values = {0, 0, 0, 1, 2, 3};
    Channel weights = move;
    weights.path = ChannelPath::weights;
    weights.interpolation = Interpolation::cubic;
    weights.width = 1;
    weights.values = {0, 0, 0, 0, 1, 0};
    s.animations.resize(1);
    s.animations[0].channels = {move, weights};
}

}  // namespace

Scene sample_scene() {
    Scene s;
    s.files = {{"sample.gltf"}};
    add_nodes(s);
    s.shapes = {{"ball", Sphere(), {}}, {"floor", Plane(), {}}, {"", Box(), {}}, {"quad", sample_mesh(), {0, 0, 0, "/meshes/0"}}};
    add_surfaces(s);
    s.lights.resize(1);
    s.lights[0].looks_like = NodeId{7};
    s.cameras.resize(1);
    add_motion(s);
    s.atmosphere.fogs.resize(1);
    s.atmosphere.rainbows.resize(1);
    s.atmosphere.sky = SkySphere{{SignalId{4}}, Color(1), Transform()};
    s.atmosphere.media.resize(1);
    return s;
}

Scene scene_of(std::vector<Node> nodes) {
    Scene s;
    s.nodes = std::move(nodes);
    s.roots = {NodeId{0}};
    s.shapes = {{"", Sphere(), {}}};
    return s;
}

}  // namespace alidade::test
