// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/unreached.h"

#include "scene/graph.h"

#include <algorithm>

namespace alidade::meshing {
namespace {

/// By children, clips, bounds, lights and skins.
std::vector<bool> reached(const Scene& scene) {
    std::vector<bool> out(scene.nodes.size());
    std::vector<NodeId> open;
    const auto reach = [&](NodeId id) {
        if (!out[id.index]) out[id.index] = true, open.push_back(id);
    };
    for (const NodeId root : scene.roots) reach(root);
    for (const Skin& skin : scene.skins) std::for_each(skin.joints.begin(), skin.joints.end(), reach);
    while (!open.empty()) {
        const Node& node = scene.nodes[open.back().index];
        open.pop_back();
        for_each_link(scene, node, reach);
    }
    return out;
}

}  // namespace

Scene without_unreached(Scene scene, const Scene& before) {
    const std::vector<bool> was = reached(before), is = reached(scene);
    std::vector<NodeId> renamed(scene.nodes.size());
    uint32_t count = 0;
    for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (was[i] && !is[i]) continue;
        renamed[i] = NodeId{count};
        if (i != count) scene.nodes[count] = std::move(scene.nodes[i]);
        ++count;
    }
    scene.nodes.resize(count);
    const auto rename = [&](NodeId& id) { id = renamed[id.index]; };
    const auto rename_all = [&](std::vector<NodeId>& ids) { std::for_each(ids.begin(), ids.end(), rename); };
    rename_all(scene.roots);
    for (Node& node : scene.nodes) rename_all(node.children), rename_all(node.clips), rename_all(node.bounds);
    for (Skin& skin : scene.skins) rename_all(skin.joints);
    for (Light& light : scene.lights) {
        if (light.looks_like) rename(*light.looks_like);
        if (light.projected_through) rename(*light.projected_through);
    }
    for (Animation& animation : scene.animations) {
        std::erase_if(animation.channels, [&](const Channel& channel) { return was[channel.target.index] && !is[channel.target.index]; });
        for (Channel& channel : animation.channels) rename(channel.target);
    }
    std::erase_if(scene.animations, [](const Animation& animation) { return animation.channels.empty(); });
    return scene;
}

}  // namespace alidade::meshing
