// SPDX-License-Identifier: Apache-2.0
#include "scene/validation.h"

namespace alidade {

namespace {

/// What is wrong with the form of a light, or nothing.
std::string fault(const PointLight&) { return {}; }
std::string fault(const DirectionalLight&) { return {}; }
std::string fault(const SpotLight& spot) {
    if (!(spot.inner_angle >= 0) || !(spot.outer_angle <= kPi) || !(spot.inner_angle <= spot.outer_angle))
        return fmt::format("has a cone from {} to {} radians: 0 <= inner <= outer <= pi must hold", spot.inner_angle, spot.outer_angle);
    return {};
}
std::string fault(const ConeLight& cone) {
    return is_finite(Vec3(cone.radius, cone.falloff, cone.tightness)) ? std::string() : "has a cone with a number that is not finite";
}
std::string fault(const AreaLight& area) {
    if (area.form == AreaLight::Form::rectangle) {
        if (!(area.width >= 0 && std::isfinite(area.width) && area.height >= 0 && std::isfinite(area.height)))
            return fmt::format("has the size {} by {}", area.width, area.height);
    } else if (!(area.radius >= 0 && std::isfinite(area.radius))) {
        return fmt::format("has the radius {}", area.radius);
    }
    return {};
}
std::string fault(const CylinderLight& cylinder) {
    return is_finite(Vec3(cylinder.radius, cylinder.falloff, cylinder.tightness)) ? std::string() : "has a cylinder with a number that is not finite";
}

std::string fault(const ShadowGrid& grid) {
    if (!is_finite(grid.axis1) || !is_finite(grid.axis2)) return "has a grid whose axes are not finite";
    if (grid.size1 < 1 || grid.size2 < 1) return fmt::format("has a grid of {} by {} points", grid.size1, grid.size2);
    return {};
}

void check_light(Validation& v, const Light& light, const Label& who) {
    if (!is_finite(light.intensity)) v.error(light.from, who.text() + " has an intensity that is not finite");
    if (!(light.range > 0)) v.error(light.from, fmt::format("{} has the range {}: it must be greater than 0", who.text(), light.range));
    if (light.fade && !(std::isfinite(light.fade->distance) && std::isfinite(light.fade->power)))
        v.error(light.from, who.text() + " fades by a number that is not finite");
    const std::string form = std::visit([](const auto& kind) { return fault(kind); }, light.kind);
    if (!form.empty()) v.error(light.from, who.text() + " " + form);
    const std::string grid = light.shadow_grid ? fault(*light.shadow_grid) : std::string();
    if (!grid.empty()) v.error(light.from, who.text() + " " + grid);
}

void check_camera(Validation& v, const Camera& c, const Label& who) {
    if (!is_finite(c.location) || !is_finite(c.direction) || !is_finite(c.right) || !is_finite(c.up) || !is_finite(c.focal_point) ||
        !is_finite(Vec3(c.angle, c.vertical_angle, c.aperture)) || !std::isfinite(c.clearance))
        return v.error(c.from, who.text() + " has a number that is not finite");
    if (c.aperture < 0) v.error(c.from, fmt::format("{} has the aperture {}: it cannot be negative", who.text(), c.aperture));
    if (c.cylinder < 1 || c.cylinder > 4) v.error(c.from, fmt::format("{} has the cylinder {}: there are 1 to 4", who.text(), c.cylinder));
    if (c.blur_samples < 0) v.error(c.from, fmt::format("{} has {} blur samples", who.text(), c.blur_samples));
    // Of unit vectors: a wide or a long lens is no fault.
    if (dot(normalized(c.direction), cross(normalized(c.right), normalized(c.up))) == 0)
        v.warning(c.from, who.text() + " has its right, up and direction in one plane: its picture is a line at the most");
}

}  // namespace

void check_lights_and_cameras(Validation& v) {
    for (size_t i = 0; i < v.scene.lights.size(); ++i) check_light(v, v.scene.lights[i], label("light", i, v.scene.lights[i].name));
    for (size_t i = 0; i < v.scene.cameras.size(); ++i) check_camera(v, v.scene.cameras[i], label("camera", i, v.scene.cameras[i].name));
}

void check_atmosphere(Validation& v) {
    const Atmosphere& a = v.scene.atmosphere;
    if (!is_finite(a.background)) v.error({}, "the background has a number that is not finite");
    if ((a.environment && !is_finite(*a.environment)) || !std::isfinite(a.environment_strength))
        v.error({}, "the environment has a number that is not finite");
    for (const Fog& fog : a.fogs) {
        const Turbulence t = fog.turbulence.value_or(Turbulence());
        if (!is_finite(fog.color) || !is_finite(Vec3(fog.filter, fog.transmit, fog.turbulence_depth)) || !is_finite(fog.up) || !is_finite(Vec3(fog.distance, fog.offset, fog.altitude)) ||
            !is_finite(t.amount) || !std::isfinite(t.omega) || !std::isfinite(t.lambda))
            v.error({}, "a fog has a number that is not finite");
    }
    for (const Rainbow& r : a.rainbows)
        if (!is_finite(r.direction) || !is_finite(r.up) || !is_finite(Vec3(r.angle, r.width, r.distance)) || !is_finite(Vec3(r.arc_angle, r.falloff_angle, 0)))
            v.error({}, "a rainbow has a number that is not finite");
    if (a.sky && (!a.sky->transform.is_finite() || !is_finite(a.sky->emission))) v.error({}, "the sky has a number that is not finite");
    check_media(v, a.media, {}, label("the atmosphere"));
    const RenderSettings& r = v.scene.settings;
    if (!std::isfinite(r.adc_bailout) || !std::isfinite(r.shadow_clearance) || !std::isfinite(r.assumed_gamma) || !is_finite(r.ambient_light) || !is_finite(r.irid_wavelength))
        v.error({}, "the render settings have a number that is not finite");
    if (r.shadow_clearance < 0) v.error({}, "the clearance of shadows is negative");
    if (const auto& lens = r.lens_noise; lens && !(std::isfinite(lens->variance) && lens->confidence > 0 && lens->confidence < 1))
        v.error({}, "the noise of a lens has a variance that is not finite, or a confidence that is not between 0 and 1");
}

}  // namespace alidade
