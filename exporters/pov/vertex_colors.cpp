// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/vertex_colors.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace alidade::pov_export {

namespace {

/// More textures than that make POV-Ray slow.
constexpr size_t kMostTextures = 65'536;

bool is_white(const Vec4f& c) { return c == Vec4f(1.0f); }

/// May the base colour of this material be multiplied, and stay in one layer? With a picture, by one colour for all.
bool can_be_tinted(const Scene& scene, std::optional<MaterialId> id, bool one_colour) {
    if (!id || scene.materials[id->index].layers.empty()) return false;
    const auto* pbr = std::get_if<GltfPbr>(&scene.materials[id->index].layers.front());
    const bool plain = pbr && (one_colour || std::holds_alternative<ConstantSignal>(scene.signals[pbr->base_color.index].what));
    return plain && !pbr->emissive && !pbr->clearcoat;
}

/// Is there a border between what such alphas cut out and what they leave? The lowest and the highest are asked.
bool cuts_out(const Scene& scene, MaterialId id, float least, float most) {
    const auto* pbr = std::get_if<GltfPbr>(&scene.materials[id.index].layers.front());
    const auto* base = pbr ? std::get_if<ConstantSignal>(&scene.signals[pbr->base_color.index].what) : nullptr;
    return base && pbr->alpha_mode == AlphaMode::mask && base->value.w * double(least) < pbr->alpha_cutoff && base->value.w * double(most) >= pbr->alpha_cutoff;
}

MaterialRef ref_of(const Scene& scene, MaterialId id) { return {id.index, scene.materials[id.index].name}; }

}  // namespace

VertexColors::VertexColors(const Mesh& mesh, const SlotMaterials& slots, std::span<const uint32_t> which, const Scene& scene, Losses& losses) {
    if (mesh.colors.empty() || !mesh.colors[0].present()) return;
    losses.add("further vertex colours", mesh.colors.size() - 1);
    const Attribute<Vec4f>& colors = mesh.colors[0];
    if (std::all_of(colors.values.begin(), colors.values.end(), is_white)) return;
    const bool one_colour = std::all_of(colors.values.begin(), colors.values.end(), [&](const Vec4f& c) { return c == colors.values.front(); });
    std::map<std::pair<MaterialId, Tint>, uint32_t> known;
    const auto number_of = [&](MaterialId material, Vec4f value) {
        for (int i = 0; i < 4; ++i) value[i] = std::isfinite(value[i]) ? value[i] : 1.0f;
        const std::pair key{material, Tint{value.x, value.y, value.z, value.w}};
        const auto [at, added] = known.try_emplace(key, uint32_t(known.size()));
        if (added) textures_.push_back(key);
        return at->second;
    };
    for (const uint32_t t : which) {
        const auto material = slots[slot_of(mesh, slots.size(), t)];
        if (!can_be_tinted(scene, material, one_colour) || known.size() > kMostTextures) {
            textures_.clear();
            if (material) losses.add_of_material(ref_of(scene, *material), "the vertex colours");
            else losses.add("vertex colours");
            return;
        }
        Index3& corners = corners_.emplace_back(0u, 0u, 0u);
        for (int c = 0; c < 3; ++c) corners[c] = number_of(*material, colors.values[colors.index(t, c, mesh.triangles[t])]);
    }
    std::map<MaterialId, std::pair<float, float>> alphas;
    for (const auto& [material, tint] : textures_) {
        auto& [least, most] = alphas.try_emplace(material, tint[3], tint[3]).first->second;
        least = std::min(least, tint[3]), most = std::max(most, tint[3]);
    }
    for (const auto& [material, range] : alphas) {
        losses.add_of_material(ref_of(scene, material), "faint mirror images under the vertex colours");
        losses.add_of_material(ref_of(scene, material), "the border of what the alpha of vertex colours cuts out", cuts_out(scene, material, range.first, range.second), "a slope over its triangles");
    }
}

void VertexColors::write(TextureWriter& textures) const {
    for (const auto& [material, tint] : textures_) textures.tinted(material, Vec4(Vec4f(tint[0], tint[1], tint[2], tint[3])));
}

}  // namespace alidade::pov_export
