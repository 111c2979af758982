// SPDX-License-Identifier: Apache-2.0
#include "tracer/explain.h"

#include "accel/lazy.h"
#include "scene/graph.h"
#include "scene/queries.h"
#include "tracer/materials.h"
#include "tracer/textures.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace alidade {
namespace {

std::string named(const std::string& name, size_t number) { return name.empty() ? fmt::format("number {}", number) : name; }
std::string named(const Image& image, size_t number) { return named(image.path.empty() ? image.name : image.path, number); }

std::optional<uint32_t> image_of(const Signal& signal) {
    if (const auto* image = std::get_if<ImageSignal>(&signal.what)) return image->image.index;
    if (const PatternSignal* pattern = pattern_of(signal); pattern && pattern->picture) return pattern->picture->image.index;
    return std::nullopt;
}

/// The materials of the objects that lights are projected through.
void add_projected(const Scene& scene, std::vector<uint32_t>& out) {
    std::vector<NodeId> open;
    for (const Light& light : scene.lights)
        if (light.projected_through) open.push_back(*light.projected_through);
    std::vector<bool> seen(scene.nodes.size());
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        if (seen[id.index]) continue;
        seen[id.index] = true;
        const Node& node = scene.nodes[id.index];
        for (const auto& material : node.materials)
            if (material) out.push_back(material->index);
        open.insert(open.end(), node.children.begin(), node.children.end());
    }
}

/// By material: does light meet it, or a material that it is a part of?
std::vector<bool> used_materials(const CompiledScene& scene) {
    std::vector<bool> used(scene.scene.materials.size());
    std::vector<uint32_t> open;
    for (const SlotMaterial& slot : scene.slots) open.push_back(slot.material);
    add_projected(scene.scene, open);
    while (!open.empty()) {
        const uint32_t i = open.back();
        open.pop_back();
        if (used[i]) continue;
        used[i] = true;
        for_each_part(scene.scene.materials[i], [&](MaterialId part) { open.push_back(part.index); });
    }
    return used;
}

bool reads(const Scene& scene, SignalId root, uint32_t image) {
    std::vector<SignalId> signals;
    collect_signals(scene, root, signals);
    return std::any_of(signals.begin(), signals.end(), [&](SignalId id) { return image_of(scene.signals[id.index]) == image; });
}

/// Does a signal of the material that is rendered read the image? Or one that is not: the occlusion?
bool reads(const Scene& scene, const Material& material, uint32_t image) {
    bool found = false;
    for_each_signal(material, [&](SignalId id) { found = found || reads(scene, id, image); });
    return found;
}
bool occlusion_reads(const Scene& scene, const Material& material, uint32_t image) {
    const auto* pbr = material.layers.empty() ? nullptr : std::get_if<GltfPbr>(&material.layers[0]);
    return pbr && pbr->occlusion && reads(scene, *pbr->occlusion, image);
}

/// The first material, of those that are used or of the others, that reads the image.
std::optional<uint32_t> reader_of(const Scene& scene, uint32_t image, const std::vector<bool>& used, bool wanted) {
    for (uint32_t i = 0; i < scene.materials.size(); ++i)
        if (used[i] == wanted && reads(scene, scene.materials[i], image)) return i;
    return std::nullopt;
}

std::string who_reads(const Scene& scene, uint32_t image, const std::vector<bool>& used) {
    const auto material = reader_of(scene, image, used, true);
    return material ? fmt::format("material '{}' reads it", scene.materials[*material].name) : "the sky or the air reads it";
}

std::string why_not_read(const Scene& scene, uint32_t image, const std::vector<bool>& used) {
    for (uint32_t i = 0; i < scene.materials.size(); ++i)
        if (used[i] && occlusion_reads(scene, scene.materials[i], image)) return fmt::format("only the occlusion of material '{}' is in it, which a ray tracer finds itself", scene.materials[i].name);
    if (const auto material = reader_of(scene, image, used, false)) return fmt::format("no surface that is shown has material '{}'", scene.materials[*material].name);
    return "nothing reads it";
}

