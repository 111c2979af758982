// SPDX-License-Identifier: Apache-2.0
#include "tracer/filters.h"

#include "tracer/instance_set.h"
#include "tracer/materials.h"
#include "tracer/pov_surface.h"

#include <algorithm>
#include <map>

namespace alidade {

namespace {

/// A solid lets light through if one of its parts does.
void tell_opaque_from_clear(CompiledScene& out) {
    std::map<uint32_t, bool> known;
    const auto lets_through = [&](uint32_t material) {
        const auto [at, added] = known.try_emplace(material, false);
        if (added) at->second = lets_light_through(out.scene, material);
        return at->second;
    };
    const auto is_clear = [&](const Instance& i) {
        const auto first = out.slots.begin() + i.first_slot, end = first + slot_count(out.scene.shapes[out.geometries[i.geometry].shape.index].geometry);
        return std::any_of(first, end + (i.inside_slot != kNoId), [&](const SlotMaterial& slot) { return lets_through(slot.material); });
    };
    for (Instance& i : out.instances) i.mask &= ~(is_clear(i) ? kMaskOpaque : kMaskFilter);
    for (Solid& solid : out.solids) {
        const auto nodes = solid.tree.nodes();
        const bool clear = std::any_of(nodes.begin(), nodes.end(), [&](const CsgNode& n) { return n.op == CsgOp::leaf && n.leaf != kNoId && is_clear(out.instances[n.leaf]); });
        solid.mask &= ~(clear ? kMaskOpaque : kMaskFilter);
    }
}

}  // namespace

void build_filters(CompiledScene& out, const AcceleratorEntry& accel, const AccelOptions& build) {
    tell_opaque_from_clear(out);
    for (const SlotMaterial& slot : out.slots) out.uniform_filters.push_back(uniform_filter(out, slot));
    const auto filters = std::make_shared<InstanceSet>(out, kMaskFilter);
    for (uint32_t id = 0; id < filters->size(); ++id) out.filter_bounds.extend(filters->bounds(id));
    out.filters = accel.over_set(filters, build);
    constexpr size_t kLeastShare = 4;   // where fewer than a fourth are clear, the structure over all is as good, and there already
    const auto is_clear = [](const auto& one) { return !(one.mask & kMaskOpaque); };
    const auto clear = std::count_if(out.instances.begin(), out.instances.end(), is_clear) + std::count_if(out.solids.begin(), out.solids.end(), is_clear);
    if (kLeastShare * size_t(clear) >= out.instances.size() + out.solids.size()) out.opaques = accel.over_set(std::make_shared<InstanceSet>(out, kMaskOpaque), build);
}

}  // namespace alidade
