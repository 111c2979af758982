// SPDX-License-Identifier: Apache-2.0
/// seed() and rand(): POV-Ray's own streams of numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace alidade::pov {

/// Source   a linear congruential generator, found by probing: x' = 1812433253 x + 12345 mod 2^32, a number is x' / (2^32 - 1).
class RandomStreams {
  public:
    /// A new stream; its number.
    size_t seed(double value);
    /// The next number of a stream, in [0, 1], or nothing if there is no such stream.
    std::optional<double> next(double stream);

  private:
    std::vector<uint32_t> states_;
};

}  // namespace alidade::pov
