// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// The instances of a compiled scene, and behind them its solids, as primitives of the top-level accelerator. Rays are world-space; each is mapped into
/// an instance's own space, where t means the same. Hit::instance is the instance, of a solid the part that is hit; Hit::primitive the triangle (0 for
/// closed forms). Parts of solids have no box, so that nothing asks for them.
class InstanceSet final : public PrimitiveSet {
  public:
    /// Those alone that rays with a bit of `seen_by` see: the others keep their numbers, and have no bounds. `scene` must outlive the set.
    explicit InstanceSet(const CompiledScene& scene, Mask seen_by = kMaskAll);
    size_t size() const override { return scene_.instances.size() + scene_.solids.size(); }
    Bounds bounds(uint32_t id) const override {
        if (!(mask(id) & seen_by_)) return {};
        return is_solid(id) ? solid(id).tree.bounds() : scene_.instances[id].bounds;
    }
    bool intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const override;
    bool occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const override;
    void all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const override;

    /// The first surface of a solid before `hit`. `known`: the sides of its nodes where the ray goes, or nothing.
    bool intersect_solid(uint32_t id, const Ray& ray, Hit& hit, WorkCounters& work, std::span<const CsgSide> known = {}) const;

    /// Is a crossing of the instance seen, and not `hit`? The nearer one, and of those that coincide what CompiledScene::first_box_shows says.
    bool is_seen_before(const Ray& ray, double t, uint32_t instance, uint32_t primitive, const Hit& hit) const;

    bool is_solid(uint32_t id) const { return id >= scene_.instances.size(); }
    const Solid& solid(uint32_t id) const { return scene_.solids[id - scene_.instances.size()]; }
    /// The solid that the instance is a part of, or its own number.
    uint32_t whole(uint32_t instance) const { return wholes_.empty() ? instance : wholes_[instance]; }
    Mask mask(uint32_t id) const { return is_solid(id) ? solid(id).mask : scene_.instances[id].mask; }

  private:
    const CompiledScene& scene_;
    Mask seen_by_;
    std::vector<uint32_t> wholes_;   ///< by instance; empty if there are no solids
};

}  // namespace alidade
