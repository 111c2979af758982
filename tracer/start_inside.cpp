// SPDX-License-Identifier: Apache-2.0
#include "tracer/start_inside.h"

#include "tracer/instance_leaves.h"
#include "tracer/object_boxes.h"

#include <algorithm>

namespace alidade {
namespace {

bool moves_origins(const Camera& camera) {
    const bool along = camera.projection == Projection::cylindrical && camera.cylinder >= 3;
    return camera.projection == Projection::orthographic || along || camera.aperture > 0;
}

/// Where the camera's rays may begin.
Bounds origins(const Camera& camera) {
    if (!moves_origins(camera)) return {camera.location, camera.location};
    const Vec3 reach = glm::abs(camera.right) + glm::abs(camera.up) + Vec3(camera.aperture);
    return {camera.location - reach, camera.location + reach};
}

/// A part that has the interior of the whole solid, if that has one.
const Instance* part_of_whole(const CompiledScene& scene, const Solid& solid) {
    for (const CsgNode& node : solid.tree.nodes()) {
        const Instance* part = node.op == CsgOp::leaf && node.leaf != kNoId ? &scene.instances[node.leaf] : nullptr;
        if (part && part->of_whole && scene.slots[part->first_slot].interior != kNoId) return part;
    }
    return nullptr;
}

}  // namespace

StartInside::StartInside(const CompiledScene& scene, const Camera& camera) : scene_(scene) {
    if (scene.all_air) return;
    const Bounds begin = origins(camera);
    const auto look = [&](uint32_t id, const Instance& part, const Bounds& bounds) {
        const uint32_t interior = scene.slots[part.first_slot].interior;
        const Bounds both = scene.object_boxes.empty() ? bounds : intersection(bounds, scene.object_boxes[part.object]);
        if (part.of_whole && interior != kNoId && !intersection(both, begin).empty()) bodies_.push_back({id, both, {part.carrier, interior}});
    };
    for (uint32_t i = 0; i < scene.instances.size(); ++i) look(i, scene.instances[i], scene.instances[i].bounds);
    for (uint32_t i = 0; i < scene.solids.size(); ++i)
        if (const Instance* part = part_of_whole(scene, scene.solids[i])) look(uint32_t(scene.instances.size()) + i, *part, box_of_surfaces(scene, scene.solids[i]));
    if (!moves_origins(camera)) std::erase_if(bodies_, [&](const Body& body) { return !holds(body, camera.location); });
    std::vector<Bounds> boxes;
    for (const Body& body : bodies_) boxes.push_back(body.bounds);
    tree_ = BoxTree(boxes);
    if (!moves_origins(camera)) there_ = at(camera.location), fixed_ = camera.location;
}

bool StartInside::holds(const Body& body, const Vec3& point) const {
    WorkCounters unused;
    const InstanceLeaves leaves(scene_, unused);
    if (body.id >= scene_.instances.size()) return scene_.solids[body.id - scene_.instances.size()].tree.inside_unclipped(point, leaves);
    if (csg_leaf(scene_, body.id).inside == CsgInside::nowhere) return false;
    return leaves.inside(body.id, point) != scene_.scene.nodes[scene_.instances[body.id].node.index].inverse;
}

InteriorStack StartInside::at(const Vec3& origin) const {
    if (fixed_ == origin) return there_;
    std::vector<uint32_t> in;
    tree_.holding(origin, [&](uint32_t i) { if (holds(bodies_[i], origin)) in.push_back(i); });
    std::ranges::sort(in);
    InteriorStack inside;
    for (const uint32_t i : in) inside.enter(bodies_[i].entry);
    return inside;
}

}  // namespace alidade
