// SPDX-License-Identifier: Apache-2.0
/// Surfaces of POV-Ray's of which all but the normal is known before any ray.
#include "tracer/pov_surface.h"

#include <algorithm>

namespace alidade {

namespace {

/// Does it look the same from everywhere? Layers that conserve energy let through what their mirrors leave.
bool is_plain(const Scene& scene, const PovFinish& finish) {
    return !finish.normal && !finish.conserve_energy && std::holds_alternative<ConstantSignal>(scene.signals[finish.pigment.index].what);
}

}  // namespace

std::unique_ptr<const PlainPovSurface> PovSurface::plain(const CompiledScene& scene, const SlotMaterial& slot) {
    const Material& material = scene.scene.materials[slot.material];
    const bool plain = std::all_of(material.layers.begin(), material.layers.end(), [&](const auto& layer) {
        const auto* finish = std::get_if<PovFinish>(&layer);
        return finish && is_plain(scene.scene, *finish);
    });
    if (!plain) return nullptr;
    PovSurface made;
    made.add_layers(scene, ShadePoint(), material, 1, PatternFrame());
    auto out = std::make_unique<PlainPovSurface>();
    out->texture = made.textures_.front(), out->sends_on = made.sends_on_;
    out->layers.assign(made.layers_.begin(), made.layers_.end());
    out->emitted = made.emitted(scene.scene.settings.ambient_light), out->hole = made.is_hole();
    return out;
}

PlainPovSurfaces plain_surfaces(const CompiledScene& scene) {
    constexpr size_t kMost = 10'000;   // of so many slots each is seen too seldom to be worth the memory
    if (scene.slots.size() > kMost) return {};
    PlainPovSurfaces out(scene.slots.size());
    std::transform(scene.slots.begin(), scene.slots.end(), out.begin(), [&](const SlotMaterial& slot) { return PovSurface::plain(scene, slot); });
    if (std::none_of(out.begin(), out.end(), [](const auto& plain) { return bool(plain); })) out.clear();
    return out;
}

const PlainPovSurface* PovSurface::plain_at(const CompiledScene& scene, const ShadePoint& point) {
    if (scene.plain_surfaces.empty()) return nullptr;
    const Instance& instance = scene.instances[point.instance];
    const bool of_one_slot = point.slot == instance.inside_slot || (instance.cutaway == kNoId && (!point.mesh || point.mesh->corner_slots.empty()));
    return of_one_slot ? scene.plain_surfaces[point.slot].get() : nullptr;
}

void PovSurface::take(const PlainPovSurface& plain) {
    plain_ = &plain, sends_on_ = plain.sends_on;
    textures_.push_back(plain.texture);
    for (const PovLayer& layer : plain.layers) layers_.push_back(layer);
    for (PovLayer& layer : layers_) layer.normal = normal_;
    if (std::isnan(normal_.x)) become_black();
}

}  // namespace alidade
