// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// The instances of a compiled scene, as primitives of the top-level accelerator. Rays are world-space; each is mapped into an instance's own space,
/// where t means the same. Hit::instance is the instance, Hit::primitive the triangle (0 for closed forms).
class InstanceSet final : public PrimitiveSet {
  public:
    /// `scene` must outlive the set.
    explicit InstanceSet(const CompiledScene& scene) : scene_(scene) {}
    size_t size() const override { return scene_.instances.size(); }
    Bounds bounds(uint32_t id) const override { return scene_.instances[id].bounds; }
    bool intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const override;
    bool occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const override;
    void all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const override;

  private:
    const CompiledScene& scene_;
};

}  // namespace alidade
