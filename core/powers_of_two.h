// SPDX-License-Identifier: Apache-2.0
/// The functions of <cmath> on exponents, without a call where numbers are normal.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace alidade {

/// 2^exponent for an exponent of -1022 to 1023.
inline double power_of_two(int exponent) { return std::bit_cast<double>(uint64_t(exponent + 1023) << 52); }

/// floor(log2 |x|): std::ilogb(x).
inline int exponent_of(double x) {
    const int biased = int(std::bit_cast<uint64_t>(x) >> 52 & 0x7ff);
    return biased > 0 && biased < 0x7ff ? biased - 1023 : std::ilogb(x);
}

/// x 2^exponent: std::scalbn(x, exponent).
inline double scaled_by(double x, int exponent) { return exponent >= -1022 && exponent <= 1023 ? x * power_of_two(exponent) : std::scalbn(x, exponent); }

}  // namespace alidade
