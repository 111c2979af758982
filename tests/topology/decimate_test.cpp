// SPDX-License-Identifier: Apache-2.0
/// Decimation keeps what it must: the count that was asked for, closedness, the shape, borders, seams and material slots.
#include "tests/core/run_size.h"
#include "tests/topology/surfaces.h"
#include "topology/decimate.h"
#include "topology/half_edges.h"
#include "topology/report.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace alidade {
namespace {

using topology::decimate;
using topology::examine;
using topology::SurfaceReport;

Mesh decimated(const Mesh& mesh, double ratio) {
    auto made = decimate(mesh, ratio);
    EXPECT_TRUE(made) << (made ? "" : made.error());
    if (!made) return {};
    Scene scene;
    scene.shapes.push_back({"made", *made, {}});
    EXPECT_FALSE(validate(scene).has_errors()) << validate(scene).text();
    return std::move(*made);
}

/// The distance from a point to a triangle.
/// Source   Ericson, "Real-Time Collision Detection" (2005), section 5.1.5, by projection on plane, edges and corners.
double distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = normalized(cross(b - a, c - a));
    const Vec3 foot = p - dot(p - a, n) * n;
    const auto outside = [&](const Vec3& u, const Vec3& v) { return dot(cross(v - u, foot - u), n) < 0; };
    if (!outside(a, b) && !outside(b, c) && !outside(c, a)) return length(p - foot);
    const auto to_segment = [&](const Vec3& u, const Vec3& v) { return length(p - u - std::clamp(dot(p - u, v - u) / dot(v - u, v - u), 0.0, 1.0) * (v - u)); };
    return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

double distance(const Vec3& p, const Mesh& mesh) {
    double least = kInf;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) least = std::min(least, distance(p, corner_point(mesh, t, 0), corner_point(mesh, t, 1), corner_point(mesh, t, 2)));
    return least;
}

/// The greatest distance from vertices and triangle centres of one surface to the other, both ways.
double hausdorff(const Mesh& a, const Mesh& b) {
    double most = 0;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        for (size_t t = 0; t < from->triangles.size(); ++t) {
            most = std::max(most, distance((corner_point(*from, t, 0) + corner_point(*from, t, 1) + corner_point(*from, t, 2)) / 3.0, *to));
            most = std::max(most, distance(corner_point(*from, t, 0), *to));
        }
    }
    return most;
}

/// What OpenMesh's own quadric module makes of a closed surface, which has neither borders nor seams to respect.
Mesh by_openmesh(const Mesh& mesh, size_t triangles) {
    topology::HalfEdges edges = topology::half_edges(topology::weld(mesh));
    OpenMesh::Decimater::DecimaterT<topology::TriangleHalfEdges> decimater(edges.mesh);
    OpenMesh::Decimater::ModQuadricT<topology::TriangleHalfEdges>::Handle quadric;
    decimater.add(quadric);
    decimater.initialize();
    decimater.decimate_to_faces(0, triangles);
    edges.mesh.garbage_collection();
    Mesh out;
    for (const auto v : edges.mesh.vertices()) out.positions.emplace_back(topology::from_openmesh(edges.mesh.point(v)));
    for (const auto face : edges.mesh.faces()) {
        std::vector<uint32_t> corners;
        for (const auto v : edges.mesh.fv_range(face)) corners.push_back(uint32_t(v.idx()));
        out.triangles.emplace_back(corners[0], corners[1], corners[2]);
    }
    return out;
}

TEST(Decimation, ASphereStaysClosedRoundAndAsCoarseAsAsked) {
    const Mesh ball = sphere(32, 16);
    const SurfaceReport before = examine(ball);
    for (const double ratio : {0.5, 0.2, 0.1}) {
        if (test::run_scale() < 1 && ratio != 0.2) continue;
        const Mesh coarse = decimated(ball, ratio);
        const SurfaceReport after = examine(coarse);
        const double wanted = ratio * double(before.triangles - before.degenerate);
        EXPECT_LE(double(after.triangles), std::ceil(wanted));
        EXPECT_GE(double(after.triangles), wanted - 2);
        EXPECT_EQ(after.genus(), 0);
        EXPECT_EQ(after.refused + after.degenerate, 0u);
        const double edge = std::sqrt(16 * kPi / std::sqrt(3.0) / double(after.triangles));   // of equal triangles that cover the sphere
        const double distance = hausdorff(ball, coarse);
        EXPECT_LT(distance, 2 * edge * edge / 3) << "how far the centre of a triangle of twice that edge lies inside";
        EXPECT_LT(distance, 1.25 * hausdorff(ball, by_openmesh(ball, after.triangles)));
        for (const Vec3f& p : coarse.positions) EXPECT_NEAR(length(Vec3(p)), 1, 1e-6) << "vertices stay where they were";
    }
}

