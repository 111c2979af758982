// SPDX-License-Identifier: Apache-2.0
/// Random inputs for tests: reproducible, one number after the other.
#pragma once

#include "core/random.h"
#include "core/vec.h"

namespace alidade::test {

class Draw {
  public:
    explicit Draw(uint64_t seed) : key_(seed, 0, 0, 0) {}
    /// Uniform in [low, high).
    double operator()(double low, double high) { return low + (high - low) * key_.uniform(next_++); }
    uint64_t bits() { return key_.bits(next_++); }
    /// Uniform below n.
    uint32_t below(uint32_t n) { return uint32_t(bits() % n); }
    double sign() { return bits() & 1 ? 1.0 : -1.0; }
    /// From 10^low to 10^high, uniform in the exponent.
    double decades(double low, double high) { return std::pow(10.0, (*this)(low, high)); }
    Vec3 vector(double size = 1) {
        const double x = (*this)(-size, size), y = (*this)(-size, size);
        return {x, y, (*this)(-size, size)};
    }
    /// Uniform on the unit sphere.
    Vec3 direction() {
        for (;;) {
            const Vec3 v = vector();
            const double square = dot(v, v);
            if (square > 1e-4 && square <= 1) return normalized(v);
        }
    }
    /// A unit quaternion, uniform over rotations.
    Vec4 quaternion() {
        for (;;) {
            const Vec4 q((*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1));
            const double square = dot(q, q);
            if (square > 1e-4 && square <= 1) return q / std::sqrt(square);
        }
    }

  private:
    RandomKey key_;
    uint64_t next_ = 0;
};

}  // namespace alidade::test
