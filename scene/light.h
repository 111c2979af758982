// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/source.h"
#include "core/vec.h"
#include "scene/ids.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace alidade {

/// Radiant intensity falls with the square of the distance, unless `fade` says otherwise.
struct PointLight {};

/// A point light inside a cone about -z of its node. Between the angles (radians, from the axis) it falls to 0 as KHR_lights_punctual says.
struct SpotLight {
    double inner_angle = 0, outer_angle = kPi / 4;
};

/// Parallel light along -z of its node, from infinitely far away.
struct DirectionalLight {};

/// A rectangle in the xy plane of its node, `width` by `height`, or a disc or sphere of `radius`, radiating towards -z (a sphere: all round).
struct AreaLight {
    enum class Form { rectangle, disc, sphere } form = Form::rectangle;
    double width = 1, height = 1, radius = 0.5;
    int samples_u = 1, samples_v = 1;   ///< POV's area_light grid
    bool adaptive = false, jitter = false, circular = false, orient = false;
};

/// POV-Ray's attenuation 2 / (1 + (d / distance)^power) (manual, 3.4.7.9 "Light Fading"); absent in glTF, whose law is 1 / d^2.
struct LightFade {
    double distance = 0, power = 0;
};

struct Light {
    std::string name;
    std::variant<PointLight, SpotLight, DirectionalLight, AreaLight> kind;
    Color intensity{1};   ///< W/sr (point, spot), W/m^2 (directional), W/(sr m^2) (area), never candela or lux: importers convert; linear Rec.709
    double range = kInf;  ///< beyond it there is no light
    std::optional<LightFade> fade;
    bool inverse_square = true;
    bool shadowless = false, media_interaction = true;
    std::optional<NodeId> looks_like, projected_through;
    SourcePos from;
};

}  // namespace alidade
