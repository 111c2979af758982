// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/lights.h"

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

}  // namespace

std::optional<Json> LightWriter::write(const Light& light) {
    const double strength = max_component(light.intensity);
    const bool dark = std::min({light.intensity.x, light.intensity.y, light.intensity.z}) < 0;
    if (std::holds_alternative<AreaLight>(light.kind)) return losses_.add("area lights"), std::nullopt;
    if (dark || !is_finite(light.intensity)) return losses_.add("lights of negative or endless intensity"), std::nullopt;
    losses_.add("lights that fade in a way of their own", light.fade || !light.inverse_square, "the square of the distance");
    losses_.add("lights without shadows", light.shadowless, "shadows");
    losses_.add("shapes of lights", size_t(light.looks_like.has_value()) + light.projected_through.has_value());
    Json json = Json::object();
    set(json, "name", light.name, std::string());
    if (light.parallel) losses_.add("parallel lights that stand somewhere");
    json["type"] = std::holds_alternative<PointLight>(light.kind) ? "point" : std::holds_alternative<DirectionalLight>(light.kind) ? "directional" : "spot";
    json["intensity"] = strength * kLumenPerWatt;
    if (strength > 0) set(json, "color", light.intensity / strength, Vec3(1));
    if (std::isfinite(light.range) && light.range > 0 && !std::holds_alternative<DirectionalLight>(light.kind)) json["range"] = light.range;
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) json["spot"] = spot_json(*spot, losses_);
    if (const auto* cone = std::get_if<ConeLight>(&light.kind)) {
        losses_.add("cones of lights that fall off in a way of their own", true, "glTF's");
        json["spot"] = spot_json({std::clamp(cone->radius, 0.0, kPi / 2), std::clamp(std::max(cone->falloff, cone->radius), 0.0, kPi / 2)}, losses_);
    }
    return json;
}

std::optional<size_t> LightWriter::add(LightId id) {
    const auto [known, added] = known_.try_emplace(id);
    if (!added) return known->second;
    if (auto json = write(scene_.lights[id.index])) {
        Json& list = document_.use(document_.root, "KHR_lights_punctual")["lights"];
        list.push_back(std::move(*json));
        known->second = list.size() - 1;
    }
    return known->second;
}

}  // namespace alidade::gltf_export
