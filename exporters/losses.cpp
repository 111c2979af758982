// SPDX-License-Identifier: Apache-2.0
#include "exporters/losses.h"

#include "exporters/output_files.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade {

namespace {

void add_to(std::vector<Loss>& list, const std::string& what, size_t count, const std::string& instead) {
    const auto known = std::find_if(list.begin(), list.end(), [&](const Loss& loss) { return loss.what == what && loss.instead == instead; });
    if (known != list.end()) known->count += count;
    else list.push_back({what, count, instead});
}

}  // namespace

void Losses::add(const std::string& what, size_t count, const std::string& instead) {
    if (count > 0) add_to(list_, what, count, instead);
}

void Losses::add_of_material(const MaterialRef& material, const std::string& what, size_t count, const std::string& instead) {
    if (count == 0) return;
    add_to(list_, fmt::format("{} of material '{}'", what, plain_name(material.name, "unnamed")), count, instead);
    add_to(row_of(material).losses, what, count, instead);
}

void Losses::wrote(const MaterialRef& material) { row_of(material); }

WrittenMaterial& Losses::row_of(const MaterialRef& material) {
    const auto known = std::find_if(materials_.begin(), materials_.end(), [&](const WrittenMaterial& m) { return m.material.index == material.index; });
    return known != materials_.end() ? *known : materials_.emplace_back(WrittenMaterial{material, {}});
}

namespace {

void add_node_losses(const Node& node, Losses& losses) {
    const bool cuts = node.csg != CsgKind::none && node.csg != CsgKind::union_;   // a union is its parts
    losses.add("constructive solid geometry (intersection, difference, merge)", cuts, "its parts are written, uncut");
    losses.add("inverted solids", node.inverse, "written as they are");
    losses.add("clips", node.clips.size(), "what is clipped is written, uncut");
    losses.add("bounds", node.bounds.size(), "rays that miss them see what they bound, too");
    losses.add("materials of insides", node.inside_material.has_value());
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
