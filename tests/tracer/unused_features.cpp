// SPDX-License-Identifier: Apache-2.0
#include "tests/tracer/unused_features.h"

#include <functional>

namespace alidade::test {
namespace {

using Nodes = std::vector<NodeId>;

NodeId object(SceneBuilder& b, Nodes& nodes, ShapeGeometry geometry, std::optional<MaterialId> material = {}) {
    Node n;
    n.what = b.shape(std::move(geometry));
    if (material) n.materials = {*material};
    nodes.push_back(b.node(n, false));
    return nodes.back();
}

Node& node(SceneBuilder& b, NodeId id) { return b.scene.nodes[id.index]; }

SignalId signal(SceneBuilder& b, decltype(Signal::what) what) {
    b.scene.signals.push_back({std::move(what), {}});
    return {uint32_t(b.scene.signals.size() - 1)};
}

SignalId picture(SceneBuilder& b) {
    static constexpr const char kPicture[] = "P2\n2 2\n255\n40 230 230 40\n";
    const auto* bytes = reinterpret_cast<const std::byte*>(kPicture);
    b.scene.images.push_back({"checks", "", std::vector<std::byte>(bytes, bytes + sizeof kPicture - 1), {}});
    ImageSignal image;
    image.image = {uint32_t(b.scene.images.size() - 1)};
    return signal(b, image);
}

void surface(SceneBuilder& b, Nodes& nodes, const std::function<void(GltfPbr&)>& change) {
    GltfPbr m = b.lambert(Color(0.5));
    change(m);
    object(b, nodes, square(), b.material(m));
}

void alpha(SceneBuilder& b, Nodes& nodes, AlphaMode mode) {
    surface(b, nodes, [&](GltfPbr& m) { m.alpha_mode = mode, m.base_color = b.constant({1, 1, 1, 0.5}); });
}

void interior(SceneBuilder& b, Nodes& nodes, const Interior& in) {
    b.scene.interiors.push_back(in);
    node(b, object(b, nodes, Sphere{}, b.material(b.glass(1.5)))).interior = InteriorId{uint32_t(b.scene.interiors.size() - 1)};
}

void light(SceneBuilder& b, Nodes& nodes, decltype(Light::kind) kind) {
    nodes.push_back(b.light(kind, Color(50), Transform::translate({0, 1, 2})));
    b.scene.roots.pop_back();
}

void camera(SceneBuilder& b, Nodes& nodes, const std::function<void(Camera&)>& change) {
    b.camera({1, 2, 3}, {0, 0, 0});
    change(b.scene.cameras.back());
    nodes.push_back(b.scene.roots.back());
    b.scene.roots.pop_back();
}

PatternSignal bozo() {
    PatternSignal pattern;
    pattern.pattern = "bozo";
    return pattern;
}

void skin(SceneBuilder& b, Nodes& nodes) {
    Mesh m = square();
    m.joint_sets.resize(1);
    m.joint_sets[0].joints.assign(m.positions.size(), Joints4(0, 0, 0, 0));
    m.joint_sets[0].weights.assign(m.positions.size(), Vec4f(1, 0, 0, 0));
    Node joint;
    joint.to_parent = Transform::translate({0, 1, 0});
    nodes.push_back(b.node(joint, false));
    b.scene.skins.push_back({"skin", {nodes.back()}, {}});
    node(b, object(b, nodes, m)).skin = SkinId{uint32_t(b.scene.skins.size() - 1)};
}

void animation(SceneBuilder& b, Nodes& nodes) {
    Channel move;
    move.target = object(b, nodes, square());
    node(b, move.target).trs = Trs();
    move.times = {0, 1}, move.values = {0, 0, 0, 1, 2, 3};
    b.scene.animations.push_back({"move", {move}});
}

void set_operation(SceneBuilder& b, Nodes& nodes) {
    Node difference;
    difference.csg = CsgKind::difference;
    Nodes parts;
    object(b, parts, Sphere{}), object(b, parts, Box{});
    difference.children = parts;
    nodes.push_back(b.node(difference, false));
}

using R = Requirement;
const UnusedFeature kTable[] = {
    {R::textures, [](SceneBuilder& b, Nodes& nodes) { surface(b, nodes, [&](GltfPbr& m) { m.base_color = picture(b); }); }},
    {R::alpha_mask, [](SceneBuilder& b, Nodes& nodes) { alpha(b, nodes, AlphaMode::mask); }},
    {R::alpha_blend, [](SceneBuilder& b, Nodes& nodes) { alpha(b, nodes, AlphaMode::blend); }},
    {R::normal_maps, [](SceneBuilder& b, Nodes& nodes) { surface(b, nodes, [&](GltfPbr& m) { m.normal = picture(b); }); }},
    {R::vertex_colors, [](SceneBuilder& b, Nodes& nodes) {
         Mesh m = square();
         m.colors.resize(1);
         m.colors[0].values.assign(m.positions.size(), Vec4f(1, 0, 0, 1));
         object(b, nodes, m);
     }},
    {R::emission, [](SceneBuilder& b, Nodes& nodes) { surface(b, nodes, [&](GltfPbr& m) { m.emissive = b.constant(Vec4(5)); }); }},
    {R::mirror, [](SceneBuilder& b, Nodes& nodes) { surface(b, nodes, [&](GltfPbr& m) { m.roughness = b.constant(Vec4(0)); }); }},
    {R::transmission, [](SceneBuilder& b, Nodes& nodes) { object(b, nodes, Sphere{}, b.material(b.glass(1.5))); }},
    {R::absorption, [](SceneBuilder& b, Nodes& nodes) {
         Interior in;
         in.attenuation_distance = 0.5, in.attenuation_color = Color(0.1);
         interior(b, nodes, in);
     }},
    {R::media, [](SceneBuilder& b, Nodes& nodes) {
         Interior in;
         in.media.resize(1);
         interior(b, nodes, in);
     }},
    {R::fog, [](SceneBuilder& b, Nodes&) {
         Fog clear;
         clear.distance = 1, clear.transmit = 1, clear.color = Color(1);
         b.scene.atmosphere.fogs.push_back(clear);
     }, true},
    {R::point_lights, [](SceneBuilder& b, Nodes& nodes) { light(b, nodes, PointLight()); }},
    {R::spot_lights, [](SceneBuilder& b, Nodes& nodes) { light(b, nodes, SpotLight{0.2, 0.5}); }},
    {R::directional_lights, [](SceneBuilder& b, Nodes& nodes) { light(b, nodes, DirectionalLight()); }},
    {R::area_lights, [](SceneBuilder& b, Nodes& nodes) { light(b, nodes, AreaLight()); }},
    {R::environment, [](SceneBuilder& b, Nodes&) { b.scene.atmosphere.environment = Color(0); }, true},
    {R::csg, set_operation},
    {R::clipping, [](SceneBuilder& b, Nodes& nodes) {
         Nodes clip;
         object(b, clip, Box{});
         node(b, object(b, nodes, Sphere{})).clips = clip;
     }},
    {R::instances, [](SceneBuilder& b, Nodes& nodes) { nodes.push_back(b.node(node(b, object(b, nodes, square())), false)); }},
    {R::mirrored_instances, [](SceneBuilder& b, Nodes& nodes) { node(b, object(b, nodes, square())).to_parent = Transform::scale({-1, 1, 1}); }},
    {R::analytic_shapes, [](SceneBuilder& b, Nodes& nodes) { object(b, nodes, Sphere{}); }},
    {R::unbounded_shapes, [](SceneBuilder& b, Nodes& nodes) { object(b, nodes, Plane{{0, 1, 0}, 0}); }},
    {R::meshes, [](SceneBuilder& b, Nodes& nodes) { object(b, nodes, square()); }},
    {R::animation, animation},
    {R::skins, skin},
    {R::morphs, [](SceneBuilder& b, Nodes& nodes) {
         Mesh m = square();
         m.morphs.resize(1);
         m.morphs[0].positions.assign(m.positions.size(), Vec3f(0, 0, 0.5f));
         m.morph_weights = {1};
         object(b, nodes, m);
     }},
    {R::depth_of_field, [](SceneBuilder& b, Nodes& nodes) { camera(b, nodes, [](Camera& c) { c.aperture = 1; }); }},
    {R::orthographic, [](SceneBuilder& b, Nodes& nodes) { camera(b, nodes, [](Camera& c) { c.projection = Projection::orthographic; }); }},
    {R::patterns, [](SceneBuilder& b, Nodes& nodes) { surface(b, nodes, [&](GltfPbr& m) { m.base_color = signal(b, bozo()); }); }},
    {R::functions, [](SceneBuilder& b, Nodes& nodes) {
         b.scene.functions.resize(b.scene.functions.size() + 1);
         b.scene.functions.back().steps = {{FunctionOp::argument, 0}};
         PatternSignal formula;
         formula.pattern = kFunctionPattern, formula.function = FunctionId{uint32_t(b.scene.functions.size() - 1)};
         surface(b, nodes, [&](GltfPbr& m) { m.base_color = signal(b, formula); });
     }},
};

}  // namespace

std::span<const UnusedFeature> unused_features() { return kTable; }

void add_feature(SceneBuilder& b, const UnusedFeature& feature, bool shown) {
    Node above;
    above.flags.visible = shown;
    feature.add(b, above.children);
    b.node(above);
}

}  // namespace alidade::test
