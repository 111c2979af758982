// SPDX-License-Identifier: Apache-2.0
/// A PrimitiveSet of simple solids, to test accelerators over sets without any real shape: spheres and boxes, met twice by most lines, and planes,
/// which are not bounded.
#pragma once

#include "accel/accelerator.h"

#include <array>
#include <optional>

namespace alidade::test {

struct ToySolid {
    enum class Kind { sphere, box, plane, nan } kind;  ///< nan: never hit, bounds are NaN
    Vec3 center;                                       ///< of the plane, any point
    Vec3 size;                                         ///< radius in x; half extents; normal
};

class ToySet : public PrimitiveSet {
  public:
    explicit ToySet(std::vector<ToySolid> solids) : solids_(std::move(solids)) {}

    size_t size() const override { return solids_.size(); }
    Bounds bounds(uint32_t id) const override;
    bool intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const override;
    bool occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const override;
    void all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const override;

  private:
    /// Of the whole line: entry and exit, the same for a plane; part 0 is the entry.
    std::optional<std::array<double, 2>> crossings(uint32_t id, const Ray& ray) const;
    /// Those in the interval of the ray.
    std::vector<Hit> hits_of(uint32_t id, const Ray& ray) const;

    std::vector<ToySolid> solids_;
};

/// Spheres and boxes in [-1, 1]^3.
std::vector<ToySolid> random_solids(size_t count, double size, uint64_t seed);

}  // namespace alidade::test
