// SPDX-License-Identifier: Apache-2.0
/// The random sequences that POV-Ray's noise and patterns are made of.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace alidade {

/// POV-Ray's linear congruential generator, 15 bits at a time.
class NoiseSequence {
  public:
    constexpr explicit NoiseSequence(uint32_t state) : state_(state) {}
    constexpr uint32_t next() {
        state_ = 1812433253u * state_ + 12345u;
        return state_ >> 16 & 0x7FFFu;
    }

  private:
    uint32_t state_;
};

/// 0..4095, shuffled; written twice, so that an index of 4096 needs no reduction.
inline constexpr std::array<uint16_t, 8192> kLatticeHash = [] {
    std::array<uint16_t, 8192> h{};
    for (unsigned i = 0; i < 4096; ++i) h[i] = uint16_t(i);
    NoiseSequence sequence(0);
    for (unsigned i = 4096; i-- > 0;) {
        const unsigned j = sequence.next() % 4096;
        const uint16_t kept = h[i];
        h[i] = h[j];
        h[j] = kept;
    }
    for (unsigned i = 0; i < 4096; ++i) h[4096 + i] = h[i];
    return h;
}();

/// A number of 12 bits for a cell of the unit lattice.
inline unsigned cell_hash(int64_t x, int64_t y, int64_t z) {
    return kLatticeHash[kLatticeHash[kLatticeHash[unsigned(x & 4095)] ^ unsigned(y & 4095)] ^ unsigned(z & 4095)];
}

/// 32768 numbers, uniform in [0, 1). Those of a cell begin at its hash.
std::span<const double, 32768> cell_randoms();

/// Uniform in [0, 1), the same for the same index; repeats after 32768.
inline double cell_random(unsigned index) { return cell_randoms()[index % 32768]; }

/// A coordinate without its fraction, towards zero. What fits no 32 bits, and a NaN, becomes the least int: so POV-Ray's own cells are on x86.
inline int32_t truncated(double x) {
#ifdef __SSE2__
    return _mm_cvttsd_si32(_mm_set_sd(x));   // the instruction itself has no branch
#else
    return x > -2147483649.0 && x < 2147483648.0 ? int32_t(x) : std::numeric_limits<int32_t>::min();
#endif
}

}  // namespace alidade
