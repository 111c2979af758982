// SPDX-License-Identifier: Apache-2.0
/// Random numbers without state: a function of what they are for, never of a thread or of the order of evaluation.
#pragma once

#include <cstdint>

namespace alidade {

/// A key hashes (seed, frame, pixel, sample, branch choices along the path); `uniform(dimension)` draws from it.
/// Source   the mixing function is SplitMix64's finaliser (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014).
class RandomKey {
  public:
    constexpr RandomKey() = default;
    constexpr RandomKey(uint64_t seed, uint64_t frame, uint64_t pixel, uint64_t sample)
        : state_(mix(mix(mix(mix(seed) ^ frame) ^ pixel) ^ sample)) {}

    constexpr RandomKey(uint64_t seed, uint64_t frame, uint64_t pixel) : state_(mix(mix(mix(seed) ^ frame) ^ pixel)) {}

    /// The key of a branch: `branch` is the number of the choice taken here.
    constexpr RandomKey child(uint64_t branch) const { return RandomKey(mix(state_ ^ mix(branch + 1))); }
    constexpr uint64_t bits(uint64_t dimension) const { return mix(state_ + 0x9e3779b97f4a7c15u * (dimension + 1)); }
    /// In [0, 1), 53 bits.
    constexpr double uniform(uint64_t dimension) const { return double(bits(dimension) >> 11) * 0x1p-53; }

  private:
    constexpr explicit RandomKey(uint64_t state) : state_(state) {}
    static constexpr uint64_t mix(uint64_t z) {
        z += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    uint64_t state_ = 0;
};

}  // namespace alidade
