// SPDX-License-Identifier: Apache-2.0
/// Materials in the form that files have for them: numbers, each with at most one picture.
#pragma once

#include "exporters/losses.h"

namespace alidade {

/// factor x picture, or factor alone; of the picture all channels, or one in all four.
struct Texel {
    Vec4 factor{1};
    std::optional<ImageSignal> picture;
    int channel = -1;                       ///< -1: all

    bool is_constant(double value) const { return !picture && Vec3(factor) == Vec3(value); }
};

/// The signal as a Texel; of patterns, functions and products of pictures the mean colour is left, as near as it can be told without looking.
Texel texel(const Scene& scene, SignalId signal, Losses& losses);

/// A metal-rough surface; absent values have no effect.
struct PlainSurface {
    Texel base_color, metallic, roughness;
    std::optional<Texel> normal, occlusion, emissive, transmission, specular, specular_color, clearcoat, clearcoat_roughness, clearcoat_normal;
    double normal_scale = 1, emissive_strength = 1, alpha_cutoff = 0.5, ior = 1.5;
    AlphaMode alpha_mode = AlphaMode::opaque;
    bool double_sided = false, unlit = false;
};

/// The surface of a material: its lowest layer, others are lost; of a POV-Ray finish its pigment, emission and plain reflection.
PlainSurface plain_surface(const Scene& scene, const Material& material, Losses& losses);

}  // namespace alidade
