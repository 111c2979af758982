// SPDX-License-Identifier: Apache-2.0
/// Subdivision keeps what it must: counts, topology, flatness, the hull of the net; seams of attributes; and it converges to known surfaces.
#include "tests/topology/surfaces.h"
#include "topology/report.h"
#include "topology/subdivide.h"
#include "topology/weld.h"

#include <set>

namespace alidade {
namespace {

using topology::examine;
using topology::subdivide;
using topology::SurfaceReport;

Mesh subdivided(const Mesh& mesh, int levels) {
    auto made = subdivide(mesh, levels);
    EXPECT_TRUE(made) << (made ? "" : made.error());
    if (!made) return {};
    EXPECT_EQ(made->triangles.size(), topology::subdivided_triangles(mesh, levels));
    Scene scene;
    scene.shapes.push_back({"made", *made, {}});
    EXPECT_FALSE(validate(scene).has_errors()) << validate(scene).text();
    return std::move(*made);
}

/// The cube with its six sides as polygons.
Mesh square_cube() {
    Mesh mesh = cube();
    for (uint32_t f = 0; f < 6; ++f) mesh.faces.insert(mesh.faces.end(), 2, f);
    return mesh;
}

TEST(Loop, CountsAndTopology) {
    for (const Mesh& mesh : {octahedron(), cube(), torus(7, 5), sphere(12, 6), sphere(12, 6, 2), together(cube(), torus(5, 4))}) {
        const SurfaceReport before = examine(mesh), after = examine(subdivided(mesh, 1));
        EXPECT_EQ(after.vertices, before.vertices + before.edges);
        EXPECT_EQ(after.triangles, 4 * (before.triangles - before.degenerate));
        EXPECT_EQ(after.euler(), before.euler());
        EXPECT_EQ(after.holes, before.holes);
        EXPECT_EQ(after.genus(), before.genus());
        EXPECT_EQ(after.refused, 0u);
    }
}

TEST(CatmullClark, CountsAndTopology) {
    const SurfaceReport r = examine(subdivided(square_cube(), 1));
    EXPECT_EQ(r.vertices, 8u + 12u + 6u) << "V + E + F of the polygons";
    EXPECT_EQ(r.triangles, 48u);
    EXPECT_EQ(r.genus(), 0);
    EXPECT_EQ(examine(subdivided(square_cube(), 3)).triangles, 48u * 16u);
}

/// All masks are convex combinations: nothing leaves the hull. Along any direction the support never grows.
TEST(Subdivision, StaysInTheHull) {
    std::mt19937 random(3);
    std::normal_distribution<double> any;
    for (const Mesh& mesh : {octahedron(), square_cube(), torus(7, 5), sphere(12, 6, 2)}) {
        const Mesh fine = subdivided(mesh, 2);
        for (int i = 0; i < 100; ++i) {
            const Vec3 way = normalized(Vec3(any(random), any(random), any(random)));
            const auto support = [&](const Mesh& m) {
                double most = -kInf;
                for (const Vec3f& p : m.positions) most = std::max(most, dot(way, Vec3(p)));
                return most;
            };
            EXPECT_LE(support(fine), support(mesh) + 1e-6);
        }
    }
}

Mesh flat_grid(bool quads) {
    Mesh mesh = grid(6, 6, [](double u, double v) { return Vec3(6 * u, 6 * v, 2 * u - v + 0.5); }, true);
    for (uint32_t f = 0; quads && f < 36; ++f) mesh.faces.insert(mesh.faces.end(), 2, f);
    return mesh;
}

/// A plane stays that plane, and inside a regular net its vertices stay on the finer lattice.
TEST(Subdivision, APlaneStaysAPlane) {
    for (const bool quads : {false, true}) {
        const Mesh fine = subdivided(flat_grid(quads), 2);
        size_t inside = 0;
        for (const Vec3f& p : fine.positions) {
            EXPECT_NEAR(double(p.z), double(p.x) / 3 - double(p.y) / 6 + 0.5, 1e-6);
            if (p.x < 1 || p.x > 5 || p.y < 1 || p.y > 5) continue;
            EXPECT_NEAR(4 * double(p.x), std::round(4 * double(p.x)), 1e-5);
            EXPECT_NEAR(4 * double(p.y), std::round(4 * double(p.y)), 1e-5);
            ++inside;
        }
        EXPECT_EQ(inside, 17u * 17u);
    }
}

/// Texture coordinates are interpolated linearly: on a plane mapped linearly they stay in step with the vertices, away from the rounded border.
TEST(Subdivision, TextureCoordinatesStayInStep) {
    for (const bool quads : {false, true}) {
        const Mesh fine = subdivided(flat_grid(quads), 2);
        ASSERT_EQ(fine.uvs.size(), 1u);
        for (size_t t = 0; t < fine.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) {
                const Vec3 p = corner_point(fine, t, k);
                const Vec2f uv = fine.uvs[0].values[fine.uvs[0].index(t, k, fine.triangles[t])];
                if (std::min(p.x, p.y) < 1 || std::max(p.x, p.y) > 5) continue;
                EXPECT_NEAR(uv.x, p.x / 6, 1e-6);
                EXPECT_NEAR(uv.y, p.y / 6, 1e-6);
            }
    }
}

/// Each side of the cube has the same square of the texture: each seam stays one, and its two sides keep their own coordinates.
TEST(Subdivision, SeamsStaySeams) {
    for (const bool quads : {false, true}) {
        Mesh mesh = quads ? square_cube() : cube();
        Attribute<Vec2f> uv;
        for (size_t t = 0; t < 12; ++t)
            for (const Vec2f& v : t % 2 == 0 ? std::array{Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1)} : std::array{Vec2f(0, 0), Vec2f(1, 1), Vec2f(0, 1)}) {
                uv.corners.push_back(uint32_t(uv.values.size()));
                uv.values.push_back(v);
            }
        mesh.uvs = {uv};
        mesh.slots = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
        const Mesh fine = subdivided(mesh, 2);
        std::vector<double> area(6, 0);
        for (size_t t = 0; t < fine.triangles.size(); ++t) {
            const auto at = [&](int k) { return Vec2(fine.uvs[0].values[fine.uvs[0].index(t, k, fine.triangles[t])]); };
            const Vec2 a = at(1) - at(0), b = at(2) - at(0);
            EXPECT_NEAR(a.x * b.y - a.y * b.x, 1.0 / 16, 1e-6) << "each piece has its part of the texture, and none is turned";
            area[fine.slots[t]] += (a.x * b.y - a.y * b.x) / 2;
        }
        for (const double side : area) EXPECT_NEAR(side, 1, 1e-5) << "each material still has a whole square";
    }
}

/// The border is a cubic B-spline: two subdivisions of a border with control points P have its points as known masks.
/// Source   a uniform cubic B-spline refines by (1, 6, 1)/8 and (1, 1)/2.
TEST(Subdivision, BordersAreCubicBSplines) {
    for (const bool quads : {false, true}) {
        Mesh mesh = flat_grid(quads);
        std::vector<double> wave;
        for (int i = 0; i <= 6; ++i) wave.push_back(double(i * i % 5));
        for (int i = 0; i <= 6; ++i) mesh.positions[size_t(i)] = Vec3f(float(i), -1.f, float(wave[size_t(i)]));   // the border v = 0, at y = -1
        const Mesh fine = subdivided(mesh, 1);
        std::set<std::pair<double, double>> got;
        for (const Vec3f& p : fine.positions)
            if (p.y == -1) got.insert({p.x, p.z});
        for (size_t i = 1; i < 6; ++i) EXPECT_TRUE(got.count({double(i), (wave[i - 1] + 6 * wave[i] + wave[i + 1]) / 8})) << i << (quads ? " quads" : "");
        for (size_t i = 0; i < 6; ++i) EXPECT_TRUE(got.count({double(i) + 0.5, (wave[i] + wave[i + 1]) / 2})) << i;
    }
}

/// The tip of an octahedron goes to its limit under Loop's scheme: with n = 4 neighbours, weight w = 1 / (n + 3 / (8 beta)) each, beta as the mask has it.
/// Source   Hoppe et al., "Piecewise Smooth Surface Reconstruction", SIGGRAPH 1994, section 3 (limit masks).
TEST(Loop, ConvergesToTheLimitOfTheOctahedron) {
    const double n = 4, beta = (40 - std::pow(3 + 2 * std::cos(2 * kPi / n), 2)) / 64 / n, omega = 1 / (n + 3 / (8 * beta));
    const double limit = 1 - n * omega;   // the four neighbours cancel in a plane through the centre
    double most = 0;
    for (const Vec3f& p : subdivided(octahedron(), 7).positions) most = std::max(most, double(p.z));
    EXPECT_NEAR(most, limit, 2e-4);
}

/// The corner of a cube goes to its limit under Catmull and Clark's: (n^2 v + 4 sum edges + sum faces) / (n (n + 5)).
/// Source   Halstead, Kass and DeRose, "Efficient, Fair Interpolation using Catmull-Clark Surfaces", SIGGRAPH 1993, section 2.
TEST(CatmullClark, ConvergesToTheLimitOfTheCube) {
    const double n = 3;   // with the centre as origin: the corner at (1, 1, 1)/2, its neighbours sum to (1, 1, 1)/2, those across its sides to -(1, 1, 1)/2
    const double limit = 0.5 * (n * n * 1 + 4 * 1 + 1 * -1) / (n * (n + 5));
    double most = 0;
    for (const Vec3f& p : subdivided(square_cube(), 6).positions)
        if (std::abs(p.x - p.y) < 1e-6f && std::abs(p.y - p.z) < 1e-6f) most = std::max(most, double(p.x) - 0.5);
    EXPECT_NEAR(most, limit, 2e-4);
}

/// OpenMesh's table of weights has 50 rows: a vertex with more neighbours must not read beyond it. The tip of a cone sinks by Loop's weight.
TEST(Loop, ManyTrianglesAroundAVertex) {
    std::vector<Vec3> points{{0, 0, 1}};
    std::vector<Index3> triangles;
    const uint32_t n = 400;
    for (uint32_t i = 0; i < n; ++i) {
        points.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0);
        triangles.emplace_back(0, 1 + i, 1 + (i + 1) % n);
    }
    const Mesh fine = subdivided(mesh_from(points, triangles), 1);
    double tip = 0;
    for (const Vec3f& p : fine.positions) tip = std::max(tip, double(p.z));
    EXPECT_NEAR(tip, 1 - (40 - std::pow(3 + 2 * std::cos(2 * kPi / n), 2)) / 64, 1e-6);
}

