// SPDX-License-Identifier: Apache-2.0
#include "tracer/light_groups.h"

#include <algorithm>

namespace alidade {

LightGroups::LightGroups(const Scene& scene) : scene_(scene), local_(scene.lights.size()) {
    for (const Node& node : scene.nodes) {
        any_ = any_ || !node.light_group.empty() || !node.global_lights;
        for (const LightId id : node.light_group) local_[id.index] = true;
    }
}

uint32_t LightGroups::set_of(const std::vector<NodeId>& path) {
    if (!any_) return 0;
    Set set;
    for (const NodeId id : path) {
        const Node& node = scene_.nodes[id.index];
        set.global = set.global && node.global_lights;
        if (!node.light_group.empty()) set.lights = node.light_group;   // of groups in groups the innermost with lights has those alone
    }
    const auto same = [&](const Set& s) { return s.lights == set.lights && s.global == set.global; };
    const auto found = std::find_if(sets_.begin(), sets_.end(), same);
    const auto index = uint32_t(found - sets_.begin());
    if (found == sets_.end()) sets_.push_back(std::move(set));
    return index;
}

bool LightGroups::reaches(const Set& set, LightId light) const {
    if (light.index >= local_.size() || !local_[light.index]) return set.global;
    return std::find(set.lights.begin(), set.lights.end(), light) != set.lights.end();
}

void LightGroups::finish(CompiledScene& out) const {
    if (!any_) return;
    for (const Set& set : sets_) {
        std::vector<bool>& lit = out.lit_by.emplace_back();
        for (const PlacedLight& light : out.lights) lit.push_back(reaches(set, light.id));
    }
}

}  // namespace alidade
