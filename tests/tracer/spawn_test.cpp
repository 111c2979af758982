// SPDX-License-Identifier: Apache-2.0
/// Rays that begin on a surface. Rows T17 and T18 of the numerical suite ask far more of them.
#include "core/draws.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/shade_point.h"

namespace alidade::test {
namespace {

/// From afar an instance's ray is corrected, and its bound must know of that: else rays are spawned beyond what is 50 roundings of the coordinates away.
TEST(Spawn, DiscsABillionthApartAndFarFromTheOriginSeeEachOther) {
    constexpr double kGap = 1e-9;
    for (uint64_t number = 0; number < 100; ++number) {
        Draws draws(RandomKey(3, 0, number));
        const Transform place = Transform::rotate(draws.direction(), draws.uniform(0, 6)) * Transform::scale(Vec3(std::pow(10, draws.uniform(-3, 3)))) * Transform::translate(1.3e5 * draws.direction());
        SceneBuilder b;
        const MaterialId m = b.material(b.lambert(Color(0.5)));
        for (const double z : {0.0, kGap}) b.object(Disc{Vec3(0), {0, 0, 1}, 1.5, 0}, m, place * Transform::translate({0, 0, z}));
        Diagnostics said;
        const auto scene = compile(b.scene, {}, said);
        const Vec3 up = normalized(place.vector({0, 0, 1}));
        Ray ray;
        ray.dir = normalized(up + 0.5 * draws.direction());
        ray.origin = place.point({draws.uniform(-0.5, 0.5), draws.uniform(-0.5, 0.5), 0}) - length(place.vector({0, 0, 1})) * ray.dir;
        for (const uint32_t next : {0u, 1u, 0u, 1u}) {
            Hit hit;
            WorkCounters work;
            scene->top->intersect(ray, hit, work);
            ASSERT_TRUE(hit.valid()) << number;
            ASSERT_EQ(hit.instance, next) << number;
            const ShadePoint p = shade_point(*scene, ray, hit);
            EXPECT_LT(p.error, kGap / 4 * length(place.vector({0, 0, 1}))) << number;
            ray = spawn_ray(p, normalized((next == 0 ? up : -up) + 0.5 * draws.direction()));
        }
    }
}

}  // namespace
}  // namespace alidade::test
