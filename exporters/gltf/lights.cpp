// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/lights.h"

#include "exporters/gltf/merged_cones.h"
#include "exporters/shown_nodes.h"
#include "scene/queries.h"

namespace alidade::gltf_export {

namespace {

constexpr double kLumenPerWatt = 683;

/// The extension wants 0 <= inner < outer <= pi / 2.
Json spot_json(const SpotLight& spot, Losses& losses) {
    const double outer = std::clamp(spot.outer_angle, 1e-6, kPi / 2);
    losses.add("spot lights wider than a half space", spot.outer_angle > kPi / 2, "a half space");
    const double inner = std::clamp(spot.inner_angle, 0.0, std::nextafter(outer, 0.0));
    return {{"innerConeAngle", inner}, {"outerConeAngle", outer}};
}

bool is_parallel(const Light& light) {
    return light.parallel || std::holds_alternative<DirectionalLight>(light.kind) || std::holds_alternative<CylinderLight>(light.kind);
}

}  // namespace

/// A surface of POV-Ray's reflects pigment x diffuse x brightness x cosine; one of glTF's base colour / pi x intensity / distance^2 x cosine.
double LightWriter::strength_at_middle(LightId id) {
    const Light& light = scene_.lights[id.index];
    if (distances_.empty()) {
        const Bounds box = world_bounds(scene_);
        const Vec3 middle = box.finite() && !box.empty() ? box.center() : Vec3(0);
        visit_shown_nodes(scene_, [&](NodeId node, const Transform& to_world) {
            if (const auto* at = std::get_if<LightId>(&scene_.nodes[node.index].what)) distances_.emplace(*at, length(to_world.translation - middle));
            return true;
        });
    }
    const auto found = distances_.find(id);
    const double distance = found != distances_.end() && found->second > 0 && std::isfinite(found->second) ? found->second : 1;
    const double faded = light.fade ? 2 / (1 + std::pow(distance / light.fade->distance, light.fade->power)) : 1;
    return kPi * (std::isfinite(faded) ? faded : 1) * (is_parallel(light) ? 1 : distance * distance);
}

LightWriter::LightWriter(const Scene& scene, Document& document, Losses& losses) : scene_(scene), document_(document), losses_(losses), merged_(merged_cones(scene)) {}

std::optional<Json> LightWriter::write(LightId id) {
    const auto merged = merged_.find(id);
    if (merged != merged_.end() && !merged->second) return std::nullopt;
    const Light& light = merged != merged_.end() ? *merged->second : scene_.lights[id.index];
    const bool dark = std::min({light.intensity.x, light.intensity.y, light.intensity.z}) < 0;
    if (std::holds_alternative<AreaLight>(light.kind)) return losses_.add("area lights"), std::nullopt;
    if (dark || !is_finite(light.intensity)) return losses_.add("lights of negative or endless intensity"), std::nullopt;
    const bool own_law = light.fade || !light.inverse_square;
    losses_.add("lights that fade in a way of their own", own_law && !is_parallel(light), "the square of the distance, as bright at the middle of the scene");
    losses_.add("lights without shadows", light.shadowless, "shadows");
    losses_.add("areas of lights, for soft shadows", light.shadow_grid.has_value(), "points");
    losses_.add("shapes of lights", size_t(light.looks_like.has_value()) + light.projected_through.has_value());
    losses_.add("parallel lights that stand somewhere", light.parallel, "parallel light from infinitely far away");
    losses_.add("beams of parallel light", std::holds_alternative<CylinderLight>(light.kind), "parallel light from infinitely far away, everywhere");
    const double strength = max_component(light.intensity);
    Json json = Json::object();
    set(json, "name", light.name, std::string());
    json["type"] = is_parallel(light) ? "directional" : std::holds_alternative<PointLight>(light.kind) ? "point" : "spot";
    json["intensity"] = strength * (own_law ? strength_at_middle(id) : 1) * kLumenPerWatt;
    if (strength > 0) set(json, "color", light.intensity / strength, Vec3(1));
    if (is_parallel(light)) return json;
    if (std::isfinite(light.range) && light.range > 0) json["range"] = light.range;
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) json["spot"] = spot_json(*spot, losses_);
    if (const auto* cone = std::get_if<ConeLight>(&light.kind)) {
        losses_.add("cones of lights that fall off in a way of their own", 1, "glTF's");
        json["spot"] = spot_json({std::clamp(cone->radius, 0.0, kPi / 2), std::clamp(std::max(cone->falloff, cone->radius), 0.0, kPi / 2)}, losses_);
    }
    return json;
}

std::optional<size_t> LightWriter::add(LightId id) {
    const auto [known, added] = known_.try_emplace(id);
    if (!added) return known->second;
    if (auto json = write(id)) {
        Json& list = document_.use(document_.root, "KHR_lights_punctual")["lights"];
        list.push_back(std::move(*json));
        known->second = list.size() - 1;
    }
    return known->second;
}

}  // namespace alidade::gltf_export
