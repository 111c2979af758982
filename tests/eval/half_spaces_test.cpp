// SPDX-License-Identifier: Apache-2.0
/// What planes enclose.
#include "eval/csg.h"
#include "eval/half_spaces.h"
#include "tests/eval/csg_leaves.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

bool inside(const std::vector<HalfSpace>& planes, const Vec3& p) {
    return std::ranges::all_of(planes, [&](const HalfSpace& h) { return dot(h.normal, p) <= h.offset; });
}

bool endless(const Bounds& box) { return box.min == Vec3(-kInf) && box.max == Vec3(kInf); }

void expect_box(const Bounds& box, const Vec3& low, const Vec3& high, double slack) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(box.min[axis], low[axis]);
        EXPECT_GE(box.max[axis], high[axis]);
        EXPECT_NEAR(box.min[axis], low[axis], slack);
        EXPECT_NEAR(box.max[axis], high[axis], slack);
    }
}

std::vector<HalfSpace> octahedron(const Vec3& center, double size) {
    std::vector<HalfSpace> out;
    for (int i = 0; i < 8; ++i) {
        const Vec3 normal(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        out.push_back({normal, size + dot(normal, center)});
    }
    return out;
}

TEST(HalfSpaces, AnOctahedronHasItsCornersOnTheAxes) {
    for (const double size : {1e-6, 1.0, 1e6}) {
        expect_box(box_of_corners(octahedron(Vec3(0), size)), Vec3(-size), Vec3(size), 1e-8 * size);
        const Vec3 away = Vec3(3, -5, 7) * size;
        expect_box(box_of_corners(octahedron(away, size)), away - Vec3(size), away + Vec3(size), 1e-7 * size);
    }
}

/// The apex of a pyramid at the origin: planes through it have the offset 0.
TEST(HalfSpaces, AnApexAtTheOriginCounts) {
    const std::vector<HalfSpace> pyramid{{{1, 1, 0}, 0}, {{-1, 1, 0}, 0}, {{0, 1, 1}, 0}, {{0, 1, -1}, 0}, {{0, -1, 0}, 2}};
    expect_box(box_of_corners(pyramid), {-2, -2, -2}, {2, 0, 2}, 1e-8);
}

TEST(HalfSpaces, WhatHasNoEndHasNoBox) {
    std::vector<HalfSpace> open = octahedron(Vec3(0), 1);
    open.erase(open.begin(), open.begin() + 4);   // those to one side of z
    EXPECT_TRUE(endless(box_of_corners(open)));
    EXPECT_TRUE(endless(box_of_corners(std::vector<HalfSpace>{{{1, 1, 0}, 1}, {{-1, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 1, 0}, 5}}))) << "a prism without ends";
    EXPECT_TRUE(endless(box_of_corners(std::vector<HalfSpace>{{{1, 0, 0}, -1}, {{-1, 0, 0}, -1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}}))) << "nothing";
    EXPECT_TRUE(endless(box_of_corners({})));
    EXPECT_TRUE(endless(box_of_corners(std::vector<HalfSpace>(4, {{0, 0, 0}, 1}))));
}

TEST(HalfSpaces, NothingIsLost) {
    test::Draw draw(7);
    int finite = 0, points = 0;
    for (int round = 0; round < 2000; ++round) {
        std::vector<HalfSpace> planes;
        const int count = 4 + int(draw.below(9));
        for (int i = 0; i < count; ++i) planes.push_back({draw.vector(1), draw(-0.2, 1)});
        const Bounds box = box_of_corners(planes);
        finite += box.finite();
        for (int i = 0; i < 200; ++i) {
            const Vec3 p = draw.vector(i < 100 ? 1 : 10);
            if (!inside(planes, p)) continue;
            ++points;
            for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(box.min[axis] <= p[axis] && p[axis] <= box.max[axis]) << "round " << round;
        }
    }
    EXPECT_GT(finite, 500);
    EXPECT_GT(points, 10'000);
}

/// Planes that no two of which make a box: the tree has one, and says that POV-Ray has none.
TEST(HalfSpaces, SetsOfPlanesHaveBoxes) {
    test::ShapeLeaves leaves;
    const auto half_spaces = [&](uint32_t id) -> std::optional<HalfSpace> {
        const auto* plane = std::get_if<Plane>(&leaves.shapes[id]);
        if (!plane) return std::nullopt;
        return HalfSpace{plane->normal, plane->distance * length(plane->normal)};
    };
    std::vector<CsgExpression> parts{leaves.add(Sphere{Vec3(0.9, 0, 0), 0.3})};
    parts[0] = test::inverse(parts[0]);
    for (const HalfSpace& h : octahedron(Vec3(0), 1)) parts.push_back(test::inverse(leaves.add(Plane{-h.normal, -h.offset / length(h.normal)})));
    const CsgExpression octahedral = test::of(CsgOp::intersection, parts);
    const CsgTree tree(octahedral, leaves.narrow(), {}, half_spaces);
    expect_box(tree.bounds(), Vec3(-1), Vec3(1), 1e-8);
    EXPECT_FALSE(tree.bounds_by_sides().finite());
    EXPECT_FALSE(CsgTree(octahedral, leaves.narrow()).bounds().finite());
    const CsgTree both(test::of(CsgOp::merge, {octahedral, leaves.add(Sphere{Vec3(0, 3, 0), 1})}), leaves.narrow(), {}, half_spaces);
    expect_box(both.bounds(), Vec3(-1), {1, 4, 1}, 1e-8);
}

}  // namespace
}  // namespace alidade