/// By image: was it decoded?
std::vector<bool> decoded_images(const CompiledScene& scene, const std::vector<bool>& used) {
    std::vector<bool> out(scene.scene.images.size());
    for (uint32_t i = 0; i < scene.scene.signals.size(); ++i)
        if (const auto image = image_of(scene.scene.signals[i]); image && scene.textures->reads({i})) out[*image] = true;
    for (uint32_t i = 0; i < out.size(); ++i)
        if (!out[i] && reader_of(scene.scene, i, used, true)) out[i] = true;   // of what a light is projected through, which has pictures of its own
    return out;
}

/// Skins and morph targets are shown by copies, which stand behind all that was read (deform()).
bool shown_deformed(const Scene& scene, const std::vector<bool>& shown, size_t shape) {
    const auto* mesh = std::get_if<Mesh>(&scene.shapes[shape].geometry);
    if (!mesh || (mesh->morphs.empty() && mesh->joint_sets.empty())) return false;
    for (size_t i = shape + 1; i < shown.size(); ++i)
        if (shown[i] && scene.shapes[i].name == scene.shapes[shape].name) return true;
    return false;
}

void leave_out_shapes(const CompiledScene& scene, std::vector<Explained>& out) {
    std::vector<bool> shown(scene.scene.shapes.size()), held(scene.scene.shapes.size());
    for (const Geometry& g : scene.geometries) shown[g.shape.index] = true;
    for (const Node& node : scene.scene.nodes)
        if (const auto* shape = std::get_if<ShapeId>(&node.what)) held[shape->index] = true;
    for (size_t i = 0; i < shown.size(); ++i) {
        if (shown[i] || shown_deformed(scene.scene, shown, i)) continue;
        const ShapeEntry& shape = scene.scene.shapes[i];
        out.push_back({std::holds_alternative<Mesh>(shape.geometry) ? "mesh" : "shape", named(shape.name, i), held[i] ? "its nodes are hidden, or not of this scene" : "no node holds it"});
    }
}

void leave_out_structures(const CompiledScene& scene, std::vector<Explained>& out) {
    for (const Geometry& g : scene.geometries)
        if (g.mesh && !built(*g.triangles)) out.push_back({"structure", named(scene.scene.shapes[g.shape.index].name, g.shape.index), "it is built when a ray enters its box (--lazy)"});
    if (!scene.filters) out.push_back({"structure", "instances that let light through", "there are none: a shadow ray asks whether there is a hit, not which"});
}

}  // namespace

std::vector<Explained> decoded(const CompiledScene& scene) {
    std::vector<Explained> out;
    const std::vector<bool> used = used_materials(scene), images = decoded_images(scene, used);
    for (uint32_t i = 0; i < images.size(); ++i)
        if (images[i]) out.push_back({"image", named(scene.scene.images[i], i), who_reads(scene.scene, i, used)});
    for (const Geometry& g : scene.geometries)
        if (!g.tangents.empty()) out.push_back({"tangents", named(scene.scene.shapes[g.shape.index].name, g.shape.index), "a normal map needs them, and the mesh has none"});
    return out;
}

std::vector<Explained> left_out(const CompiledScene& scene) {
    std::vector<Explained> out;
    leave_out_shapes(scene, out);
    const std::vector<bool> used = used_materials(scene), images = decoded_images(scene, used);
    for (size_t i = 0; i < used.size(); ++i)
        if (!used[i]) out.push_back({"material", named(scene.scene.materials[i].name, i), "no surface that is shown has it"});
    for (uint32_t i = 0; i < images.size(); ++i)
        if (!images[i]) out.push_back({"image", named(scene.scene.images[i], i), why_not_read(scene.scene, i, used)});
    leave_out_structures(scene, out);
    for (size_t bit = 0; bit < feature_names().size(); ++bit)
        if (!(scene.features & (1u << bit))) out.push_back({"feature", feature_names()[bit], "nothing needs it: the kernel has no code for it"});
    return out;
}

}  // namespace alidade
