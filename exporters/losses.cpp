// SPDX-License-Identifier: Apache-2.0
#include "exporters/losses.h"

namespace alidade {

void Losses::add(const std::string& what, size_t count, const std::string& instead) {
    if (count == 0) return;
    for (Loss& loss : list_)
        if (loss.what == what && loss.instead == instead) {
            loss.count += count;
            return;
        }
    list_.push_back({what, count, instead});
}

namespace {

void add_node_losses(const Node& node, Losses& losses) {
    const bool cuts = node.csg != CsgKind::none && node.csg != CsgKind::union_;   // a union is its parts
    losses.add("constructive solid geometry (intersection, difference, merge)", cuts, "its parts are written, uncut");
    losses.add("inverted solids", node.inverse, "written as they are");
    losses.add("clips", node.clips.size(), "what is clipped is written, uncut");
    losses.add("bounds", node.bounds.size());
    losses.add("materials of insides", node.inside_materials.size());
    losses.add("interiors", node.interior.has_value());
    losses.add("light groups", !node.light_group.empty() || !node.global_lights, "all lights shine on all");
    const NodeFlags& f = node.flags;
    losses.add("nodes that some rays do not see", !f.shadow || !f.image || !f.reflection, "all rays see them");
}

}  // namespace

void add_common_losses(const Scene& scene, Losses& losses) {
    for (const Node& node : scene.nodes) add_node_losses(node, losses);
    for (const ShapeEntry& shape : scene.shapes)
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) losses.add("meshes that mix textures over triangles", !mesh->corner_slots.empty(), "the first corner's");
    for (const Light& light : scene.lights) losses.add("lights that are projected through an object", light.projected_through.has_value(), "lights that nothing limits");
    for (const Camera& camera : scene.cameras) losses.add("normals of cameras", camera.normal.has_value());
    const Atmosphere& a = scene.atmosphere;
    losses.add("environments", size_t(a.environment.has_value()) + a.environment_image.has_value());
    losses.add("backgrounds", !is_black(a.background));
    losses.add("fogs", a.fogs.size());
    losses.add("rainbows", a.rainbows.size());
    losses.add("sky spheres", a.sky.has_value());
    losses.add("media", a.media.size());
}

}  // namespace alidade
