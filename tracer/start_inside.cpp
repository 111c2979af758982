// SPDX-License-Identifier: Apache-2.0
#include "tracer/start_inside.h"

#include "tracer/instance_leaves.h"

#include <algorithm>

namespace alidade {
namespace {

/// Where the camera's rays may begin.
Bounds origins(const Camera& camera) {
    const double window = camera.projection == Projection::perspective ? 0 : length(camera.right) + length(camera.up);
    const Vec3 reach(window + camera.aperture);
    return {camera.location - reach, camera.location + reach};
}

/// An instance that is inside of what is `id`: all parts of a solid are.
const Instance* part_of(const CompiledScene& scene, uint32_t id) {
    if (id < scene.instances.size()) return &scene.instances[id];
    for (const CsgNode& node : scene.solids[id - scene.instances.size()].tree.nodes())
        if (node.op == CsgOp::leaf && node.leaf != kNoId) return &scene.instances[node.leaf];
    return nullptr;
}

bool holds(const CompiledScene& scene, uint32_t id, const Vec3& point) {
    WorkCounters unused;
    const InstanceLeaves leaves(scene, unused);
    if (id >= scene.instances.size()) return scene.solids[id - scene.instances.size()].tree.inside(point, leaves);
    return leaves.inside(id, point) != scene.scene.nodes[scene.instances[id].node.index].inverse;
}

}  // namespace

void find_what_is_around_cameras(CompiledScene& scene) {
    if (!scene.scene.atmosphere.is_hazy()) return;
    Bounds around;
    for (const PlacedCamera& placed : scene.cameras) around.extend(origins(placed.camera));
    const auto look = [&](uint32_t id, const Bounds& bounds) {
        if (!intersection(bounds, around).empty()) scene.around_cameras.push_back(id);
    };
    for (uint32_t i = 0; i < scene.instances.size(); ++i) look(i, scene.instances[i].bounds);
    for (uint32_t i = 0; i < scene.solids.size(); ++i) look(uint32_t(scene.instances.size()) + i, scene.solids[i].tree.bounds());
}

InteriorStack start_inside(const CompiledScene& scene, const Vec3& origin) {
    InteriorStack inside;
    for (const uint32_t id : scene.around_cameras) {
        const Instance* part = part_of(scene, id);
        if (!part || scene.slots[part->first_slot].interior == kNoId || !holds(scene, id, origin)) continue;
        const auto entries = inside.entries();
        const bool known = std::any_of(entries.begin(), entries.end(), [&](const InteriorStack::Entry& e) { return e.carrier == part->carrier; });
        if (!known) inside.enter({part->carrier, scene.slots[part->first_slot].interior});
    }
    return inside;
}

}  // namespace alidade
