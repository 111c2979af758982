// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's surfaces: layers of pigment and finish at a point. The formulas are those of its reference, 3.4.3.3 "Finish", with what probing found
/// where that is silent; colours are calculated with as the scene gives them, before any gamma.
#pragma once

#include "tracer/surface.h"

namespace alidade {

/// A layer at a point, from the top.
struct PovLayer {
    const PovFinish* finish = nullptr;
    Color color{0};
    double opacity = 1;
    Color above{1};             ///< what all layers above let through
};

class PovSurface {
  public:
    /// `dir` is the unit direction of the ray, `normal` the shading normal on the side of the eye.
    PovSurface(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir, const Vec3& normal);

    Color emitted(const Color& ambient_light) const;
    /// Light from the unit direction `wi`, diffuse and in highlights.
    Color scatter(const Vec3& wi, bool highlights) const;
    /// The mirror and the transmitted ray. `facing` is the geometric normal on the side of the eye.
    void secondary(const CompiledScene& scene, const ShadePoint& point, const RayState& state, const Vec3& facing, Secondaries& out) const;
    const Color& top_color() const { return layers_.front().color; }

  private:
    Color lit(const PovLayer& layer, const Vec3& wi, double nl, bool highlights) const;
    void add_reflection(const CompiledScene& scene, const RayState& state, double relative_ior, const Vec3& facing, Secondaries& out) const;

    std::vector<PovLayer> layers_;
    Color through_{1};          ///< what all layers let through
    Vec3 dir_, normal_;
    bool double_illuminate_ = false;
};

/// What the layers of a material let through at a point: what shadow rays multiply by.
Color pov_transmitted(const CompiledScene& scene, const Material& material, const ShadePoint& point);

}  // namespace alidade
