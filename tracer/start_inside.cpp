// SPDX-License-Identifier: Apache-2.0
#include "tracer/start_inside.h"

#include "tracer/instance_leaves.h"

#include <algorithm>

namespace alidade {
namespace {

bool is_pinhole(const Camera& camera) { return camera.projection == Projection::perspective && camera.aperture == 0; }

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

/// Of the surfaces of node `n` and of what is behind it. Of an intersection those parts count that are nothing far away, or all if there are none.
Bounds surfaces(const CompiledScene& scene, std::span<const CsgNode> nodes, uint32_t n) {
    const CsgNode& node = nodes[n];
    if (node.op == CsgOp::leaf) {
        const Instance* part = node.leaf == kNoId ? nullptr : &scene.instances[node.leaf];
        return part ? part->to_world.bounds(scene.geometries[part->geometry].bounds) : Bounds();
    }
    const bool meets = node.op == CsgOp::intersection || node.op == CsgOp::clip;
    Bounds any, all = {Vec3(-kInf), Vec3(kInf)};
    bool limited = false;
    for (uint32_t child = n + 1; child < node.end; child = nodes[child].end) {
        const Bounds bounds = surfaces(scene, nodes, child);
        any.extend(bounds);
        if (!nodes[child].far) all = intersection(all, bounds), limited = true;
    }
    return meets && limited ? all : any;
}

bool holds(const CompiledScene& scene, const Surrounding& body, const Vec3& point) {
    if (!body.bounds.contains(point)) return false;
    const uint32_t id = body.id;
    WorkCounters unused;
    const InstanceLeaves leaves(scene, unused);
    if (id >= scene.instances.size()) return scene.solids[id - scene.instances.size()].tree.inside(point, leaves);
    return leaves.inside(id, point) != scene.scene.nodes[scene.instances[id].node.index].inverse;
}

}  // namespace

void find_what_is_around_cameras(CompiledScene& scene) {
    if (scene.all_air) return;
    Bounds around;
    for (const PlacedCamera& placed : scene.cameras) around.extend(origins(placed.camera));
    const auto look = [&](uint32_t id, const Bounds& bounds) {
        if (!intersection(bounds, around).empty()) scene.around_cameras.push_back({id, bounds});
    };
    for (uint32_t i = 0; i < scene.instances.size(); ++i) look(i, scene.instances[i].bounds);
    for (uint32_t i = 0; i < scene.solids.size(); ++i) look(uint32_t(scene.instances.size()) + i, surfaces(scene, scene.solids[i].tree.nodes(), 0));
    // Where all rays of a camera begin at one place, it is known now.
    if (!std::all_of(scene.cameras.begin(), scene.cameras.end(), [](const PlacedCamera& placed) { return is_pinhole(placed.camera); })) return;
    std::erase_if(scene.around_cameras, [&](const Surrounding& body) {
        return std::none_of(scene.cameras.begin(), scene.cameras.end(), [&](const PlacedCamera& placed) { return holds(scene, body, placed.camera.location); });
    });
}

InteriorStack start_inside(const CompiledScene& scene, const Vec3& origin) {
    InteriorStack inside;
    for (const Surrounding& body : scene.around_cameras) {
        const Instance* part = part_of(scene, body.id);
        if (!part || scene.slots[part->first_slot].interior == kNoId || !holds(scene, body, origin)) continue;
        const auto entries = inside.entries();
        const bool known = std::any_of(entries.begin(), entries.end(), [&](const InteriorStack::Entry& e) { return e.carrier == part->carrier; });
        if (!known) inside.enter({part->carrier, scene.slots[part->first_slot].interior});
    }
    return inside;
}

}  // namespace alidade