TEST(Decimation, ATorusStaysATorus) {
    const SurfaceReport r = examine(decimated(torus(48, 24), 0.1));
    EXPECT_EQ(r.genus(), 1);
    EXPECT_LE(r.triangles, 231u);
}

/// A flat square needs two triangles; its border must not move, however far it is taken.
TEST(Decimation, AFlatSquareKeepsItsBorder) {
    const Mesh square = grid(20, 20, [](double u, double v) { return Vec3(u, v, 0); });
    const Mesh coarse = decimated(square, 2.0 / 800);
    EXPECT_EQ(coarse.triangles.size(), 2u);
    double area = 0;
    for (size_t t = 0; t < coarse.triangles.size(); ++t)
        area += cross(corner_point(coarse, t, 1) - corner_point(coarse, t, 0), corner_point(coarse, t, 2) - corner_point(coarse, t, 0)).z / 2;
    EXPECT_NEAR(area, 1, 1e-6);
    EXPECT_EQ(examine(coarse).holes, 1u);
    EXPECT_NEAR(examine(coarse).hole_length, 4, 1e-6);
}

/// What is asked for cannot always be had: a shape that has nothing to spare is kept.
TEST(Decimation, TheShapeComesBeforeTheRatio) {
    for (const Mesh& mesh : {cube(), octahedron(), grid(1, 1, [](double u, double v) { return Vec3(u, v, 0); }), grid(8, 8, [](double u, double v) { return Vec3(u, v, 0); })}) {
        const Mesh coarse = decimated(mesh, 1e-3);
        EXPECT_LT(hausdorff(mesh, coarse), 0.1);
        EXPECT_GE(coarse.triangles.size(), 2u);
    }
}

TEST(Decimation, SizeAndPlaceDoNotMatter) {
    const Mesh ball = sphere(32, 16);
    const Mesh coarse = decimated(ball, 0.25);
    for (const float scale : {0x1p-60f, 0x1p60f}) {
        Mesh scaled = ball;
        for (Vec3f& p : scaled.positions) p *= scale;
        EXPECT_EQ(decimated(scaled, 0.25).triangles, coarse.triangles) << scale;
    }
}

/// Texture coordinates that are a linear function of the place stay that function at every corner, on both sides of the seams.
TEST(Decimation, TextureCoordinatesAndSlotsStayWithTheirSurface) {
    Mesh mesh = grid(24, 24, [](double u, double v) { return Vec3(u, v, 0.2 * std::sin(6 * u) * std::cos(5 * v)); });
    Attribute<Vec2f> uv;
    const auto side = [&](size_t t) { return (corner_point(mesh, t, 0) + corner_point(mesh, t, 1) + corner_point(mesh, t, 2)).x > 1.5; };
    const auto map = [](const Vec3& p, bool right) { return right ? Vec2f(float(1 - p.x), float(p.y)) : Vec2f(float(p.x), float(2 + p.y)); };
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        mesh.slots.push_back(side(t));
        for (int k = 0; k < 3; ++k) {
            uv.corners.push_back(uint32_t(uv.values.size()));
            uv.values.push_back(map(corner_point(mesh, t, k), side(t)));
        }
    }
    mesh.uvs = {uv};
    const Mesh coarse = decimated(mesh, 0.1);
    EXPECT_LE(coarse.triangles.size(), 116u);
    std::array<double, 2> area{};
    for (size_t t = 0; t < coarse.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(coarse.uvs[0].values[coarse.uvs[0].index(t, k, coarse.triangles[t])], map(corner_point(coarse, t, k), coarse.slots[t]));
        area[coarse.slots[t]] += cross(corner_point(coarse, t, 1) - corner_point(coarse, t, 0), corner_point(coarse, t, 2) - corner_point(coarse, t, 0)).z / 2;
    }
    EXPECT_NEAR(area[0], 0.5, 1e-5) << "the seam is straight, and stays where it was";
    EXPECT_NEAR(area[1], 0.5, 1e-5);
}

