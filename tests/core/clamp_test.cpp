// SPDX-License-Identifier: Apache-2.0
#include "core/clamp.h"
#include "core/draws.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Ray ray(const Vec3& origin, const Vec3& dir) {
    Ray r;
    r.origin = origin, r.dir = dir;
    return r;
}

const Bounds kUnit{Vec3(-1), Vec3(1)};

TEST(ClampToBounds, BetweenEntryAndExit) {
    const Ray r = ray(Vec3(0, 0, -5), Vec3(0, 0, 2));
    EXPECT_EQ(clamp_to_bounds(2.5, r, kUnit), 2.5);
    EXPECT_EQ(clamp_to_bounds(1.9, r, kUnit), 2);
    EXPECT_EQ(clamp_to_bounds(3.1, r, kUnit), 3);
    EXPECT_EQ(clamp_to_bounds(-7, ray(Vec3(0), Vec3(1, 0, 0)), kUnit), -1) << "the whole line counts";
}

TEST(ClampToBounds, ALineThatMissesKeepsItsT) {
    EXPECT_EQ(clamp_to_bounds(7, ray(Vec3(0, 3, -5), Vec3(0, 0, 2)), kUnit), 7);
    EXPECT_EQ(clamp_to_bounds(7, ray(Vec3(0, 3, -5), Vec3(0, 1, 1)), kUnit), 7);
    EXPECT_EQ(clamp_to_bounds(7, ray(Vec3(0), Vec3(0, 0, 1)), Bounds()), 7) << "an empty box";
}

TEST(ClampToBounds, FacesBelongToTheBox) {
    for (const double zero : {0.0, -0.0}) {
        EXPECT_EQ(clamp_to_bounds(9, ray(Vec3(1, 1, -5), Vec3(zero, zero, 1)), kUnit), 6) << "along an edge";
        EXPECT_EQ(clamp_to_bounds(9, ray(Vec3(1, -1, 1), Vec3(zero, zero, 1)), kUnit), 0) << "from a corner";
    }
    const Bounds flat{Vec3(-1, 2, -1), Vec3(1, 2, 1)};
    EXPECT_EQ(clamp_to_bounds(9, ray(Vec3(0), Vec3(0, 1, 0)), flat), 2);
}

TEST(ClampToBounds, UnboundedBoxesDoNotClamp) {
    const Bounds half{Vec3(-kInf, -kInf, -kInf), Vec3(kInf, 0, kInf)};
    EXPECT_EQ(clamp_to_bounds(-1e300, ray(Vec3(0, 1, 0), Vec3(1, 2, 3)), {Vec3(-kInf), Vec3(kInf)}), -1e300);
    EXPECT_EQ(clamp_to_bounds(3, ray(Vec3(0, -1, 0), Vec3(1, 1, 0)), half), 1);
    EXPECT_EQ(clamp_to_bounds(3, ray(Vec3(0, -1, 0), Vec3(1, 0, 0)), half), 3);
}

/// On every machine the same bits: also of rays and boxes with zeros, infinities and what is no number.
TEST(InsideBounds, IsTheSameInLanes) {
    constexpr double kOdd[] = {0.0, -0.0, 1, -1, kInf, -kInf, std::numeric_limits<double>::quiet_NaN(), 5e-324, 1e308};
    size_t odd = 0, inside = 0;
    for (uint64_t number = 0; number < 200000; ++number) {
        Draws draws(RandomKey(11, 0, number));
        const auto one = [&](double size) { return draws.uniform(0, 1) < 0.1 ? ++odd, kOdd[size_t(draws.uniform(0, std::size(kOdd)))] : draws.uniform(-size, size); };
        const auto vector = [&](double size) { const double x = one(size), y = one(size), z = one(size); return Vec3(x, y, z); };
        const Vec3 origin = vector(3), dir = vector(1), a = vector(2), b = vector(2);
        const Bounds box = draws.coin() ? Bounds{a, b} : Bounds{glm::min(a, b), glm::max(a, b)};
        const LineInterval here = inside_bounds(ray(origin, dir), box), plain = inside_bounds_plainly(ray(origin, dir), box);
        ASSERT_EQ(here.entry, plain.entry) << number;
        ASSERT_EQ(here.exit, plain.exit) << number;
        inside += !here.empty();
    }
    EXPECT_GT(odd, 100000u);
    EXPECT_GT(inside, 10000u);
}

}  // namespace
}  // namespace alidade
