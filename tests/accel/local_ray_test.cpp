// SPDX-License-Identifier: Apache-2.0
/// The ray that structures see, made by vectors and one number at a time.
#include "accel/local_ray.h"
#include "core/draws.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

#include <bit>

namespace alidade::test {
namespace {

/// Of all sizes; many are small integers, so that rays run along axes and on planes of the box.
double coordinate(Draws& draws) {
    switch (draws.below(6)) {
        case 0: return 0;
        case 1: return int(draws.below(5)) - 2;
        case 2: return draws.sign() * std::ldexp(1.0, int(draws.below(800)) - 400);
        default: return draws.uniform(-2, 2);
    }
}
Vec3 point(Draws& draws) {
    const double x = coordinate(draws), y = coordinate(draws);
    return {x, y, coordinate(draws)};
}

Ray random_ray(const Bounds& box, Draws& draws) {
    Ray ray;
    ray.origin = point(draws), ray.dir = point(draws);
    if (draws.coin()) ray.dir = Vec3(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1)) * std::ldexp(1.0, int(draws.below(1000)) - 500);
    if (draws.below(3) > 0) ray.dir = draws.in_box(box.min, box.max) - ray.origin;
    if (ray.dir == Vec3(0)) ray.dir.x = 1;
    if (draws.coin()) ray.tmin = draws.coin() ? -kInf : draws.uniform(-2, 2);
    if (draws.coin()) ray.tmax = std::max(ray.tmin, draws.uniform(0, 4));
    return ray;
}

bool same_bits(double a, double b) { return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b) || (a == 0 && b == 0); }
bool same_bits(const Vec3& a, const Vec3& b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z); }

TEST(LocalRay, IsTheSameForAllInstructions) {
    const size_t count = run_size(300000, 10000000);
    size_t moved = 0, missed = 0, unclipped = 0;
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(51, 0, n, 0));
        Bounds box;
        box.extend(point(draws)), box.extend(point(draws));
        const Ray ray = random_ray(box, draws);
        const RayEntry entry{draws.below(4) > 0, draws.coin() ? 0.25 : kFar, draws.coin()};
        const LocalRay want = local_ray(ray, box, entry, Isa::scalar);
        for (const Isa isa : available_isas()) {
            const LocalRay got = local_ray(ray, box, entry, isa);
            ASSERT_EQ(got.enters_box(), want.enters_box()) << name(isa) << ", seed 51, ray " << n;
            ASSERT_TRUE(same_bits(got.origin, want.origin) && same_bits(got.dir, want.dir) && same_bits(got.inverse, want.inverse)) << name(isa) << ", seed 51, ray " << n;
            ASSERT_TRUE(same_bits(got.shift, want.shift) && same_bits(got.to_local, want.to_local) && same_bits(got.to_caller, want.to_caller)) << name(isa) << ", seed 51, ray " << n;
            ASSERT_TRUE(same_bits(got.tmin, want.tmin) && same_bits(got.tmax, want.tmax) && same_bits(got.reach, want.reach))
                << name(isa) << ", seed 51, ray " << n << ": tmin " << got.tmin << " not " << want.tmin << ", tmax " << got.tmax << " not " << want.tmax << ", reach " << got.reach << " not " << want.reach;
        }
        moved += want.shift != 0, missed += !want.enters_box(), unclipped += want.tmax == kInf;
    }
    EXPECT_GT(unclipped, count / 50);
    EXPECT_GT(moved, count / 20);
    EXPECT_GT(missed, count / 20);
    EXPECT_LT(missed, count - count / 5);
}

/// Where a ray is not clipped, it is where it was, and its interval holds that of the clipped one from 0 on; it is empty only where that is.
TEST(LocalRay, IsLeftWhereItIsNear) {
    const size_t count = run_size(300000, 10000000);
    size_t near = 0, far = 0, missed = 0, late = 0;
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(52, 0, n, 0));
        Bounds box;
        box.extend(point(draws)), box.extend(point(draws));
        Ray ray = random_ray(box, draws);
        if (draws.below(4) > 0) ray.tmin = 0, ray.tmax = draws.coin() ? kInf : draws.uniform(0, 4);
        const LocalRay clipped = local_ray(ray, box, {true, 2}), left = local_ray(ray, box, {true, 2, false});
        const bool begins_near = max_abs(ray.origin - box.center()) <= 2 * max_component(box.extent());
        ASSERT_TRUE(!begins_near || clipped.shift == 0) << "seed 52, ray " << n;
        ASSERT_TRUE(!clipped.enters_box() || left.enters_box() || clipped.tmax <= kOriginPad<double>) << "seed 52, ray " << n;   // what is behind it may be in the pad of the clipped one
        if (!begins_near || ray.tmin < 0 || !left.is_plain()) {
            ASSERT_TRUE(same_bits(clipped.tmin, left.tmin) && same_bits(clipped.tmax, left.tmax) && same_bits(clipped.origin, left.origin)) << "seed 52, ray " << n;
            far += clipped.shift != 0;
            continue;
        }
        missed += !left.enters_box();
        if (!left.enters_box()) continue;
        ++near;
        late += left.tmin > 0;
        ASSERT_TRUE(left.tmin == (ray.tmin > 0 ? std::max(0.0, left.lower(ray.tmin)) : 0) && (!clipped.enters_box() || left.tmin <= std::max(0.0, clipped.tmin))) << "seed 52, ray " << n;
        ASSERT_TRUE(left.shift == 0 && left.tmax >= std::min(left.upper(ray.tmax), ray.tmax == kInf ? kInf : clipped.tmax)) << "seed 52, ray " << n;
        ASSERT_TRUE(!clipped.enters_box() || left.tmax >= clipped.tmax) << "seed 52, ray " << n;
    }
    EXPECT_GT(near, count / 20);
    EXPECT_GT(late, count / 1000);
    EXPECT_GT(far, count / 50);
    EXPECT_GT(missed, count / 50);
}

}  // namespace
}  // namespace alidade::test
