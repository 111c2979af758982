// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/accessors.h"

namespace alidade::gltf {

/// Appends the lights of KHR_lights_punctual to `scene`; returns the id of each, or nothing for those of an unknown type.
///
/// Units    Light::intensity is radiometric, always: W/sr, or W/m^2 for directional lights. KHR_lights_punctual means candela and lux, which
///          are 683 times as large (the luminous efficacy of 555 nm light, lm/W, which exporters use for white); but most writers put radiometric or
///          arbitrary numbers there. So intensities are divided by 683 if `option` is photometric; not if it is raw; and if it is automatic,
///          only if the file was written by Blender's exporter 3.4 or newer ("Khronos glTF Blender I/O v3.4.50" writes 683 W/sr as 466489 cd), or by Alidade.
///          RenderSettings::why_light_units says which and why.
/// Source   measured: Blender 3.4.1 exports a point light of 1000 W as 54351.4 = 1000 / (4 pi) * 683, a sun of strength 1.5 as 1024.5.
std::vector<std::optional<LightId>> convert_lights(const Model& model, LightUnitsOption option, Scene& scene, Reporter& report);

}  // namespace alidade::gltf