/// One chart wound around a cylinder, cut along a line where its two ends meet: the ends are on the same chart, and must not be confused.
TEST(Decimation, TheTwoEndsOfAChartAreNotConfused) {
    const Mesh tube = grid(40, 20, [](double u, double v) { return u == 1 ? Vec3(1, 0, 2 * v) : Vec3(std::cos(2 * kPi * u), std::sin(2 * kPi * u), 2 * v); }, true);
    const Mesh coarse = decimated(tube, 0.1);
    EXPECT_LE(coarse.triangles.size(), 160u);
    for (size_t t = 0; t < coarse.triangles.size(); ++t) {
        float least = 1, most = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec2f uv = coarse.uvs[0].values[coarse.uvs[0].index(t, k, coarse.triangles[t])];
            const Vec3 p = corner_point(coarse, t, k);
            EXPECT_NEAR(std::cos(2 * kPi * uv.x), p.x, 1e-5);
            EXPECT_NEAR(2 * uv.y, p.z, 1e-5);
            least = std::min(least, uv.x), most = std::max(most, uv.x);
        }
        EXPECT_LT(most - least, 0.5f) << "a triangle that spans the texture";
    }
}

/// A seam that ends inside: its last vertex has one pair of coordinates, the one before has two. What lies on the left of the slit keeps the left ones.
TEST(Decimation, TheSidesOfASlitAreNotConfused) {
    Mesh mesh = grid(16, 16, [](double u, double v) { return Vec3(u, v, 0); });
    const auto map = [](const Vec3& p, bool right) { return Vec2f(float(p.x + (right && p.y < 0.5 ? 0.5 - p.y : 0)), float(p.y)); };
    Attribute<Vec2f> uv;
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const bool right = (corner_point(mesh, t, 0) + corner_point(mesh, t, 1) + corner_point(mesh, t, 2)).x > 1.5;
            uv.corners.push_back(uint32_t(uv.values.size()));
            uv.values.push_back(map(corner_point(mesh, t, k), right));
        }
    mesh.uvs = {uv};
    const Mesh coarse = decimated(mesh, 0.1);
    EXPECT_LE(coarse.triangles.size(), 52u);
    size_t on_slit = 0;
    for (size_t t = 0; t < coarse.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = corner_point(coarse, t, k);
            const double left = std::min({corner_point(coarse, t, 0).x, corner_point(coarse, t, 1).x, corner_point(coarse, t, 2).x});
            const Vec2f got = coarse.uvs[0].values[coarse.uvs[0].index(t, k, coarse.triangles[t])];
            const bool slit = p.x == 0.5 && p.y < 0.5;
            EXPECT_EQ(got, map(p, slit ? left >= 0.5 : p.x > 0.5));
            on_slit += slit;
        }
    EXPECT_GT(on_slit, 2u);
}

TEST(Decimation, WhatItCannotDoIsRefused) {
    for (const Mesh& mesh : {together(cube(), cube(Vec3(1))), moebius(8)}) {
        const auto made = decimate(mesh, 0.5);
        ASSERT_FALSE(made);
        EXPECT_NE(made.error().find("manifold"), std::string::npos);
    }
    Mesh skinned = cube();
    skinned.joint_sets.push_back({std::vector<Joints4>(8), std::vector<Vec4f>(8, Vec4f(1, 0, 0, 0))});
    EXPECT_FALSE(decimate(skinned, 0.5));
}

TEST(Decimation, OfAll) { EXPECT_EQ(decimated(sphere(16, 8), 1).triangles.size(), 16u * 14u) << "but those without area"; }

TEST(Decimation, AnyMessIsDoneOrRefused) {
    size_t done = 0;
    for (uint32_t seed = 0; seed < 400; ++seed) {
        const Mesh mesh = mess(seed, 4 + int(seed % 40), int(seed % 12));
        if (const auto made = decimate(mesh, 0.3)) {
            ++done;
            EXPECT_LE(made->triangles.size(), mesh.triangles.size());
        }
    }
    EXPECT_GT(done, 20u);
}

}  // namespace
}  // namespace alidade
