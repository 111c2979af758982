// SPDX-License-Identifier: Apache-2.0
/// One accelerator, placed many times: a PrimitiveSet for the accelerator above it.
#pragma once

#include "accel/accelerator.h"
#include "core/transform.h"

namespace alidade {

class StressInstances : public PrimitiveSet {
  public:
    /// Transforms that cannot be inverted are left out of every ray. `mesh` must live as long.
    StressInstances(const Accelerator& mesh, std::span<const Transform> places);

    size_t size() const override { return places_.size(); }
    Bounds bounds(uint32_t id) const override { return places_[id].bounds; }
    bool intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const override;
    bool occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const override;
    void all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const override;

    const Transform& place(uint32_t id) const { return places_[id].to_world; }

  private:
    struct Place {
        Transform to_world, to_mesh;
        Bounds bounds;   ///< in the world; empty if it is left out
    };

    const Accelerator& mesh_;
    std::vector<Place> places_;
};

}  // namespace alidade
