// SPDX-License-Identifier: Apache-2.0
/// Which rays see what is bounded, beside distances of lines and points from balls.
#include "eval/bound_tests.h"

#include "eval/bounded_paths.h"

#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

constexpr NodeId kSet{0}, kBox{1}, kHole{2}, kBall{3};

/// A box less a ball, and one more ball, which bounds what the test says.
struct BoundedScene {
    BoundedScene() {
        scene.shapes.resize(3), scene.nodes.resize(4);
        scene.shapes[0].geometry = Box(), scene.shapes[1].geometry = Sphere{Vec3(0), 0.9}, scene.shapes[2].geometry = Sphere{center, radius};
        scene.nodes[0].csg = CsgKind::difference, scene.nodes[0].children = {kBox, kHole}, scene.nodes[0].to_parent = Transform::translate({0.1, 0.2, 0.3}) * Transform::scale({1, -1.5, 0.7});
        for (uint32_t i = 0; i < 3; ++i) scene.nodes[i + 1].what = ShapeId{i};
        scene.nodes[2].to_parent = Transform::translate({0.5, 0.5, -1});
    }
    std::optional<FoundSurface> first(const Ray& ray) {
        MeshAccelerators meshes(scene);
        return SolidQuery(scene, kSet, meshes).first(ray);
    }
    const Vec3 center{0.2, 0.3, -0.4};
    const double radius = 0.8;
    Scene scene;
};

struct Rays {
    double number(double size) { return std::uniform_real_distribution<double>(-size, size)(random); }
    Vec3 point(double size) { return {number(size), number(size), number(size)}; }
    /// Some begin in the ball, some go away from it.
    Ray next() {
        const Vec3 origin = point(3);
        return {origin, (point(1) - origin) * (number(1) < -0.6 ? -1.0 : 1.0)};
    }
    std::mt19937 random{4711};
};

/// Does it begin in the ball or come to it? By the point of the ray that is nearest to the middle.
bool comes_to(const Ray& ray, const Vec3& center, double radius) {
    const double t = std::max(0.0, dot(center - ray.origin, ray.dir) / dot(ray.dir, ray.dir));
    return length(ray.at(t) - center) <= radius;
}

TEST(BoundTests, ARayThatMissesWhatBoundsASolidMissesTheSolid) {
    BoundedScene free, bounded;
    bounded.scene.nodes[0].bounds = {kBall};
    const auto to_set = inverse(bounded.scene.nodes[0].to_parent);
    Rays rays;
    int lost = 0, seen = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = rays.next();
        const auto met = free.first(ray), got = bounded.first(ray);
        const bool passes = comes_to(to_set->ray(ray), bounded.center, bounded.radius);
        ASSERT_EQ(got.has_value(), met.has_value() && passes) << "ray " << i;
        if (got) {
            ASSERT_EQ(got->t, met->t) << "ray " << i;
        }
        lost += met && !got, seen += got.has_value();
    }
    EXPECT_GT(lost, 50);
    EXPECT_GT(seen, 50);
}

/// The hole stays: such a ray goes through it, and does not see its wall.
TEST(BoundTests, WhatIsInsideOfABoundedPartStaysInside) {
    BoundedScene free, bounded;
    bounded.scene.nodes[2].bounds = {kBall};
    Rays rays;
    const auto to_hole = inverse(bounded.scene.nodes[0].to_parent * bounded.scene.nodes[2].to_parent);
    int walls = 0;
    for (int i = 0; i < 2000; ++i) {
        Ray ray = rays.next();
        const bool passes = comes_to(to_hole->ray(ray), bounded.center, bounded.radius);
        auto want = free.first(ray);
        while (want && !passes && want->shape.index == 1) ++walls, ray.tmin = std::nextafter(want->t, kInf), want = free.first(ray);
        ray.tmin = 0;
        const auto got = bounded.first(ray);
        ASSERT_EQ(got.has_value(), want.has_value()) << "ray " << i;
        if (got) {
            ASSERT_NEAR(got->t, want->t, 1e-9) << "ray " << i;
        }
    }
    EXPECT_GT(walls, 20);
}

