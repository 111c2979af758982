// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/transform.h"
#include "scene/light.h"

namespace alidade {

/// What a light sends to a point.
struct Illumination {
    Vec3 direction{0};     ///< unit, from the point to the light
    double distance = 0;   ///< infinite for directional lights
    Color irradiance{0};   ///< W/m^2 on a surface that faces the light; for a sampled light an estimate of it
};

/// A light in world space.
struct PlacedLight {
    Light light;
    Transform to_world;
    Vec3 position{0};
    Vec3 axis{0, 0, -1};   ///< unit, where it points
    double cos_inner = 1, cos_outer = 1;   ///< of the angles of a cone, from its axis
    LightId id;
    bool from_its_place = false;   ///< light comes from `position` alone, or from points around it that are not asked apart

    PlacedLight() = default;
    PlacedLight(Light l, const Transform& t);
    /// Has it an extent, so that many of its points have to be asked?
    bool sampled() const { return std::holds_alternative<AreaLight>(light.kind); }
};

/// Light on `point`, shadows aside; black where none can arrive. `square` in [0, 1)^2 chooses the point of a sampled light.
/// Source   KHR_lights_punctual: inverse square law, range window, spot cone.
Illumination illuminate(const PlacedLight& light, const Vec3& point, const Vec2& square);

}  // namespace alidade
