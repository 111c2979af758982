// SPDX-License-Identifier: Apache-2.0
/// Where a side is known, rays in the shaft meet nothing, and are on that side.
#include "tests/core/draw.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/instance_set.h"
#include "tracer/shaft_sides.h"

namespace alidade::test {
namespace {

/// One of each kind, in turn; small ones and such as hold nearly everything.
ShapeGeometry shape(int kind, Draw& draw) {
    const double size = draw.below(2) ? draw(3, 9) : draw(0.2, 1);
    switch (kind % 6) {
        case 0: return Sphere{draw.vector(1), size};
        case 1: return Plane{draw.vector(1), draw(-2, 2)};
        case 2: return Box{draw.vector(1) - Vec3(size), draw.vector(1) + Vec3(size)};
        case 3: return Cylinder{{0, -size, 0}, {draw(-1, 1), size, 0}, size, draw.below(3) == 0};
        case 4: return Quadric{Vec3(1, 1, draw.below(2) ? -1 : 0), Vec3(0), Vec3(0), -size};
        default: return Cone{{0, -size, 0}, {0, size, 0}, size, 0.5 * size};   // of which the box alone is known
    }
}

Bounds box_at(const Vec3& middle, double size, Draw& draw) {
    const Vec3 half = glm::abs(draw.vector(size));
    return {middle - half, middle + half};
}
Vec3 in(const Bounds& box, Draw& draw) { return box.min + (box.max - box.min) * Vec3(draw(0, 1), draw(0, 1), draw(0, 1)); }

TEST(ShaftSides, HoldForAllRays) {
    Draw draw(17);
    SceneBuilder b;
    const MaterialId plain = b.material(b.lambert(Color(1)));
    constexpr uint32_t kObjects = 240;
    for (uint32_t i = 0; i < kObjects; ++i) {
        const Transform placed = i % 3 ? Transform::translate(draw.vector(1)) * Transform::rotate(normalized(draw.vector(1)), draw(0, 6)) * Transform::scale({draw(0.5, 2), draw(0.5, 2), draw(0.5, 2)}) : Transform();
        b.object(shape(int(i), draw), plain, placed);
    }
    const auto scene = compiled(b.scene);
    int inside[6] = {}, outside[6] = {};
    WorkCounters work;
    for (uint32_t round = 0; round < 40 * kObjects; ++round) {
        const uint32_t id = round % kObjects;
        const Bounds from = box_at(draw.vector(2), 0.01, draw), to = box_at(draw.vector(3), 0.5, draw);
        const Shaft shaft(from, to);
        const CsgSide side = ShaftSides(*scene, shaft).side(id);
        if (side == CsgSide::varies) continue;
        ++(side == CsgSide::inside ? inside : outside)[id % 6];
        const Instance& instance = scene->instances[id];
        for (int i = 0; i < 20; ++i) {
            Ray ray;
            ray.origin = in(from, draw), ray.dir = in(to, draw) - ray.origin, ray.tmin = 0, ray.tmax = 1;
            ASSERT_FALSE(scene->set->occluded(std::span(&id, 1), ray, work)) << id;
            const Geometry& geometry = scene->geometries[instance.geometry];
            ASSERT_TRUE(!geometry.ops->solid(*geometry.source) || geometry.ops->inside(*geometry.source, instance.local(ray.origin)) == (side == CsgSide::inside)) << id;
        }
    }
    for (const int kind : {0, 1, 2, 3, 4}) EXPECT_GT(inside[kind], 20) << kind;
    for (const int kind : {0, 1, 2, 4, 5}) EXPECT_GT(outside[kind], 20) << kind;   // cylinders are not moved: the shaft itself is asked of their boxes
    EXPECT_EQ(inside[5], 0);
}

/// What is turned fills less of the world than the box around it: a rod from corner to corner of that box.
TEST(ShaftSides, OfWhatIsTurned) {
    SceneBuilder b;
    b.object(Box{{-0.1, -9, -0.1}, {0.1, 9, 0.1}}, b.material(b.lambert(Color(1))), Transform::rotate({0, 0, 1}, kPi / 4));
    const auto scene = compiled(b.scene);
    const auto side = [&](const Vec3& from, const Vec3& to) {
        const Shaft shaft({from - Vec3(1e-15), from + Vec3(1e-15)}, {to - Vec3(0.1), to + Vec3(0.1)});
        EXPECT_TRUE(shaft.meets(scene->instances[0].bounds));
        return ShaftSides(*scene, shaft).side(0);
    };
    EXPECT_EQ(side({3, 4, 0}, {-1, 8, 0}), CsgSide::outside);
    EXPECT_EQ(side({3, 4, 0}, {-5, -4, 0}), CsgSide::varies);
    EXPECT_EQ(side({-3, 4, 0}, {-3, 1, 0}), CsgSide::varies);
}

/// Of a ball more is known than of its box: here shafts pass by its edge, near and far, and meet the box.
TEST(ShaftSides, OfBalls) {
    SceneBuilder b;
    b.object(Sphere{{1, 2, 3}, 2}, b.material(b.lambert(Color(1))));
    const auto scene = compiled(b.scene);
    WorkCounters work;
    const uint32_t id = 0;
    int known = 0, missed = 0;
    Draw draw(3);
    for (int round = 0; round < 4000; ++round) {
        const Vec3 towards = draw.direction(), across = normalized(cross(towards, draw.direction())), middle = Vec3(1, 2, 3) + across * draw(1.9, 2.6);
        const Bounds from = box_at(middle - towards * draw(0, 9), 1e-9, draw), to = box_at(middle + towards * draw(-3, 30), draw(0, 0.4), draw);
        const Shaft shaft(from, to);
        const bool outside = ShaftSides(*scene, shaft).side(0) == CsgSide::outside;
        bool any = false;
        for (int i = 0; i < 200; ++i) {
            Ray ray;
            const auto at = [&](const Bounds& box) { return i < 64 ? Vec3(i & 1 ? box.min.x : box.max.x, i & 2 ? box.min.y : box.max.y, i & 4 ? box.min.z : box.max.z) : in(box, draw); };
            ray.origin = at(from), ray.dir = at(to) - ray.origin, ray.tmin = 0, ray.tmax = 1;
            any = any || scene->set->occluded(std::span(&id, 1), ray, work);
        }
        ASSERT_FALSE(any && outside);
        known += outside, missed += !any;
    }
    EXPECT_GT(known, 1000);
    EXPECT_GT(known, 0.8 * missed) << "nearly all that is missed is known";
}

/// A plane that rays start on is left, not one beside it.
TEST(ShaftSides, OfAPlaneThatIsStoodOn) {
    SceneBuilder b;
    const MaterialId plain = b.material(b.lambert(Color(1)));
    b.object(Plane{{0, 1, 0}, 0}, plain);
    b.object(Sphere{}, plain);
    const auto scene = compiled(b.scene);
    const auto leaves = [&](double height, uint32_t id) {
        const Shaft shaft({Vec3(-1e-15), Vec3(1e-15)}, {{-1, height - 1, -1}, {1, height + 1, 1}});
        EXPECT_EQ(ShaftSides(*scene, shaft).side(id), CsgSide::varies);
        const CsgSide stood_on = ShaftSides(*scene, shaft, 0).side(id);
        EXPECT_EQ(stood_on, id != 0 || std::abs(height) < 1 ? CsgSide::varies : height > 0 ? CsgSide::outside : CsgSide::inside);
        return ShaftSides(*scene, shaft).leaves_plane(id);
    };
    EXPECT_TRUE(leaves(3, 0));
    EXPECT_TRUE(leaves(-3, 0));
    EXPECT_FALSE(leaves(0.5, 0));
    EXPECT_FALSE(leaves(3, 1));
}

}  // namespace
}  // namespace alidade::test
