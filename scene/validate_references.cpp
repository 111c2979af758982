// SPDX-License-Identifier: Apache-2.0
#include "scene/graph.h"
#include "scene/validation.h"

namespace alidade {

namespace {

void check_node(Validation& v, size_t i) {
    const Scene& s = v.scene;
    const Node& node = s.nodes[i];
    const Label who = label("node", i, node.name);
    for (const auto* list : {&node.children, &node.clips, &node.bounds})
        for (const NodeId id : *list) v.in_range(id, s.nodes, node.from, who, "node");
    if (const auto* id = std::get_if<ShapeId>(&node.what)) v.in_range(*id, s.shapes, node.from, who, "shape");
    if (const auto* id = std::get_if<LightId>(&node.what)) v.in_range(*id, s.lights, node.from, who, "light");
    if (const auto* id = std::get_if<CameraId>(&node.what)) v.in_range(*id, s.cameras, node.from, who, "camera");
    for (const std::optional<MaterialId>& id : node.materials)
        if (id) v.in_range(*id, s.materials, node.from, who, "material");
    if (node.inside_material) v.in_range(*node.inside_material, s.materials, node.from, who, "material");
    if (node.interior) v.in_range(*node.interior, s.interiors, node.from, who, "interior");
    for (const LightId id : node.light_group) v.in_range(id, s.lights, node.from, who, "light");
    if (node.skin) v.in_range(*node.skin, s.skins, node.from, who, "skin");
}

void check_signal(Validation& v, size_t i) {
    const Signal& signal = v.scene.signals[i];
    const Label who = label("signal", i);
    for_each_operand(v.scene, signal, [&](SignalId id) { v.in_range(id, v.scene.signals, signal.from, who, "signal"); });
    if (const auto* image = std::get_if<ImageSignal>(&signal.what)) v.in_range(image->image, v.scene.images, signal.from, who, "image");
    if (const PatternSignal* pattern = pattern_of(signal); pattern && pattern->picture) v.in_range(pattern->picture->image, v.scene.images, signal.from, who, "image");
    if (const PatternSignal* pattern = pattern_of(signal); pattern && pattern->function) v.in_range(*pattern->function, v.scene.functions, signal.from, who, "function");
}

void check_material(Validation& v, size_t i) {
    const Material& material = v.scene.materials[i];
    const Label who = label("material", i, material.name);
    const auto check = [&](SignalId id) { v.in_range(id, v.scene.signals, material.from, who, "signal"); };
    for_each_signal(material, check);
    for_each_part(material, [&](MaterialId id) { v.in_range(id, v.scene.materials, material.from, who, "material"); });
    for (const auto& layer : material.layers)
        if (const auto* g = std::get_if<GltfPbr>(&layer); g && g->occlusion) check(*g->occlusion);
}

void check_media_references(Validation& v, const std::vector<Interior::Medium>& media, const SourcePos& from, const Label& who) {
    for (const Interior::Medium& medium : media)
        for (const SignalId id : medium.density) v.in_range(id, v.scene.signals, from, who, "signal");
}

void check_surroundings_references(Validation& v) {
    const Atmosphere& a = v.scene.atmosphere;
    if (a.environment_image) v.in_range(*a.environment_image, v.scene.images, {}, label("the environment"), "image");
    for (size_t i = 0; i < v.scene.cameras.size(); ++i)
        if (const Camera& c = v.scene.cameras[i]; c.normal) v.in_range(*c.normal, v.scene.signals, c.from, label("camera", i, c.name), "signal");
    for (const Rainbow& r : a.rainbows)
        if (r.colors) v.in_range(*r.colors, v.scene.signals, {}, label("a rainbow"), "signal");
    if (a.sky)
        for (const SignalId id : a.sky->pigments) v.in_range(id, v.scene.signals, {}, label("the sky"), "signal");
    check_media_references(v, a.media, {}, label("the atmosphere"));
}

}  // namespace

void check_references(Validation& v) {
    const Scene& s = v.scene;
    for (const NodeId root : s.roots) v.in_range(root, s.nodes, {}, label("the list of roots"), "node");
    for (size_t i = 0; i < s.nodes.size(); ++i) check_node(v, i);
    for (size_t i = 0; i < s.signals.size(); ++i) check_signal(v, i);
    for (size_t i = 0; i < s.materials.size(); ++i) check_material(v, i);
    for (size_t i = 0; i < s.interiors.size(); ++i) check_media_references(v, s.interiors[i].media, s.interiors[i].from, label("interior", i));
    for (size_t i = 0; i < s.lights.size(); ++i) {
        const Light& light = s.lights[i];
        for (const auto* id : {&light.looks_like, &light.projected_through})
            if (*id) v.in_range(**id, s.nodes, light.from, label("light", i, light.name), "node");
    }
    for (size_t i = 0; i < s.skins.size(); ++i)
        for (const NodeId joint : s.skins[i].joints) v.in_range(joint, s.nodes, {}, label("skin", i, s.skins[i].name), "node");
    for (size_t i = 0; i < s.animations.size(); ++i)
        for (const Channel& channel : s.animations[i].channels)
            v.in_range(channel.target, s.nodes, {}, label("animation", i, s.animations[i].name), "node");
    check_surroundings_references(v);
}

}  // namespace alidade
