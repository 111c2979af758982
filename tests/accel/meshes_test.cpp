// SPDX-License-Identifier: Apache-2.0
/// The meshes and rays are what they claim: a leak test on an open mesh would say nothing, nor one with rays that miss.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"

#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

TEST(Meshes, HaveTheTrianglesTheyPromise) {
    EXPECT_EQ(geodesic_sphere(4).triangles.size(), 320u);
    EXPECT_EQ(geodesic_sphere(4).vertices.size(), 162u);  // Euler: V = T / 2 + 2
    EXPECT_EQ(cube(5).triangles.size(), 300u);
    EXPECT_EQ(cube(5).vertices.size(), 152u);
    EXPECT_EQ(torus(16, 10).triangles.size(), 320u);
    EXPECT_EQ(torus(16, 10).vertices.size(), 160u);  // genus 1: V = T / 2
    EXPECT_EQ(tetrahedra(60, 1).triangles.size(), 240u);
    EXPECT_EQ(cube_lattice(2, 3, 4).triangles.size(), 288u);
    for (const TriangleMesh& mesh : small_meshes()) EXPECT_LE(mesh.triangles.size(), 320u) << mesh.name;
}

TEST(Meshes, ClosedOnesAreClosed) {
    for (const TriangleMesh& mesh : closed_meshes()) {
        EXPECT_TRUE(is_closed(mesh)) << mesh.name;
        EXPECT_FALSE(mesh.inside.empty()) << mesh.name;
    }
    EXPECT_TRUE(is_closed(tetrahedra(60, 1)));
    EXPECT_TRUE(is_closed(cube_lattice(2, 3, 4)));
    EXPECT_FALSE(is_closed(soup(300, 0.3, 2)));
    TriangleMesh open = geodesic_sphere(4);
    open.triangles.pop_back();
    EXPECT_FALSE(is_closed(open));
}

/// How often the surface winds around `p`: the sum of the solid angles of its triangles over 4 pi.
/// Source   van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng. 30(2), 1983.
double winding_number(const TriangleMesh& mesh, const Vec3& p) {
    double sum = 0;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 a = normalized(mesh.corner(i, 0) - p), b = normalized(mesh.corner(i, 1) - p), c = normalized(mesh.corner(i, 2) - p);
        sum += std::atan2(dot(a, cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
    }
    return sum / (2 * kPi);
}

/// What a leak test rests on: a ray from a point that is wound around once must hit.
TEST(Meshes, InteriorBoxIsInside) {
    for (const TriangleMesh& mesh : closed_meshes()) {
        const TriangleMesh rounded = mesh.read_at(Precision::float_);
        const Bounds& box = mesh.inside;
        for (int c = 0; c < 8; ++c) {
            const Vec3 corner(c & 1 ? box.max.x : box.min.x, c & 2 ? box.max.y : box.min.y, c & 4 ? box.max.z : box.min.z);
            EXPECT_NEAR(winding_number(rounded, corner), 1, 1e-6) << mesh.name << ", corner " << c;
        }
        const Vec3 outside = mesh.bounds().max + mesh.bounds().extent();
        EXPECT_NEAR(winding_number(rounded, outside), 0, 1e-6) << mesh.name;
    }
}

TEST(RayClasses, HitAsOftenAsTheyPromise) {
    for (const RayClass& rays : ray_classes()) {
        size_t hits = 0, count = 0;
        for (const TriangleMesh& source : small_meshes()) {
            const TriangleMesh mesh = source.read_at(Precision::float_);
            const auto brute = brute_force(mesh, Precision::float_);
            for (size_t i = 0; i < 300; ++i, ++count) hits += is_occluded(*brute, rays.make(mesh, RandomKey(7, 0, i)));
        }
        EXPECT_GE(double(hits), rays.least_hits * double(count)) << rays.name;
    }
}

}  // namespace
}  // namespace alidade::test
