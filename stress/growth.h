// SPDX-License-Identifier: Apache-2.0
/// How a cost grows with the number of triangles.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace alidade {

/// cost = factor * n ^ exponent.
struct PowerLaw {
    double exponent = 0, factor = 0;
    std::optional<double> error;   ///< standard error of the exponent, from three points on
    size_t points = 0;
};

/// Least squares of the logarithms. Pairs without logarithms are passed over; nothing if fewer than two different n are left.
std::optional<PowerLaw> fit_power_law(std::span<const double> n, std::span<const double> cost);

}  // namespace alidade
