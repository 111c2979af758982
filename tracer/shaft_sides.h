// SPDX-License-Identifier: Apache-2.0
/// On which sides of surfaces all rays between two boxes are.
#pragma once

#include "accel/shaft.h"
#include "tracer/shade_point.h"

namespace alidade {

/// Rays that spawn_ray() makes from a point to somewhere in a box, as a region for CsgTree::sides().
class ShaftSides final : public CsgRegion {
  public:
    /// All must outlive it. `shaft` holds the rays.
    ShaftSides(const CompiledScene& scene, const ShadePoint& point, const Shaft& shaft) : scene_(scene), point_(point), shaft_(shaft) {}
    bool meets(const Bounds& box) const override { return shaft_.meets(box); }
    CsgSide side(uint32_t instance) const override;

  private:
    CsgSide of_plane(uint32_t id, const Plane& plane, const Bounds& from, const Bounds& to) const;

    const CompiledScene& scene_;
    const ShadePoint& point_;
    const Shaft& shaft_;
};

}  // namespace alidade
