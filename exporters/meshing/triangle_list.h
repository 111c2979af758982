// SPDX-License-Identifier: Apache-2.0
/// A mesh that is being made, in double precision.
#pragma once

#include "scene/shape.h"

#include <array>
#include <functional>

namespace alidade::meshing {

/// Corners share positions where the surface is connected, and normals where it is smooth.
class TriangleList {
  public:
    uint32_t position(const Vec3& p) { return positions_.push_back(p), uint32_t(positions_.size() - 1); }
    uint32_t normal(const Vec3& n) { return normals_.push_back(Vec3f(n)), uint32_t(normals_.size() - 1); }
    /// Counter-clockwise from the front. One with two corners at one position is none.
    void triangle(const Index3& positions, const Index3& normals, uint32_t slot = 0);
    /// Its corners in order; each has its normal.
    void quad(const std::array<uint32_t, 4>& positions, const std::array<uint32_t, 4>& normals, uint32_t slot = 0);

    const Vec3& at(uint32_t position) const { return positions_[position]; }
    /// What of it lies where `keep` is true: triangles that lead out are cut where their sides do, found by bisection. What is smaller than a triangle may be missed.
    TriangleList cut(const std::function<bool(const Vec3&)>& keep) const;
    size_t size() const { return triangles_.size(); }
    /// In floats, about an origin near it where it lies far from 0.
    Mesh mesh() const;

  private:
    std::vector<Vec3> positions_;
    std::vector<Vec3f> normals_;
    std::vector<Index3> triangles_;
    std::vector<uint32_t> corners_, slots_;
};

}  // namespace alidade::meshing
