// SPDX-License-Identifier: Apache-2.0
#include "tracer/lights.h"

#include "tracer/sampler.h"

namespace alidade {
namespace {

/// 1 / d^2, and the smooth end of a light with a range (KHR_lights_punctual, "Range Property").
double falloff(const Light& light, double distance) {
    double k = light.inverse_square ? 1 / (distance * distance) : 1;
    if (std::isfinite(light.range)) {
        const double x = distance / light.range, x2 = x * x;
        k *= std::clamp(1 - x2 * x2, 0.0, 1.0);
    }
    if (light.fade) k *= 2 / (1 + std::pow(distance / light.fade->distance, light.fade->power));
    return k;
}

/// KHR_lights_punctual, "Inner and Outer Cone Angles".
double cone(const PlacedLight& light, double cos_axis) {
    const double x = std::clamp((cos_axis - light.cos_outer) / std::max(1e-3, light.cos_inner - light.cos_outer), 0.0, 1.0);
    return x * x;
}

/// POV-Ray's spotlight: the brightness at the cosine `c` of the angle from its axis.
double cone(const PlacedLight& light, const ConeLight& spot, double c) {
    if (c <= 0) return 0;
    double k = spot.tightness == 0 ? 1 : std::pow(c, spot.tightness);
    const double inner = light.cos_inner, outer = light.cos_outer;
    if (inner > 0 && c < inner) {
        const double u = outer < inner ? std::clamp((c - outer) / (inner - outer), 0.0, 1.0) : 0;
        k *= smooth_step(u);
    }
    return k;
}

/// POV-Ray's cylinder of light: the brightness at a point that lies `from_light` of it.
double cylinder(const CylinderLight& c, const Vec3& from_light, const Vec3& axis) {
    const double along = dot(from_light, axis), distance = length(from_light - axis * along);
    if (!(along > 0) || !(distance < c.falloff)) return 0;
    const double q = 1 - distance / c.falloff, inner = 1 - c.radius / c.falloff;
    const double k = c.tightness == 0 ? 1 : std::pow(q, c.tightness);
    return distance > c.radius ? k * smooth_step(q / inner) : k;
}

/// Light that goes along the axis everywhere, from the plane through its place.
Illumination along_axis(const PlacedLight& light, const Vec3& to_light) {
    const double along = -dot(to_light, light.axis);
    double k = falloff(light.light, std::abs(along));
    if (const auto* round = std::get_if<CylinderLight>(&light.light.kind)) k *= cylinder(*round, -to_light, light.axis);
    return {-light.axis, along, light.light.intensity * k};
}

/// A point of a flat light, uniform in area; light leaves its front only. The irradiance is L cos A / d^2.
Illumination from_flat(const PlacedLight& light, const AreaLight& area, const Vec3& point, const Vec2& square) {
    const bool disc = area.form == AreaLight::Form::disc;
    const Vec3 half_x = light.to_world.vector({disc ? area.radius : area.width / 2, 0, 0}), half_y = light.to_world.vector({0, disc ? area.radius : area.height / 2, 0});
    const Vec2 at = disc ? concentric_disc(square) : square * 2.0 - Vec2(1);
    const Vec3 to_light = light.position + half_x * at.x + half_y * at.y - point, normal = cross(half_x, half_y);
    const double distance = length(to_light);
    if (!(distance > 0)) return {};
    const double front = -dot(to_light / distance, light.axis), size = length(normal) * (disc ? kPi : 4);
    if (front <= 0) return {};
    return {to_light / distance, distance, light.light.intensity * (front * size / (distance * distance))};
}

/// A direction into the cone that a sphere fills, uniform in solid angle: the irradiance is L times that angle, whatever the direction.
Illumination from_sphere(const PlacedLight& light, const AreaLight& area, const Vec3& point, const Vec2& square) {
    const double radius = area.radius * length(light.to_world.vector({1, 0, 0}));
    const Vec3 to_centre = light.position - point;
    const double distance = length(to_centre);
    if (!(distance > radius)) return {};
    const double ratio = radius / distance, cap = ratio * ratio / (1 + std::sqrt(1 - ratio * ratio));   // 1 - cos(half angle), without cancellation
    const double z = 1 - square.x * cap, r = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * kPi * square.y;
    Vec3 s, t;
    const Vec3 axis = to_centre / distance;
    orthonormal_basis(axis, s, t);
    const Vec3 direction = normalized(axis * z + (s * std::cos(phi) + t * std::sin(phi)) * r);
    const double along = dot(to_centre, direction), chord = std::max(0.0, radius * radius - (distance * distance - along * along));
    return {direction, along - std::sqrt(chord), light.light.intensity * (2 * kPi * cap)};
}

}  // namespace

PlacedLight::PlacedLight(Light l, const Transform& t) : light(std::move(l)), to_world(t), position(t.translation), axis(normalized(t.vector(Vec3(0, 0, -1)))) {
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) cos_inner = std::cos(spot->inner_angle), cos_outer = std::cos(spot->outer_angle);
    if (const auto* spot = std::get_if<ConeLight>(&light.kind)) cos_inner = std::cos(spot->radius), cos_outer = std::cos(spot->falloff);
    const bool along_axis = light.parallel || std::holds_alternative<CylinderLight>(light.kind) || std::holds_alternative<DirectionalLight>(light.kind);
    from_its_place = !along_axis && !sampled() && !(light.shadow_grid && light.shadow_grid->illuminates);
}

Illumination illuminate(const PlacedLight& light, const Vec3& point, const Vec2& square) {
    if (std::holds_alternative<DirectionalLight>(light.light.kind)) return {-light.axis, kInf, light.light.intensity};
    if (const auto* area = std::get_if<AreaLight>(&light.light.kind))
        return area->form == AreaLight::Form::sphere ? from_sphere(light, *area, point, square) : from_flat(light, *area, point, square);
    const Vec3 to_light = light.position - point;
    const double distance = length(to_light);
    if (!(distance > 0)) return {};
    if (light.light.parallel || std::holds_alternative<CylinderLight>(light.light.kind)) return along_axis(light, to_light);
    const Vec3 direction = to_light / distance;
    double k = falloff(light.light, distance);
    if (std::holds_alternative<SpotLight>(light.light.kind)) k *= cone(light, -dot(direction, light.axis));
    if (const auto* spot = std::get_if<ConeLight>(&light.light.kind)) k *= cone(light, *spot, -dot(direction, light.axis));
    return {direction, distance, light.light.intensity * k};
}

}  // namespace alidade
