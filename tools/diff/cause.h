// SPDX-License-Identifier: Apache-2.0
/// What kind of slip makes two pictures differ.
#pragma once

#include "tools/metrics/metric.h"

#include <optional>
#include <string>

namespace alidade {

struct Cause {
    std::string name;       ///< one word for programs; "" if the pictures are equal
    std::string sentence;   ///< the same for people, with its numbers
};

/// Where the test lies against the reference.
struct Shift {
    double x = 0, y = 0;      ///< test(x + shift) = reference(x), in pixels
    double explained = 0;     ///< the share of the squared error that is gone after it, away from the border
};
/// A shift explains at least this share of the squared error: of pictures that no shift brings together, some shift is the nearest.
constexpr double kShiftExplains = 0.75;
/// To a quarter of a pixel and better, within 32 pixels: the integer shift with the least squared error, then least squares on the gradients
/// (Lucas and Kanade, "An iterative image registration technique", IJCAI 1981). Nothing where no shift explains the difference, or where there is none.
std::optional<Shift> find_shift(const PicturePair& pair);

/// The first that explains the difference, of: alpha, channels (swapped), mirrored, encoding (sRGB taken off or put on), gamma, exposure, offset, shift,
/// pixels (up to 4), seam (a line), noise, region, edges; else content.
Cause find_cause(const PicturePair& pair);

}  // namespace alidade
