// SPDX-License-Identifier: Apache-2.0
#include "eval/placed.h"
#include "tests/core/quad.h"

#include <gtest/gtest.h>

#include <random>

namespace alidade {
namespace {

/// Several components at a time give the bits of one at a time, also far from the origin, stretched, and where numbers end.
TEST(Placed, LanesCorrectAsPlainNumbersDo) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> number(-1, 1), exponent(-40, 40);
    const auto vec = [&] { return Vec3(number(random), number(random), number(random)) * std::exp2(exponent(random)); };
    int moved = 0;
    for (int i = 0; i < 20000; ++i) {
        const Transform to_world{Mat3(vec(), vec(), vec()), i % 3 ? vec() : Vec3(0)};
        const Transform to_local = inverse(to_world).value_or(to_world);
        Vec3 world = vec();
        if (i % 100 == 0) world[i / 100 % 3] = i % 200 ? kInf : std::numeric_limits<double>::quiet_NaN();
        const Vec3 near = to_local.point(world), got = corrected(to_world.linear, to_local.linear, to_world.translation, world, near);
        const Vec3 wanted = corrected_plainly(to_world.linear, to_local.linear, to_world.translation, world, near);
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(std::isnan(got[k]), std::isnan(wanted[k])) << i;
            ASSERT_TRUE(std::isnan(wanted[k]) || got[k] == wanted[k]) << i;
        }
        moved += is_finite(wanted) && wanted != near;
    }
    EXPECT_GT(moved, 10000) << "the test must exercise corrections";
}

#ifdef ALIDADE_HAS_QUAD
/// What is left once `near` is mapped back is known to nearly all digits, however much of `world` that takes away: against 113-bit numbers.
TEST(Placed, RestIsKnownToItsLastDigits) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> number(-1, 1), exponent(-12, 12);
    const auto vec = [&] { return Vec3(number(random), number(random), number(random)) * std::exp2(exponent(random)); };
    constexpr double kMuch = 0x1p80;   // the rest is multiplied by this, and so is all that is seen
    int tested = 0;
    for (int i = 0; i < 20000; ++i) {
        const Transform to_world{Mat3(vec(), vec(), vec()), vec()};
        const auto to_local = inverse(to_world);
        if (!to_local) continue;
        const Vec3 world = vec(), near = to_local->point(world), got = corrected(to_world.linear, Mat3(kMuch), to_world.translation, world, near);
        for (int row = 0; row < 3; ++row) {
            test::Quad rest = test::Quad(world[row]) - test::Quad(to_world.translation[row]);
            double size = std::abs(world[row]) + std::abs(to_world.translation[row]);
            for (int column = 0; column < 3; ++column) rest -= test::Quad(near[column]) * test::Quad(to_world.linear[column][row]), size += std::abs(near[column] * to_world.linear[column][row]);
            const test::Quad want = test::Quad(near[row]) + test::Quad(kMuch) * rest;
            ASSERT_LE(std::abs(double(test::Quad(got[row]) - want)), 0x1p-52 * std::abs(double(want)) + kMuch * 0x1p-100 * size) << i;
            ++tested;
        }
    }
    EXPECT_GT(tested, 50000);
}
#endif

}  // namespace
}  // namespace alidade
