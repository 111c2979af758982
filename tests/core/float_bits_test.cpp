// SPDX-License-Identifier: Apache-2.0
/// What is done on the bits of numbers, against the C library.
#include "core/next_up.h"
#include "core/powers_of_two.h"
#include "tests/core/draw.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// All kinds of numbers: of any exponent, denormal, the ends of the ranges.
template <class F> void for_numbers(const F& f) {
    using Limits = std::numeric_limits<double>;
    for (const double x : {0.0, 1.0, Limits::denorm_min(), Limits::min(), std::nextafter(Limits::min(), 0.0), Limits::max(), kInfinity, 2.0, std::nextafter(2.0, 0.0)})
        for (const double sign : {1.0, -1.0}) f(sign * x);
    test::Draw draw(1);
    for (int i = 0; i < 20000; ++i) f(std::ldexp(draw(-1, 1), int(draw.below(2140)) - 1070));
}

TEST(FloatBits, NextUpIsTheLibrarys) {
    for_numbers([](double x) {
        ASSERT_EQ(next_up(x), std::nextafter(x, kInfinity)) << x;
        ASSERT_EQ(-next_up(-x), std::nextafter(x, -kInfinity)) << x;
    });
    EXPECT_TRUE(std::isnan(next_up(std::nan(""))));
}

TEST(FloatBits, ExponentsAreTheLibrarys) {
    for_numbers([](double x) {
        ASSERT_EQ(exponent_of(x), std::ilogb(x)) << x;
        for (const int exponent : {-2200, -1074, -1023, -1022, -60, 0, 1, 60, 1023, 1024, 2200}) ASSERT_EQ(scaled_by(x, exponent), std::scalbn(x, exponent)) << x << " " << exponent;
    });
    for (int exponent = -1022; exponent <= 1023; ++exponent) ASSERT_EQ(power_of_two(exponent), std::ldexp(1.0, exponent));
}

}  // namespace
}  // namespace alidade
