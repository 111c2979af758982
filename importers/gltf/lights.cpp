// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/lights.h"

#include <charconv>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

constexpr double kLumenPerWatt = 683;

/// Was the file written by Blender's own exporter, version 3.4 or newer? Older ones wrote radiometric numbers.
bool blender_photometric(const std::string& generator) {
    constexpr std::string_view kName = "Khronos glTF Blender I/O v";
    if (generator.rfind(kName, 0) != 0) return false;
    int major = 0, minor = 0;
    const char* end = generator.data() + generator.size();
    const auto first = std::from_chars(generator.data() + kName.size(), end, major);
    if (first.ptr != end && *first.ptr == '.') std::from_chars(first.ptr + 1, end, minor);
    return major > 3 || (major == 3 && minor >= 4);
}

/// Alidade's own exporter writes what the extension asks for.
bool is_photometric(const std::string& generator) { return generator == "Alidade" || blender_photometric(generator); }

bool decide_units(const std::string& generator, LightUnitsOption option, RenderSettings& settings) {
    const bool known = is_photometric(generator);
    const bool photometric = option == LightUnitsOption::photometric || (option == LightUnitsOption::automatic && known);
    settings.light_units = photometric ? LightUnits::photometric : LightUnits::radiometric;
    if (option != LightUnitsOption::automatic) settings.why_light_units = "as asked for";
    else if (known) settings.why_light_units = fmt::format("\"{}\" writes candela and lux", generator);
    else settings.why_light_units = "nothing says that the file holds candela and lux";
    settings.why_light_units += photometric ? ": intensities are divided by 683 lm/W" : ": intensities are used as they are";
    return photometric;
}

SpotLight convert_spot(const tinygltf::SpotLight& from, const std::string& at, Reporter& report) {
    SpotLight spot{from.innerConeAngle, from.outerConeAngle};
    if (spot.inner_angle <= spot.outer_angle) return spot;
    report.warning(child(at, "spot"),
                   fmt::format("the inner angle {} is larger than the outer angle {}, which is used for both", spot.inner_angle, spot.outer_angle));
    spot.inner_angle = spot.outer_angle;
    return spot;
}

}  // namespace

std::vector<std::optional<LightId>> convert_lights(const Model& model, LightUnitsOption option, Scene& scene, Reporter& report) {
    std::vector<std::optional<LightId>> ids;
    if (model.lights.empty()) return ids;
    const double scale = decide_units(model.asset.generator, option, scene.settings) ? 1 / kLumenPerWatt : 1;
    for (const tinygltf::Light& from : model.lights) {
        const std::string at = child("/extensions/KHR_lights_punctual/lights", ids.size());
        Light light;
        if (from.type == "spot") light.kind = convert_spot(from.spot, at, report);
        else if (from.type == "directional") light.kind = DirectionalLight{};
        else if (from.type != "point") {
            report.not_understood(child(at, "type"), fmt::format("unknown type of light \"{}\": it is left out", from.type.substr(0, 100)));
            ids.emplace_back();
            continue;
        }
        light.name = from.name;
        light.intensity = Color(from.intensity * scale);
        if (from.color.size() == 3) light.intensity *= Color(from.color[0], from.color[1], from.color[2]);
        if (from.range > 0) light.range = from.range;
        light.from = report.at(at);
        ids.emplace_back(LightId{uint32_t(scene.lights.size())});
        scene.lights.push_back(std::move(light));
    }
    return ids;
}

}  // namespace alidade::gltf
