// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/meshes.h"

#include "exporters/gltf/primitive.h"

#include <algorithm>

namespace alidade::gltf_export {

namespace {

void add_mesh_losses(const Mesh& mesh, bool skinned, Losses& losses) {
    losses.add("polygons", !mesh.faces.empty(), "triangles");
    losses.add("meshes with coordinates that have more digits than a float", !mesh.exact_positions.empty(), "floats");
    losses.add("origins of skinned meshes", skinned && mesh.origin != Vec3(0), "floats");
    losses.add("tangents without normals", mesh.tangents.present() && !mesh.normals.present());
}

}  // namespace

const std::vector<MeshWriter::Primitive>& MeshWriter::primitives(ShapeId shape, bool skinned) {
    const auto [known, added] = primitives_.try_emplace({shape, skinned});
    if (!added) return known->second;
    const ShapeEntry& entry = scene_.shapes[shape.index];
    const auto* mesh = std::get_if<Mesh>(&entry.geometry);
    if (!mesh) {
        losses_.add("spheres, planes, boxes and other shapes that are no meshes");
        return known->second;
    }
    add_mesh_losses(*mesh, skinned, losses_);
    const std::vector<uint32_t> finite = finite_triangles(*mesh);
    losses_.add("triangles with a vertex that is not finite", mesh->triangles.size() - finite.size());
    std::vector<std::vector<uint32_t>> by_slot(slot_count(entry.geometry));
    for (const uint32_t t : finite) by_slot[mesh->slots.empty() ? 0 : mesh->slots[t]].push_back(t);
    for (uint32_t slot = 0; slot < by_slot.size(); ++slot)
        if (!by_slot[slot].empty()) known->second.push_back({slot, write_primitive(*mesh, by_slot[slot], skinned, document_, losses_)});
    return known->second;
}

std::optional<size_t> MeshWriter::add(ShapeId shape, const SlotMaterials& materials, bool skinned) {
    const std::vector<Primitive>& parts = primitives(shape, skinned);
    if (parts.empty()) return std::nullopt;
    const auto [known, added] = meshes_.try_emplace({shape, skinned, materials});
    if (!added) return known->second;
    const ShapeEntry& entry = scene_.shapes[shape.index];
    Json mesh = Json::object();
    set(mesh, "name", entry.name, std::string());
    for (const Primitive& part : parts) {
        Json json = part.json;
        if (materials[part.slot]) json["material"] = materials[part.slot]->index;
        mesh["primitives"].push_back(std::move(json));
    }
    const std::vector<double>& weights = std::get<Mesh>(entry.geometry).morph_weights;
    if (std::any_of(weights.begin(), weights.end(), [](double w) { return w != 0; })) mesh["weights"] = weights;
    return known->second = document_.add("meshes", std::move(mesh));
}

}  // namespace alidade::gltf_export
