// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tests/scene/sample_scene.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

void expect_box(const Bounds& got, const Vec3& min, const Vec3& max) {
    EXPECT_LT(length(got.min - min), 1e-11);
    EXPECT_LT(length(got.max - max), 1e-11);
}

TEST(ShapeBounds, OfEachKind) {
    expect_box(bounds(Sphere{Vec3(1, 2, 3), -2}), Vec3(-1, 0, 1), Vec3(3, 4, 5));
    expect_box(bounds(Box{Vec3(1, -2, 3), Vec3(0, 2, -3)}), Vec3(0, -2, -3), Vec3(1, 2, 3));
    EXPECT_EQ(bounds(Plane()).min, Vec3(-kInf));
    EXPECT_EQ(bounds(Plane()).max, Vec3(kInf));
    EXPECT_TRUE(bounds(Mesh()).empty());
}

TEST(ShapeBounds, OfTheTrianglesThatCanBeHit) {
    Mesh mesh;
    mesh.origin = Vec3(1e6, 0, 0);
    mesh.positions = {Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(9, 9, 9), Vec3f(std::numeric_limits<float>::quiet_NaN(), 5, 5)};
    mesh.triangles = {Index3(0, 1, 2), Index3(0, 3, 4)};
    expect_box(bounds(mesh), Vec3(1e6, 0, 0), Vec3(1e6 + 1, 1, 0));
    mesh.exact_positions = {Vec3(0.1), Vec3(1.1, 0, 0), Vec3(0, 1, 0), Vec3(9), Vec3(9)};
    expect_box(bounds(mesh), Vec3(1e6, 0, 0), Vec3(1e6 + 9, 9, 9));
}

TEST(ShapeBounds, SlotsAreCounted) {
    Mesh mesh;
    EXPECT_EQ(slot_count(mesh), 1u);
    mesh.slots = {0, 5, 2};
    EXPECT_EQ(slot_count(mesh), 6u);
    EXPECT_EQ(slot_count(Sphere()), 1u);
}

TEST(WorldBounds, BoxesOfInstances) {
    std::vector<Node> nodes(4);
    nodes[0].children = {NodeId{1}, NodeId{2}};
    nodes[1].to_parent = Transform::translate({-10, 0, 0});
    nodes[2].to_parent = Transform::translate({10, 0, 0}) * Transform::scale(Vec3(2));
    nodes[1].children = nodes[2].children = {NodeId{3}};
    nodes[3].what = ShapeId{0};
    expect_box(world_bounds(test::scene_of(nodes)), Vec3(-11, -2, -2), Vec3(12, 2, 2));
    nodes[2].flags.visible = false;
    expect_box(world_bounds(test::scene_of(nodes)), Vec3(-11, -1, -1), Vec3(-9, 1, 1));
}

TEST(WorldBounds, WhatIsUnboundedDoesNotCount) {
    Scene scene = test::sample_scene();
    scene.nodes[1].flags.visible = false;
    expect_box(world_bounds(scene), Vec3(-1, -1, 0), Vec3(1, 1, 2));   // the sphere; the plane has no box, clips and lights are not visited
    EXPECT_TRUE(world_bounds(Scene()).empty());
}

TEST(WorldBounds, CostsNodesNotPaths) {
    std::vector<Node> nodes(61);
    for (uint32_t i = 0; i < 60; ++i) {
        nodes[i].children = {NodeId{i + 1}, NodeId{i + 1}};
        nodes[i].to_parent.translation.y = 1;
    }
    nodes[60].what = ShapeId{0};
    expect_box(world_bounds(test::scene_of(nodes)), Vec3(-1, 59, -1), Vec3(1, 61, 1));
}

}  // namespace
}  // namespace alidade
