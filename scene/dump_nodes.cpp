// SPDX-License-Identifier: Apache-2.0
#include "scene/dump_line.h"

namespace alidade {

namespace {

void dump_what(Line& line, const Node& node) {
    if (const auto* shape = std::get_if<ShapeId>(&node.what)) line.always("shape", *shape);
    if (const auto* light = std::get_if<LightId>(&node.what)) line.always("light", *light);
    if (const auto* camera = std::get_if<CameraId>(&node.what)) line.always("camera", *camera);
}

void dump_flags(Line& line, const NodeFlags& flags) {
    const NodeFlags usual;
    line.field("visible", flags.visible, usual.visible).field("shadow", flags.shadow, usual.shadow).field("image", flags.image, usual.image);
    line.field("reflection", flags.reflection, usual.reflection).field("hollow", flags.hollow, usual.hollow).field("uv_mapping", flags.uv_mapping, usual.uv_mapping);
    line.field("double_illuminate", flags.double_illuminate, usual.double_illuminate);
}

void dump_trs(Line& line, const std::optional<Trs>& trs) {
    if (!trs) return;
    line.word("trs").always("translation", trs->translation).always("rotation", trs->rotation).always("scale", trs->scale);
}

}  // namespace

void dump_nodes(std::string& out, const Scene& scene) {
    if (!scene.roots.empty()) Line(out, "roots").always("nodes", scene.roots);
    for (size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        Line line(out, fmt::format("node {}", i));
        line.field("name", node.name);
        dump_what(line, node);
        line.field("to_parent", node.to_parent);
        dump_trs(line, node.trs);
        line.field("materials", node.materials).field("inside_material", node.inside_material).field("interior", node.interior);
        line.field("csg", node.csg).field("inverse", node.inverse).field("whole", node.whole).field("cutaway_textures", node.cutaway_textures).field("usual_material", node.usual_material);
        line.field("children", node.children).field("clips", node.clips).field("bounds", node.bounds);
        dump_flags(line, node.flags);
        line.field("light_group", node.light_group).field("global_lights", node.global_lights, true).field("open_light_group", node.open_light_group);
        line.field("skin", node.skin).field("morph_weights", node.morph_weights).field("from", node.from);
    }
}

}  // namespace alidade