TEST(Subdivision, PolygonsAreFoundInTheirTriangles) {
    Mesh pentagon = mesh_from({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
    pentagon.faces = {4, 4, 4};
    EXPECT_EQ(subdivided(pentagon, 1).triangles.size(), 10u) << "five quads";
    Mesh with_hole = grid(3, 3, [](double u, double v) { return Vec3(u, v, 0); });
    with_hole.triangles.erase(with_hole.triangles.begin() + 8, with_hole.triangles.begin() + 10);
    with_hole.faces.assign(with_hole.triangles.size(), 0);
    EXPECT_EQ(subdivided(with_hole, 1).triangles.size(), 4 * with_hole.triangles.size()) << "a face that is no polygon stands for its triangles";
}

TEST(Subdivision, WhatItCannotDoIsRefused) {
    for (const Mesh& mesh : {together(cube(), cube(Vec3(1))), moebius(8), together(cube(), cube(Vec3(1, 1, 0)))}) {
        const auto made = subdivide(mesh, 1);
        ASSERT_FALSE(made);
        EXPECT_NE(made.error().find("manifold"), std::string::npos);
    }
    Mesh morphed = cube();
    morphed.morphs.emplace_back();
    EXPECT_FALSE(subdivide(morphed, 1));
}

TEST(Subdivision, AnyMessIsDoneOrRefused) {
    size_t done = 0;
    for (uint32_t seed = 0; seed < 400; ++seed) {
        Mesh mesh = mess(seed, 4 + int(seed % 40), int(seed % 12));
        for (uint32_t t = 0; seed % 2 && t < mesh.triangles.size(); ++t) mesh.faces.push_back(t / 2);
        const auto made = subdivide(mesh, 2);
        if (!made) continue;
        ++done;
        EXPECT_EQ(made->triangles.size(), topology::subdivided_triangles(mesh, 2));
    }
    EXPECT_GT(done, 20u);
}

}  // namespace
}  // namespace alidade
