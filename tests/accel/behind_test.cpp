// SPDX-License-Identifier: Apache-2.0
/// What filters leave out because it is behind the ray: nothing whose t is not negative, the same with all instructions that round alike, and most of what rays that are spawned on surfaces meet.
#include "accel/triangles/behind.h"
#include "accel/triangles/watertight.h"
#include "core/draws.h"
#include "numerics/triangles/rational.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace alidade::test {

using namespace numerics;

namespace {

/// A triangle whose sides are of one order.
std::array<Vec3, 3> even(const Vec3& at, double size, Draws& draws) {
    const Vec3 across = draws.direction(), along = normalized(cross(across, draws.direction())), up = cross(across, along);
    std::array<Vec3, 3> corners;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2 * kPi * (i + draws.uniform(-0.1, 0.1)) / 3;
        corners[size_t(i)] = at + draws.uniform(0.7, 1) * size * (std::cos(angle) * along + std::sin(angle) * up);
    }
    return corners;
}

/// Triangles about a point, and a ray that begins near it: off by some roundings, or by a random power of two.
template <class T> struct Case {
    TriangleBlock<T> block{};
    Ray ray;
    LocalRay local;
    bool lifted;   ///< off the first triangle, which is not large, as secondary rays of the stress test are

    explicit Case(uint64_t n) {
        Draws draws(RandomKey(131, sizeof(T), n));
        const double scale = draws.below(4) == 0 ? std::ldexp(1.0, int(draws.below(220)) - 110) : 1, small = std::ldexp(1.0, -int(draws.below(12))), size = scale * small;
        const Vec3 at = scale * draws.in_box(Vec3(-1), Vec3(1));
        Bounds bounds;
        for (uint32_t lane = 0; lane < kLanes; ++lane) {
            std::array<Vec3, 3> corners;
            for (Vec3& c : corners) c = at + (draws.below(8) == 0 ? 64 * size : size) * draws.in_box(Vec3(-1), Vec3(1));
            if (lane == 0) corners = even(at, size, draws);
            if (lane == 1) corners[1] = corners[0] + 0x1p-20 * (corners[1] - corners[0]);
            block.put(corners, lane);
            for (const Vec3& c : block.corners(lane)) bounds.extend(c);
        }
        const bool thin = draws.below(4) == 0;
        const auto c = block.corners(thin ? 1 : 0);
        const double u = draws.uniform(), v = (1 - u) * draws.uniform();
        const Vec3 p = (1 - u - v) * c[0] + u * c[1] + v * c[2], normal = normalized(cross(c[1] - c[0], c[2] - c[0]));
        const double roundings = draws.below(3) == 0 ? 128 : std::ldexp(draws.uniform(-1, 1), int(draws.below(24)));
        lifted = roundings == 128 && !thin && small < 0.1 && max_abs(p) > 0.3 * scale;
        ray.origin = p + roundings * double(kUnitRoundoff<T>) * max_abs(p) * normal;
        if (draws.below(4) == 0) ray.origin = Vec3(Vec3T<T>(ray.origin));
        ray.dir = draws.below(4) == 0 ? draws.direction() : normalized(normal + draws.direction() * 0.999);
        local = local_ray(ray, bounds, {false, kFar});
    }
};

template <class T> struct Exact {
    static FilterRay<T> ray(const Case<T>& c) { return {c.local, ShearAxes(c.local.dir), DecideRay(c.local).shear_x, DecideRay(c.local).shear_y, begins_at_origin(c.ray, c.local)}; }
    static auto filter(Isa isa) { return edge_filter<T>(isa); }
    /// Of the crossing, if there is one.
    static double t(const Case<T>& c, uint32_t lane) {
        uint64_t exact = 0;
        const auto crossing = decide(DecideRay(c.local), c.block.corners(lane), -kInf, kInf, exact);
        return crossing ? crossing->t : -kInf;
    }
};

template <class T> struct Watertight {
    static WatertightRay<T> ray(const Case<T>& c) { return {c.local, begins_at_origin(c.ray, c.local)}; }
    static auto filter(Isa isa) { return watertight_test<T>(isa); }
    static double t(const Case<T>& c, uint32_t lane) { return crossing_within(c.local, ShearAxes(c.local.dir).z, c.block.corners(lane)).t; }
};

template <class Test, class T> void expect_only_behind() {
    size_t left_out = 0, spawned = 0, spawned_left_out = 0;
    const size_t count = run_size(40000, 4000000);
    for (uint64_t n = 0; n < count; ++n) {
        const Case<T> one(n);
        if (!one.local.enters_box()) continue;
        const auto ray = Test::ray(one);
        for (const Isa isa : available_isas()) {
            const uint32_t all = Test::filter(isa)(one.block, ray, false), ahead = Test::filter(isa)(one.block, ray, true);
            ASSERT_EQ(ahead & ~all, 0u) << name(isa) << ", seed 131, " << n;
            const auto alike = Test::filter(fuses(isa) ? Isa::avx2 : Isa::scalar);
            ASSERT_EQ(alike(one.block, ray, false), all) << name(isa) << ", seed 131, " << n;
            ASSERT_EQ(alike(one.block, ray, true), ahead) << name(isa) << ", seed 131, " << n;
            for (uint32_t bits = all & ~ahead; bits; bits &= bits - 1) {
                const auto lane = uint32_t(std::countr_zero(bits));
                ++left_out;
                ASSERT_LT(Test::t(one, lane), 0) << name(isa) << ", lane " << lane << ", seed 131, " << n;
                const ExactCrossing exact = exact_crossing({one.local.origin, one.local.dir, -kInf, kInf}, one.block.corners(lane));
                ASSERT_TRUE(exact.side < 0 || exact.t < 0) << name(isa) << ", lane " << lane << ", seed 131, " << n;
            }
            if (one.lifted && all & 1 && Test::t(one, 0) < 0) ++spawned, spawned_left_out += !(ahead & 1);
        }
    }
    EXPECT_GT(left_out, available_isas().size() * count / 10);
    EXPECT_GT(double(spawned_left_out), 0.7 * double(spawned)) << "of " << spawned;
    EXPECT_GT(spawned, available_isas().size() * count / 100);
}

TEST(Behind, OnlyWhatIsBehindIsLeftOutInFloat) {
    expect_only_behind<Exact<float>, float>();
    expect_only_behind<Watertight<float>, float>();
}

TEST(Behind, OnlyWhatIsBehindIsLeftOutInDouble) {
    expect_only_behind<Exact<double>, double>();
    expect_only_behind<Watertight<double>, double>();
}

/// A ray that was moved, or that counts what is before its origin, is not asked.
TEST(Behind, OnlyRaysThatBeginAtTheirOriginAreAsked) {
    const Bounds box{Vec3(-1), Vec3(1)};
    const Ray inside{Vec3(0.5), Vec3(0, 0, 1)}, outside{Vec3(0, 0, -5), Vec3(0, 0, 1)}, whole{Vec3(0.5), Vec3(0, 0, 1), -kInf};
    EXPECT_TRUE(begins_at_origin(inside, local_ray(inside, box, {true, 2})));
    EXPECT_FALSE(begins_at_origin(outside, local_ray(outside, box, {true, 2})));
    EXPECT_TRUE(begins_at_origin(outside, local_ray(outside, box, {false, 2})));
    EXPECT_FALSE(begins_at_origin(whole, local_ray(whole, box, {false, 2})));
    EXPECT_EQ(BehindError<float>::blur({1, 1, 1}, false), std::numeric_limits<float>::infinity());
}

}  // namespace
}  // namespace alidade::test
