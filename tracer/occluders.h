// SPDX-License-Identifier: Apache-2.0
/// What can stand between a point and a light with an extent: found once, asked by every shadow ray of the point.
#pragma once

#include "tracer/shade_point.h"

namespace alidade {

class Occluders {
  public:
    /// All that shadow rays from `point` to somewhere in the box `to` can meet. False if that is too much to be asked one by one; then nothing else may be called.
    bool find(const CompiledScene& scene, const ShadePoint& point, const Bounds& to);
    /// As Accelerator::occluded, of rays that spawn_ray() makes from the point to somewhere in the box. What hid the light from the last ray is asked first.
    bool occluded(const CompiledScene& scene, const Ray& ray, WorkCounters& work);
    bool none() const { return all_.empty(); }
    /// As Accelerator::all_hits.
    void all_hits(const CompiledScene& scene, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const;

  private:
    struct One {
        uint32_t id;                 ///< as CompiledScene::set numbers them
        uint32_t sides;              ///< of a solid: where in sides_ those of its nodes begin
    };
    bool hides(const CompiledScene& scene, const One& one, const Ray& ray, WorkCounters& work) const;

    std::vector<One> all_;
    std::vector<CsgSide> sides_;
    std::vector<uint32_t> ids_;      ///< scratch
};

}  // namespace alidade
