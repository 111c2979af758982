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

/// A point light inside POV-Ray's cone about -z of its node: brightness cos(a)^tightness at the angle a from the axis; between `radius` and `falloff`
/// (radians) it falls to 0 by 3u^2 - 2u^3 of the cosine. Source   POV-Ray 3.7 reference, 3.4.4.3 "Spotlights"; verified by probing.
struct ConeLight {
    double radius = kPi / 6, falloff = kPi / 4, tightness = 0;
};

/// Parallel light in a cylinder about -z of its node: outside of `radius` (world units) it falls to 0 at `falloff`, by (1 - distance / falloff)^tightness and 3u^2 - 2u^3.
/// Source   POV-Ray 3.7 reference, 3.4.4.4 "Cylindrical Lights"; verified by probing.
struct CylinderLight {
    double radius = 0.75, falloff = 1, tightness = 0;
};

/// Parallel light along -z of its node, from infinitely far away.
struct DirectionalLight {};

/// A rectangle in the xy plane of its node, `width` by `height`, or a disc or sphere of `radius`, radiating towards -z (a sphere: all round).
struct AreaLight {
    enum class Form { rectangle, disc, sphere } form = Form::rectangle;
    double width = 1, height = 1, radius = 0.5;
};

/// POV-Ray's area_light: a grid of points on the parallelogram of `axis1` and `axis2` (in the space of its node) around the light. Shadow rays go to them, those of a parallel light from (0, 0, -1) of the node; everything else comes from the light's centre.
/// Source   POV-Ray 3.7 reference, 3.4.4.6 "Area Lights"; verified by probing.
struct ShadowGrid {
    Vec3 axis1{1, 0, 0}, axis2{0, 1, 0};
    int size1 = 1, size2 = 1;           ///< points along each axis
    int adaptive = -1;                  ///< a part of the grid is divided so often whatever its corners see; below 0: always
    bool jitter = false, circular = false, orient = false;
    bool illuminates = false;           ///< area_illumination: the light itself comes from the points, too
};

/// POV-Ray's attenuation 2 / (1 + (d / distance)^power) (manual, 3.4.7.9 "Light Fading"); absent in glTF, whose law is 1 / d^2.
struct LightFade {
    double distance = 0, power = 0;
};

struct Light {
    std::string name;
    std::variant<PointLight, SpotLight, DirectionalLight, AreaLight, ConeLight, CylinderLight> kind;
    Color intensity{1};   ///< W/sr (point, spot), W/m^2 (directional), W/(sr m^2) (area), never candela or lux: importers convert; linear Rec.709
    double range = kInf;  ///< beyond it there is no light
    std::optional<LightFade> fade;
    std::optional<ShadowGrid> shadow_grid;
    bool inverse_square = true;
    bool parallel = false;   ///< POV's `parallel`: light goes along -z of the node, from the plane through it
    bool shadowless = false, media_interaction = true;
    double clearance = 0;    ///< nothing nearer to the light than this hides it (POV-Ray: 0.001)
    std::optional<NodeId> looks_like;
    std::optional<NodeId> projected_through;   ///< POV: in the space of the light's node; light comes through its first surface alone, and nothing behind that hides it
    SourcePos from;
};

}  // namespace alidade
