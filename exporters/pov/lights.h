// SPDX-License-Identifier: Apache-2.0
/// Lights -> light_source.
#pragma once

#include "exporters/losses.h"
#include "exporters/pov/sdl.h"

namespace alidade::pov_export {

/// Lights whose intensity falls by 1 / d^2 get POV-Ray's fading, 2 / (1 + (d / fade_distance)^2), with a fade_distance of kNear times the size of the scene:
/// at a distance d they are too dark by the factor 1 + (fade_distance / d)^2. An irradiance E on a white surface is a light of colour E / pi.
class LightWriter {
  public:
    LightWriter(const Scene& scene, Sdl& sdl, Losses& losses);

    /// How many of POV-Ray's lights it takes to be like it: that of a spot is a sum.
    static size_t parts(const Light& light);
    /// `light_source { ...` of a part, placed by `to_parent` and left open for modifiers.
    void begin(const Light& light, const Transform& to_parent, size_t part = 0);
    /// A light from infinitely far away stands outside of the scene. `to_world`: of its node.
    void write_directional(const Light& light, const Transform& to_world);
    /// The light of a scene that has none: the sky is told to others.
    void write_default_sun(const Camera& camera);

  private:
    void kind(const Light& light, const Transform& to_parent, size_t part);
    void fade(const Light& light);
    void grid(const Light& light, const Transform& to_parent);
    Expression colour(const Light& light, size_t part) const;
    void tell_losses(const Light& light);

    Sdl& sdl_;
    Losses& losses_;
    double near_ = 1e-4, size_ = 10;
    Vec3 centre_{0};
};

}  // namespace alidade::pov_export
