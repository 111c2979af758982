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

/// By twice the bound of the error at the least, whatever the coordinates round to: once for this point, once for the test that must not find the surface again. Sums are exact in long double.
TEST(Spawn, RaysBeginTwoBoundsOffTheSurface) {
    size_t rounded = 0;
    for (uint64_t number = 0; number < 100000; ++number) {
        Draws draws(RandomKey(4, 0, number));
        ShadePoint p;
        p.position = std::pow(10, draws.uniform(-3, 6)) * draws.direction();
        p.geometric_normal = draws.coin() ? draws.direction() : Vec3(0, 0, draws.coin() ? 1 : -1);
        p.error = max_abs(p.position) * std::pow(10, draws.uniform(-17, -10));
        const Vec3 dir = draws.direction();
        const Ray ray = spawn_ray(p, dir);
        const double side = dot(dir, p.geometric_normal) < 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) {
            const long double wanted = side * 2 * p.error * p.geometric_normal[k], moved = (long double)(ray.origin[k]) - p.position[k];
            ASSERT_TRUE(wanted > 0 ? moved >= wanted : wanted < 0 ? moved <= wanted : moved == 0) << number;
            rounded += wanted != 0 && double(p.position[k] + wanted) == p.position[k];
        }
    }
    EXPECT_GT(rounded, 1000u) << "some bounds are less than a rounding";
}

/// One number on from the rounded sum in the direction that they are moved, also from 0 and where nothing moves them.
TEST(Spawn, RaysBeginAtTheNextNumber) {
    for (uint64_t number = 0; number < 100000; ++number) {
        Draws draws(RandomKey(5, 0, number));
        ShadePoint p;
        p.position = draws.direction(), p.geometric_normal = draws.direction();
        for (int k = 0; k < 3; ++k) {
            if (draws.uniform(0, 1) < 0.2) p.geometric_normal[k] = 0;
            if (draws.uniform(0, 1) < 0.1) p.position[k] = 0;
        }
        p.error = draws.coin() ? 1e-17 : draws.coin() ? 0 : 1e-3;
        const Vec3 dir = draws.direction();
        const Vec3 offset = p.geometric_normal * ((dot(dir, p.geometric_normal) < 0 ? -2 : 2) * p.error), origin = spawn_ray(p, dir).origin;
        for (int k = 0; k < 3; ++k) {
            const double moved = p.position[k] + offset[k], wanted = offset[k] == 0 ? moved : std::nextafter(moved, offset[k] > 0 ? kInf : -kInf);
            ASSERT_EQ(origin[k], wanted) << number << " " << k;
        }
    }
}

/// What the test of triangles says of its error counts whole, beside what the ray and the place add.
TEST(Spawn, TheBoundOfAMeshIsThatOfItsTest) {
    SceneBuilder b;
    b.object(square(), b.material(b.lambert(Color(0.5))));
    Diagnostics said;
    const auto scene = compile(b.scene, {}, said);
    for (uint64_t number = 0; number < 1000; ++number) {
        Draws draws(RandomKey(5, 0, number));
        Ray ray;
        ray.origin = {draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(0.1, 3)}, ray.dir = Vec3(draws.uniform(-0.9, 0.9), draws.uniform(-0.9, 0.9), 0) - ray.origin;
        Hit hit;
        WorkCounters work;
        scene->top->intersect(ray, hit, work);
        ASSERT_TRUE(hit.valid());
        EXPECT_GT(hit.error.along_normal, 0);
        Hit worse = hit;
        worse.error.along_normal += 1;
        EXPECT_GE(shade_point(*scene, ray, worse).error, shade_point(*scene, ray, hit).error + 0.999) << number;
    }
}

}  // namespace
}  // namespace alidade::test
