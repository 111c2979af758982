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

/// Some leaf of the solid; kNoId if it has none.
uint32_t any_part(const Solid& solid) {
    for (const CsgNode& node : solid.tree.nodes())
        if (node.op == CsgOp::leaf && node.leaf != kNoId) return node.leaf;
    return kNoId;
}

}  // namespace

StartInside::StartInside(const CompiledScene& scene, const Camera& camera) : scene_(scene) {
    if (scene.all_air) return;
    const Bounds begin = origins(camera);
    add_objects(begin);
    if (!moves_origins(camera)) std::erase_if(bodies_, [&](const Body& body) { return !holds(body, camera.location); });
    std::vector<Bounds> boxes;
    for (const Body& body : bodies_) boxes.push_back(body.bounds);
    tree_ = BoxTree(boxes);
    if (!moves_origins(camera)) there_ = at(camera.location), fixed_ = camera.location;
}

/// Instances of one object follow each other, and its solids. Where nobody asks for objects (0), each instance and each solid is one.
void StartInside::add_objects(const Bounds& begin) {
    const auto& instances = scene_.instances;
    const uint32_t count = uint32_t(instances.size());
    uint32_t solid = 0;
    for (uint32_t i = 0, end = 0; i < count; i = end) {
        Body body;
        std::optional<InteriorStack::Entry> entry;
        const uint32_t object = instances[i].object;
        for (end = i; end == i || (end < count && object != 0 && instances[end].object == object); ++end) {
            if (!entry) entry = filling(instances[end]);
            if (instances[end].bounds.empty()) continue;   // a part of a solid
            body.parts.push_back(end);
            body.bounds.extend(instances[end].bounds);
        }
        for (; solid < scene_.solids.size(); ++solid) {
            const uint32_t part = any_part(scene_.solids[solid]);
            if (part == kNoId) continue;
            if (part >= end) break;
            body.parts.push_back(count + solid);
            body.bounds.extend(box_of_surfaces(scene_, scene_.solids[solid]));
            for (const CsgNode& node : scene_.solids[solid].tree.nodes())
                if (!entry && node.op == CsgOp::leaf && node.leaf != kNoId) entry = filling(instances[node.leaf]);
        }
        if (!entry) entry = filling(object);
        if (!entry) continue;
        if (!scene_.object_boxes.empty()) body.bounds = intersection(body.bounds, scene_.object_boxes[object]);
        body.entry = *entry;
        if (!intersection(body.bounds, begin).empty()) bodies_.push_back(std::move(body));
    }
}

std::optional<InteriorStack::Entry> StartInside::filling(const Instance& part) const {
    const uint32_t interior = scene_.slots[part.first_slot].interior;
    if (!part.of_whole || interior == kNoId) return std::nullopt;
    return InteriorStack::Entry{part.carrier, interior};
}

std::optional<InteriorStack::Entry> StartInside::filling(uint32_t object) const {
    const auto whole = std::ranges::lower_bound(scene_.whole_interiors, object, {}, &WholeInterior::object);
    if (whole == scene_.whole_interiors.end() || whole->object != object) return std::nullopt;
    return InteriorStack::Entry{whole->carrier, whole->interior};
}

bool StartInside::holds(const Body& body, const Vec3& point) const {
    return std::ranges::any_of(body.parts, [&](uint32_t part) { return holds(part, point); });
}

bool StartInside::holds(uint32_t part, const Vec3& point) const {
    WorkCounters unused;
    const InstanceLeaves leaves(scene_, unused);
    if (part >= scene_.instances.size()) return scene_.solids[part - scene_.instances.size()].tree.inside_unclipped(point, leaves);
    if (csg_leaf(scene_, part).inside == CsgInside::nowhere) return false;
    return leaves.inside(part, point) != scene_.scene.nodes[scene_.instances[part].node.index].inverse;
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