TEST(BoundTests, WhatHoldsAllIsNotAskedFor) {
    BoundedScene bounded;
    Scene& scene = bounded.scene;
    scene.nodes[1].bounds = {kBall};
    const Bounds box{Vec3(-1), Vec3(1)};
    const auto test = [&](const ShapeGeometry& shape, bool boxes = false) {
        scene.shapes[2].geometry = shape;
        BoundTests tests(scene);
        return boxes ? tests.in_box(kNoId, tests.kept_box({kBox}, Transform()), box) : tests.by_shapes({kBox}, Transform(), box);
    };
    EXPECT_EQ(test(Box()), kNoId);
    EXPECT_EQ(test(Sphere{Vec3(0), 1.733}), kNoId);
    EXPECT_NE(test(Sphere{Vec3(0), 1.731}), kNoId);
    EXPECT_EQ(test(Sphere{Vec3(0), 1.001}, true), kNoId);
    EXPECT_NE(test(Sphere{Vec3(0), 0.999}, true), kNoId);
    EXPECT_EQ(test(Cylinder{Vec3(0, -1, 0), Vec3(0, 1, 0), 1.42}), kNoId);
    EXPECT_NE(test(Torus{Vec3(0), 3, 2.9}), kNoId) << "which has a hole";
    EXPECT_EQ(test(Sphere{Vec3(2, 0, 0), 1.5}, true), kNoId) << "the larger box does not count";
    EXPECT_FALSE(BoundTests::bounded(scene, {kSet}));
    EXPECT_TRUE(BoundTests::bounded(scene, {kSet, kBox}));
}

/// Boxes are met as balls are, but by their corners, and behind the origin they are not.
TEST(BoundTests, ABoxIsMetAheadAlone) {
    BoundedScene bounded;
    bounded.scene.nodes[1].bounds = {kBall};
    BoundTests tests(bounded.scene);
    const uint32_t test = tests.in_box(kNoId, tests.kept_box({kBox}, Transform()), {Vec3(-2), Vec3(2)});
    ASSERT_NE(test, kNoId);
    EXPECT_TRUE(tests.passes(test, {{0.9, 1.0, -5}, {0, 0, 1}}));
    EXPECT_FALSE(tests.passes(test, {{1.1, 1.0, -5}, {0, 0, 1}}));
    EXPECT_FALSE(tests.passes(test, {{0.9, 1.0, -5}, {0, 0, -1}}));
    EXPECT_TRUE(tests.passes(test, {{0.9, 1.0, 0}, {0, 0, -1}}));
    EXPECT_TRUE(tests.passes(kNoId, {{0.9, 1.0, -5}, {0, 0, -1}}));
}

/// Unions in one another, each of them bounded: what is deep in them shares the tests of all around it, and the paths to it are stored once.
TEST(BoundTests, WhatIsDeepInBoundsSharesTests) {
    constexpr uint32_t kLevels = 200;
    Scene scene;
    scene.shapes.resize(2);
    scene.shapes[0].geometry = Sphere{Vec3(0), 1}, scene.shapes[1].geometry = Sphere{Vec3(0), 0.5};
    const auto add = [&](Node node) { scene.nodes.push_back(std::move(node)); return NodeId{uint32_t(scene.nodes.size() - 1)}; };
    const auto ball = [&](uint32_t shape) { Node node; node.what = ShapeId{shape}; return add(std::move(node)); };
    const NodeId bound = ball(1);
    std::vector<NodeId> unions, balls;
    NodeId inner = ball(0);
    for (uint32_t i = 0; i < kLevels; ++i) {
        Node node;
        balls.push_back(ball(0));
        node.csg = CsgKind::union_, node.whole = true, node.children = {inner, balls.back()}, node.bounds = {bound};
        inner = add(std::move(node));
        unions.push_back(inner);
    }
    BoundedPaths paths;
    std::vector<std::vector<NodeId>> wanted;
    for (uint32_t i = 0; i < kLevels; ++i) {                        // the outermost union comes first
        std::vector<NodeId> path(unions.rbegin(), unions.rbegin() + i + 1);
        path.push_back(balls[kLevels - 1 - i]);
        paths.add(i, path), wanted.push_back(path);
    }
    BoundTests tests(scene);
    const Bounds surface{Vec3(-1), Vec3(1)};
    paths.for_each([&](uint32_t i, const std::vector<NodeId>& path) {
        EXPECT_EQ(path, wanted[i]);
        EXPECT_EQ(tests.by_shapes(path, Transform(), surface), i);  // one more than the union around it asks
    });
    EXPECT_TRUE(tests.passes(kLevels - 1, {Vec3(0, 0.4, -3), Vec3(0, 0, 1)}));
    EXPECT_FALSE(tests.passes(kLevels - 1, {Vec3(0, 0.6, -3), Vec3(0, 0, 1)}));
}

}  // namespace
}  // namespace alidade
