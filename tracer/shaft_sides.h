// SPDX-License-Identifier: Apache-2.0
/// On which sides of surfaces all rays between two boxes are.
#pragma once

#include "accel/shaft.h"
#include "tracer/shade_point.h"

namespace alidade {

/// The rays of a shaft as a region for CsgTree::sides().
class ShaftSides final : public CsgRegion {
  public:
    /// Both must outlive it.
    ShaftSides(const CompiledScene& scene, const Shaft& shaft) : scene_(scene), shaft_(shaft) {}
    bool meets(const Bounds& box) const override { return shaft_.meets(box); }
    CsgSide side(uint32_t instance) const override;
    /// Do the rays surely leave the instance, if that is a plane on which they start? They cannot come back (spawn_ray). Not for parts of solids: there, crossings at the start are one place with
    /// those of other parts (CsgTree).
    bool leaves_plane(uint32_t instance) const;

  private:
    const CompiledScene& scene_;
    const Shaft& shaft_;
};

}  // namespace alidade
