// SPDX-License-Identifier: Apache-2.0
/// On which sides of surfaces all rays between two boxes are.
#pragma once

#include "accel/shaft.h"
#include "tracer/shade_point.h"

namespace alidade {

/// The rays of a shaft as a region for CsgTree::sides().
class ShaftSides final : public CsgRegion {
  public:
    /// Both must outlive it. `stood_on`: an instance that the rays start on, and that they leave for good if it is a plane, also as a part of a solid; there none of their crossings that count may be
    /// so near to their start that it is one place with that (CsgTree).
    ShaftSides(const CompiledScene& scene, const Shaft& shaft, uint32_t stood_on = kNoId) : scene_(scene), shaft_(shaft), stood_on_(stood_on) {}
    bool meets(const Bounds& box) const override { return shaft_.meets(box); }
    CsgSide side(uint32_t instance) const override;
    /// Do the rays surely leave the instance, if that is a plane on which they start? They cannot come back (spawn_ray).
    bool leaves_plane(uint32_t instance) const;

  private:
    const CompiledScene& scene_;
    const Shaft& shaft_;
    uint32_t stood_on_;
};

}  // namespace alidade
