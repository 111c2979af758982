// SPDX-License-Identifier: Apache-2.0
/// The point that lies nearest to some planes.
#pragma once

#include "core/vec.h"

#include <utility>
#include <vector>

namespace alidade::meshing {

/// Planes given by a point and a unit normal each.
class PlaneFit {
  public:
    void add(const Vec3& point, const Vec3& normal);
    /// Of all points with the least sum of squared distances from the planes the one nearest to the mean of their points. Directions in which the planes hardly differ
    /// (an eigenvalue below a tenth of the largest) count as free.
    Vec3 nearest() const;

  private:
    std::vector<std::pair<Vec3, Vec3>> planes_;
    Vec3 sum_{0};
};

}  // namespace alidade::meshing
