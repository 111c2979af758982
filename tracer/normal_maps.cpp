// SPDX-License-Identifier: Apache-2.0
#include "tracer/normal_maps.h"

#include "core/parallel.h"
#include "eval/tangents.h"

#include <set>

namespace alidade {
namespace {

struct Missing {
    uint32_t geometry, uv_set;
    friend auto operator<=>(const Missing&, const Missing&) = default;
};

/// What the materials of one instance ask of its mesh.
void collect(const CompiledScene& scene, const Instance& instance, std::set<Missing>& missing) {
    const Mesh* mesh = scene.geometries[instance.geometry].mesh;
    if (!mesh || mesh->tangents.present()) return;
    const uint32_t slots = slot_count(*scene.geometries[instance.geometry].source);
    for (uint32_t slot = 0; slot < slots; ++slot) {
        const Material& material = scene.scene.materials[scene.slots[instance.first_slot + slot].material];
        const auto* pbr = material.layers.empty() ? nullptr : std::get_if<GltfPbr>(&material.layers[0]);
        if (!pbr) continue;
        for (const auto& map : {pbr->normal, pbr->clearcoat_normal}) {
            if (!map) continue;
            const uint32_t set = tangent_uv_set(scene.scene, *map);
            if (set < mesh->uvs.size() && mesh->uvs[set].present()) missing.insert({instance.geometry, set});
        }
    }
}

}  // namespace

uint32_t tangent_uv_set(const Scene& scene, SignalId normal_map) {
    const auto* image = std::get_if<ImageSignal>(&scene.signals[normal_map.index].what);
    return image ? image->uv_set : 0;
}

void make_missing_tangents(CompiledScene& scene, int threads) {
    std::set<Missing> found;
    for (const Instance& instance : scene.instances) collect(scene, instance, found);
    const std::vector<Missing> missing(found.begin(), found.end());
    for (const Missing& m : missing) scene.geometries[m.geometry].tangents.resize(m.uv_set + 1);
    parallel_for(missing.size(), threads, [&](size_t i) {
        Geometry& g = scene.geometries[missing[i].geometry];
        g.tangents[missing[i].uv_set] = make_tangents(*g.mesh, missing[i].uv_set);
    });
}

}  // namespace alidade
