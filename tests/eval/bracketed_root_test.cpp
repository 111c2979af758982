// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/bracketed_root.h"

#include <gtest/gtest.h>
#include <limits>

namespace alidade {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// The distance from a sphere at a distance of 3 along a line that passes its centre at a distance `off`: rounded to some units of kEpsilon, whose halvings are asked for.
TEST(BracketedRoot, EndsWhereRoundingDoes) {
    int asked = 0;
    for (int i = 0; i < 1000; ++i) {
        const double off = 0.9 * i / 1000, root = std::sqrt(1 - off * off);
        const auto distance = [&](double s) {
            const double x = s - 3, from_centre = std::sqrt(x * x + off * off);
            return ++asked, std::pair(from_centre - 1, x / from_centre);
        };
        EXPECT_NEAR(bracketed_root(distance, 0, 3, true, 0x1p-53, 0x1p-53), 3 - root, 4 * kEpsilon / root) << off;
    }
    EXPECT_LT(asked, 6 * 1000);   // with halvings to the last digit 8,700
}

/// Where the slope is 0 as well Newton's steps shrink by a third only, and may not be taken for the last.
TEST(BracketedRoot, IsFoundWhereTheSlopeIsNone) {
    int asked = 0;
    const auto flat = [&](double x) { return ++asked, std::pair((x - 0.3) * (x - 0.3) * (x - 0.3), 3 * (x - 0.3) * (x - 0.3)); };
    EXPECT_NEAR(bracketed_root(flat, -1, 1, false, 0x1p-110, 0x1p-51), 0.3, 4 * kEpsilon);
    EXPECT_LT(asked, 120);
}

/// Steps that would leave the bracket, and a root at its end.
TEST(BracketedRoot, StaysInTheBracket) {
    const auto steep = [](double x) { return std::pair(std::atan(20 * (x - 0.9)), 20 / (1 + 400 * (x - 0.9) * (x - 0.9))); };
    EXPECT_NEAR(bracketed_root(steep, -1, 1, false, 0x1p-110, 0x1p-51), 0.9, 4 * kEpsilon);
    const auto line = [](double x) { return std::pair(x - 1, 1.0); };
    EXPECT_NEAR(bracketed_root(line, 0, 1, false, 0x1p-110, 0x1p-51), 1, 4 * kEpsilon);
}

}  // namespace
}  // namespace alidade
