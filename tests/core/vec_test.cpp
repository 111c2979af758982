// SPDX-License-Identifier: Apache-2.0
#include "tests/core/draw.h"
#include "tests/core/quad.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Vec, LengthNeitherOverflowsNorUnderflows) {
    EXPECT_EQ(length(Vec3(3e300, 4e300, 0)), 5e300);
    EXPECT_EQ(length(Vec3(0, -1e-300, 0)), 1e-300);
    EXPECT_EQ(length(Vec3(0)), 0);
    EXPECT_EQ(length(Vec3(1, -kInf, 2)), kInf);
    EXPECT_TRUE(std::isnan(length(Vec3(1, kNan, 2))));
    EXPECT_TRUE(std::isnan(length(Vec3(0, kNan, 0))));
    EXPECT_TRUE(std::isnan(length(Vec3(0, 0, kNan))));
}

/// Metamorphic: a power of two changes no digit, over 540 decades.
TEST(Vec, LengthAndDirectionScaleByPowersOfTwo) {
    test::Draw draw(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 v = draw.vector();
        for (const int exponent : {-900, -500, -60, 60, 500, 900}) {
            const double k = std::ldexp(1.0, exponent);
            ASSERT_EQ(length(k * v), k * length(v));
            ASSERT_EQ(normalized(k * v), normalized(v));
        }
    }
}

#ifdef ALIDADE_HAS_QUAD
TEST(Vec, LengthAndDirectionAgainst113Bits) {
    test::Draw draw(2);
    double worst_length = 0, worst_direction = 0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 v(draw(-1, 1) * draw.decades(-150, 150), draw(-1, 1) * draw.decades(-150, 150), draw(-1, 1) * draw.decades(-150, 150));
        const test::Quad exact = test::length(test::QuadVec(v));
        worst_length = std::max(worst_length, test::ulps(length(v), exact));
        const test::QuadVec difference = test::QuadVec(normalized(v)) - (1 / exact) * test::QuadVec(v);
        worst_direction = std::max(worst_direction, double(test::length(difference)));
    }
    EXPECT_LT(worst_length, 4);
    EXPECT_LT(worst_direction, 4 * std::numeric_limits<double>::epsilon());
}
#endif

TEST(Vec, NormalizedLeavesWhatHasNoDirection) {
    EXPECT_EQ(normalized(Vec3(0)), Vec3(0));
    EXPECT_EQ(normalized(Vec3(kInf, 1, 0)), Vec3(kInf, 1, 0));
    EXPECT_FALSE(is_finite(normalized(Vec3(0, kNan, 0))));
    EXPECT_FALSE(is_finite(normalized(Vec3(1, kNan, 0))));
}

TEST(Vec, OrthonormalBasisIsOneEverywhere) {
    test::Draw draw(3);
    const double tolerance = 8 * std::numeric_limits<double>::epsilon();
    for (int i = 0; i < 10000; ++i) {
        Vec3 n = draw.direction();
        if (i < 6) n = Vec3(0), n[i / 2] = i % 2 ? 1 : -1;
        Vec3 s, t;
        orthonormal_basis(n, s, t);
        ASSERT_NEAR(length(s), 1, tolerance);
        ASSERT_NEAR(length(t), 1, tolerance);
        ASSERT_NEAR(dot(s, n), 0, tolerance);
        ASSERT_NEAR(dot(t, n), 0, tolerance);
        ASSERT_LT(max_abs(cross(s, t) - n), tolerance) << "right-handed";
    }
}

}  // namespace
}  // namespace alidade
