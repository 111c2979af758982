// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/merged_cones.h"

#include "exporters/shown_nodes.h"

#include <algorithm>
#include <cmath>

namespace alidade::gltf_export {

namespace {

struct Group {
    Vec3 position, axis;
    std::vector<LightId> lights;
};

bool takes_light(const Light& light) { return std::min({light.intensity.x, light.intensity.y, light.intensity.z}) < 0; }

std::vector<Group> cones_by_place(const Scene& scene) {
    std::vector<Group> groups;
    visit_shown_nodes(scene, [&](NodeId node, const Transform& to_world) {
        const auto* id = std::get_if<LightId>(&scene.nodes[node.index].what);
        if (!id || !std::holds_alternative<ConeLight>(scene.lights[id->index].kind)) return true;
        const Vec3 position = to_world.translation, axis = normalized(to_world.linear[2]);
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.position == position && g.axis == axis; });
        (same != groups.end() ? *same : groups.emplace_back(Group{position, axis, {}})).lights.push_back(*id);
        return true;
    });
    return groups;
}

/// At the cosine `c` of the angle from the axis; Light::kind, ConeLight.
double brightness(const ConeLight& cone, double c) {
    const double outer = std::cos(cone.falloff), inner = std::cos(cone.radius);
    if (c < inner && !(c > outer)) return 0;
    return std::pow(c, cone.tightness) * (c < inner ? smooth_step((c - outer) / (inner - outer)) : 1);
}

/// glTF's rim has a quarter of the light halfway between its cosines: that is found in the sum.
Light nearest_spot(const Scene& scene, const std::vector<LightId>& lights) {
    Light spot = scene.lights[lights.front().index];
    spot.intensity = Color(0);
    double falloff = 0;
    const auto sum = [&](double c) {
        double all = 0;
        for (const LightId id : lights) all += luminance(scene.lights[id.index].intensity) * brightness(std::get<ConeLight>(scene.lights[id.index].kind), c);
        return all;
    };
    for (const LightId id : lights) {
        const Light& light = scene.lights[id.index];
        const ConeLight& cone = std::get<ConeLight>(light.kind);
        spot.intensity += light.intensity * brightness(cone, 1), falloff = std::max({falloff, cone.falloff, cone.radius});
    }
    const double outer = std::cos(std::min(falloff, kPi / 2)), quarter = sum(1) / 4;
    double dark = outer, bright = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (dark + bright) / 2;
        (sum(middle) < quarter ? dark : bright) = middle;
    }
    spot.kind = SpotLight{std::acos(std::min(outer + 2 * (bright - outer), 1.0)), std::acos(outer)};
    return spot;
}

}  // namespace

std::map<LightId, std::optional<Light>> merged_cones(const Scene& scene) {
    std::map<LightId, std::optional<Light>> merged;
    if (std::none_of(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return std::holds_alternative<ConeLight>(l.kind) && takes_light(l); })) return merged;
    for (const Group& group : cones_by_place(scene)) {
        if (std::none_of(group.lights.begin(), group.lights.end(), [&](LightId id) { return takes_light(scene.lights[id.index]); })) continue;
        const Light spot = nearest_spot(scene, group.lights);
        if (takes_light(spot)) continue;
        for (const LightId id : group.lights) merged[id] = std::nullopt;
        merged[group.lights.front()] = spot;
    }
    return merged;
}

}  // namespace alidade::gltf_export
