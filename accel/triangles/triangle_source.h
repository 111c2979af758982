// SPDX-License-Identifier: Apache-2.0
/// A triangle array as builders see it.
#pragma once

#include "accel/accelerator.h"
#include "accel/leaf.h"
#include "accel/triangles/decide.h"

namespace alidade {

/// R: the precision in which corners are taken, and kept afterwards.
template <class R> class TriangleSource {
  public:
    explicit TriangleSource(const TriangleView& mesh);

    size_t size() const { return mesh_.triangles.size(); }
    /// Removed are triangles that name a missing vertex, have a coordinate that is not finite or too large, or have no area.
    PrimitiveKind kind(uint32_t id) const;
    Bounds bounds(uint32_t id) const {
        const Corners c = corners(id);
        return {glm::min(c[0], glm::min(c[1], c[2])), glm::max(c[0], glm::max(c[1], c[2]))};
    }
    /// The same in R.
    BoundsT<R> box(uint32_t id) const {
        if constexpr (std::is_same_v<R, float>) {
            const Index3& t = mesh_.triangles[id];
            const Vec3f &a = mesh_.positions[t.x], &b = mesh_.positions[t.y], &c = mesh_.positions[t.z];
            return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
        } else {
            return bounds(id);
        }
    }
    /// The common box, empty where the triangle's plane passes by `box`.
    Bounds clipped_bounds(uint32_t id, const Bounds& box) const;

    /// Exactly representable in R.
    Corners corners(uint32_t id) const {
        const Index3& t = mesh_.triangles[id];
        return {position(t.x), position(t.y), position(t.z)};
    }

    /// The same as they are kept in R, or in double.
    auto stored_corners(uint32_t id) const {
        if constexpr (std::is_same_v<R, float>) {
            const Index3& t = mesh_.triangles[id];
            return std::array<Vec3f, 3>{mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z]};
        } else {
            return corners(id);
        }
    }
    /// Begin to read what will be asked for.
    void fetch_triangle(uint32_t id) const { __builtin_prefetch(&mesh_.triangles[id]); }
    void fetch_vertices(uint32_t id) const {
        const Index3& t = mesh_.triangles[id];
        if (!exact()) __builtin_prefetch(&mesh_.positions[t.x]), __builtin_prefetch(&mesh_.positions[t.y]), __builtin_prefetch(&mesh_.positions[t.z]);
    }

    const TriangleView& mesh() const { return mesh_; }

  private:
    bool exact() const { return std::is_same_v<R, double> && mesh_.exact_positions.size() == mesh_.positions.size() && !mesh_.exact_positions.empty(); }
    Vec3 position(uint32_t i) const { return exact() ? quantized(mesh_.exact_positions[i]) : Vec3(mesh_.positions[i]); }

    TriangleView mesh_;
    bool all_usable_ = true;   ///< no position is too large, or not finite: most meshes have none, and each is in six triangles
};

extern template class TriangleSource<float>;
extern template class TriangleSource<double>;

}  // namespace alidade
