// SPDX-License-Identifier: Apache-2.0
#include "tracer/segment.h"

namespace alidade {

Color transmittance(const CompiledScene& scene, const InteriorStack& inside, double length) {
    if (inside.empty()) return Color(1);
    const Interior& interior = scene.interiors[inside.top().interior];
    if (!std::isfinite(interior.attenuation_distance)) return Color(1);
    const double x = length / interior.attenuation_distance;
    const Color& c = interior.attenuation_color;
    return {std::pow(c.x, x), std::pow(c.y, x), std::pow(c.z, x)};
}

}  // namespace alidade
