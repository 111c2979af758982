// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"

#include <map>

namespace alidade {

/// Instances as leaves of solids. Rays and points are world-space.
class InstanceLeaves final : public CsgLeaves {
  public:
    /// Both must outlive the leaves.
    InstanceLeaves(const CompiledScene& scene, WorkCounters& work) : scene_(scene), work_(work) {}
    bool crossings(uint32_t instance, const Ray& ray, std::vector<CsgCrossing>& out) const override;
    bool inside(uint32_t instance, const Vec3& point) const override;
    bool sees(uint32_t instance, const Ray& ray) const override;
    Sharpness sharpness(const Ray& ray, const Hit& hit) const override;

  private:
    const CompiledScene& scene_;
    WorkCounters& work_;
};

/// The instance as a leaf: what tells where it is inside, and its world-space box.
CsgLeaf csg_leaf(const CompiledScene& scene, uint32_t instance);

/// A world-space box around what is inside of the instance, turned inside out or not, within a box whose sides may be infinite (CsgNarrow).
Bounds narrowed_leaf(const CompiledScene& scene, uint32_t instance, bool inverted, const Bounds& box);

/// The space of a solid, and where in it those of its instances stand that have no end.
struct SolidSpace {
    Transform to_world;
    std::map<uint32_t, Transform> endless;
};
/// Boxes there. Both must outlive what is returned.
CsgOwnSpace own_space(const CompiledScene& scene, const SolidSpace& space);

/// What a plane fills of the world (CsgHalfSpaces).
std::optional<HalfSpace> half_space(const CompiledScene& scene, uint32_t instance);

}  // namespace alidade
