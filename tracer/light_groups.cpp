// SPDX-License-Identifier: Apache-2.0
#include "tracer/light_groups.h"

#include <algorithm>
#include <utility>

namespace alidade {

LightGroups::LightGroups(const Scene& scene) : scene_(scene), any_(std::any_of(scene.nodes.begin(), scene.nodes.end(), [](const Node& n) { return !n.light_group.empty() || !n.global_lights; })) {}

uint32_t LightGroups::group_at(const std::vector<NodeId>& path, size_t length) {
    std::vector<uint32_t> key;
    for (size_t i = 0; i < length; ++i) key.push_back(path[i].index);
    return groups_.try_emplace(std::move(key), uint32_t(groups_.size())).first->second;
}

uint32_t LightGroups::set_of(const std::vector<NodeId>& path) {
    if (!any_) return 0;
    Set set;
    uint32_t innermost = kNoId, around = kNoId;   // of groups in groups the innermost shines alone
    bool is_open = false;
    for (size_t i = 0; i < path.size(); ++i) {
        const Node& node = scene_.nodes[path[i].index];
        set.global = set.global && node.global_lights;
        if (node.csg != CsgKind::none) is_open = false;
        if (node.light_group.empty()) continue;
        around = std::exchange(innermost, group_at(path, i + 1));
        is_open = node.open_light_group;
    }
    if (innermost != kNoId) set.groups.push_back(innermost);
    if (is_open && around != kNoId) set.groups.push_back(around);
    const auto same = [&](const Set& s) { return s.groups == set.groups && s.global == set.global; };
    const auto found = std::find_if(sets_.begin(), sets_.end(), same);
    const auto index = uint32_t(found - sets_.begin());
    if (found == sets_.end()) sets_.push_back(std::move(set));
    return index;
}

void LightGroups::add_light(const std::vector<NodeId>& path, LightId light) {
    if (!any_) return;
    uint32_t group = kNoId;
    for (size_t i = 0; i < path.size(); ++i) {
        const std::vector<LightId>& own = scene_.nodes[path[i].index].light_group;
        if (scene_.nodes[path[i].index].csg != CsgKind::none) group = kNoId;   // lights of sets are no group's
        if (std::find(own.begin(), own.end(), light) != own.end()) group = group_at(path, i + 1);
    }
    group_of_light_.push_back(group);
}

void LightGroups::finish(CompiledScene& out) const {
    if (!any_) return;
    for (const Set& set : sets_) {
        std::vector<bool>& lit = out.lit_by.emplace_back();
        for (const uint32_t group : group_of_light_) lit.push_back(group == kNoId ? set.global : std::find(set.groups.begin(), set.groups.end(), group) != set.groups.end());
    }
}

}  // namespace alidade
