// SPDX-License-Identifier: Apache-2.0
/// Accelerators, placed any number of times: a PrimitiveSet for the accelerator above them.
#pragma once

#include "stress/scene.h"

namespace alidade {

class StressInstances : public PrimitiveSet {
  public:
    /// The places of `scene`. Transforms that cannot be inverted are left out of every ray. The accelerators, one a mesh, must live as long.
    StressInstances(std::vector<const Accelerator*> meshes, const StressScene& scene);

    size_t size() const override { return places_.size(); }
    Bounds bounds(uint32_t id) const override { return places_[id].bounds; }
    bool intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const override;
    bool occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const override;
    void all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const override;

    /// Of what stands here; the accelerators' are not in it.
    size_t bytes() const { return places_.capacity() * sizeof(Place) + meshes_.capacity() * sizeof(meshes_[0]); }

  private:
    struct Place {
        Transform to_mesh;
        Bounds bounds;   ///< in the world; empty if it is left out
        uint32_t mesh = 0;
    };
    const Accelerator& mesh(uint32_t id) const { return *meshes_[places_[id].mesh]; }

    std::vector<const Accelerator*> meshes_;
    std::vector<Place> places_;
};

}  // namespace alidade
