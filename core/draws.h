// SPDX-License-Identifier: Apache-2.0
/// Random numbers one after the other, for generators that need many; the same key gives the same numbers everywhere.
#pragma once

#include "core/random.h"
#include "core/vec.h"

#include <algorithm>
#include <cmath>

namespace alidade {

class Draws {
  public:
    explicit Draws(const RandomKey& key) : key_(key) {}

    /// In [0, 1).
    double uniform() { return key_.uniform(next_++); }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// In 0 .. count-1.
    uint32_t below(size_t count) { return uint32_t(key_.bits(next_++) % count); }
    bool coin() { return below(2) == 0; }
    double sign() { return coin() ? 1.0 : -1.0; }
    Vec3 in_box(const Vec3& low, const Vec3& high) {
        const double x = uniform(low.x, high.x), y = uniform(low.y, high.y), z = uniform(low.z, high.z);
        return {x, y, z};
    }
    /// Uniform on the unit sphere.
    Vec3 direction() {
        const double z = uniform(-1, 1), phi = uniform(0, 2 * kPi), r = std::sqrt(std::max(0.0, 1 - z * z));
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

  private:
    RandomKey key_;
    uint64_t next_ = 0;
};

}  // namespace alidade
