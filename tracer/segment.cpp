// SPDX-License-Identifier: Apache-2.0
#include "tracer/segment.h"

#include <algorithm>

namespace alidade {

Color transmittance(const CompiledScene& scene, const InteriorStack& inside, double length) {
    if (inside.empty()) return Color(1);
    const Interior& interior = scene.interiors[inside.top().interior];
    if (!std::isfinite(interior.attenuation_distance)) return Color(1);
    const double x = length / interior.attenuation_distance;
    const Color& c = interior.attenuation_color;
    return {std::pow(c.x, x), std::pow(c.y, x), std::pow(c.z, x)};
}

double ior_in(const CompiledScene& scene, const InteriorStack& inside) { return inside.empty() ? 1 : scene.interiors[inside.top().interior].ior; }

bool fog_reaches(const CompiledScene& scene, const InteriorStack& inside) {
    const auto entries = inside.entries();
    return std::all_of(entries.begin(), entries.end(), [&](const InteriorStack::Entry& e) { return scene.interiors[e.interior].hollow; });
}

Color pov_fade(const Interior& interior, double length) {
    if (!(interior.fade_distance > 0)) return Color(1);
    const Color& c = interior.fade_color;
    const double x = length / interior.fade_distance;
    if (interior.fade_power < 1000) return c + (Color(1) - c) / (1 + std::pow(x, interior.fade_power));
    return {std::exp((c.x - 1) * x), std::exp((c.y - 1) * x), std::exp((c.z - 1) * x)};
}

}  // namespace alidade
