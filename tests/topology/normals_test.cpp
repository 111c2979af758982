// SPDX-License-Identifier: Apache-2.0
/// Crease-angle normals: against normals known on paper, and against OpenMesh's, which walks around each corner instead of joining sets.
#include "tests/topology/surfaces.h"
#include "topology/half_edges.h"
#include "topology/normals.h"

#include <map>

namespace alidade {
namespace {

using topology::set_crease_normals;

Vec3 normal_at(const Mesh& mesh, size_t triangle, int corner) {
    return Vec3(mesh.normals.values[mesh.normals.index(triangle, corner, mesh.triangles[triangle])]);
}
Vec3 face_normal(const Mesh& mesh, size_t t) {
    return normalized(cross(corner_point(mesh, t, 1) - corner_point(mesh, t, 0), corner_point(mesh, t, 2) - corner_point(mesh, t, 0)));
}

TEST(CreaseNormals, ACubeIsFlatBelow90AndSmoothFromThere) {
    for (Mesh mesh : {cube(), soup(cube()), cube(Vec3(0.1, -3.7, 1e3))}) {
        set_crease_normals(mesh, 89.9);
        for (size_t t = 0; t < 12; ++t)
            for (int k = 0; k < 3; ++k) EXPECT_LT(length(normal_at(mesh, t, k) - face_normal(mesh, t)), 1e-6);
    }
    for (const double degrees : {90.0, 180.0}) {
        Mesh mesh = cube();
        set_crease_normals(mesh, degrees);
        for (size_t t = 0; t < 12; ++t)
            for (int k = 0; k < 3; ++k)
                EXPECT_LT(length(normal_at(mesh, t, k) - normalized(corner_point(mesh, t, k) - Vec3(0.5))), 1e-6) << "however a side is cut: weighted by angle";
        EXPECT_EQ(mesh.normals.values.size(), 8u);
    }
}

TEST(CreaseNormals, ASphereIsSmoothInsideAndFlatAtItsRim) {
    Mesh mesh = soup(sphere(48, 24, 3));
    set_crease_normals(mesh, 30);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (face_normal(mesh, t) == Vec3(0)) continue;
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = corner_point(mesh, t, k);
            EXPECT_LT(length(normal_at(mesh, t, k) - p), p.z > 0.9 ? 0.15 : 0.02);
        }
    }
}

/// Creases of a roof by its pitch: the two sides meet at twice the pitch.
TEST(CreaseNormals, TheAngleIsBetweenTheTwoNormals) {
    for (const double pitch : {10.0, 20.0, 40.0}) {
        const double rise = std::tan(pitch * kPi / 180);
        const Mesh roof = mesh_from({{0, 0, rise}, {0, 1, rise}, {-1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}});
        for (const double crease : {2 * pitch - 0.01, 2 * pitch + 0.01}) {
            Mesh mesh = roof;
            set_crease_normals(mesh, crease);
            EXPECT_EQ(normal_at(mesh, 0, 0) == normal_at(mesh, 1, 1), crease > 2 * pitch) << pitch;
        }
    }
}

TEST(CreaseNormals, PolygonsOfTheFileHaveNoCreaseInside) {
    Mesh bent = mesh_from({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    Mesh joined = bent;
    joined.faces = {7, 7};
    set_crease_normals(bent, 1);
    set_crease_normals(joined, 1);
    EXPECT_NE(normal_at(bent, 0, 0), normal_at(bent, 1, 0));
    EXPECT_EQ(normal_at(joined, 0, 0), normal_at(joined, 1, 0));
}

TEST(CreaseNormals, SheetsThatAreWoundAgainstEachOtherOrTooManyDoNotMix) {
    Mesh turned = mesh_from({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}});
    set_crease_normals(turned, 180);
    EXPECT_EQ(normal_at(turned, 0, 0), Vec3(0, 0, 1));
    EXPECT_EQ(normal_at(turned, 1, 0), Vec3(0, 0, -1));
    Mesh book = mesh_from({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    set_crease_normals(book, 180);
    for (size_t t = 0; t < 3; ++t) EXPECT_LT(length(normal_at(book, t, 0) - face_normal(book, t)), 1e-6);
}

TEST(CreaseNormals, AnyMessGetsUnitNormals) {
    for (uint32_t seed = 0; seed < 200; ++seed) {
        Mesh mesh = mess(seed, 4 + int(seed % 30), int(seed % 50));
        if (seed % 3 == 0) mesh.positions[0].x = std::numeric_limits<float>::infinity();
        set_crease_normals(mesh, double(seed % 181));
        ASSERT_EQ(mesh.normals.corners.size(), 3 * mesh.triangles.size());
        for (const Vec3f& n : mesh.normals.values) ASSERT_NEAR(length(Vec3(n)), 1, 1e-6);
    }
}

/// A torus with bumps: its edges have all kinds of angles.
Mesh bumpy() {
    std::mt19937 random(5);
    Mesh mesh = torus(30, 20);
    const topology::Welded surface = topology::weld(mesh);
    std::vector<Vec3> moved;
    for (const Vec3& p : surface.points) moved.push_back(p + 0.08 * Vec3(random() % 9, random() % 9, random() % 9) / 4.0);
    return mesh_from(moved, surface.triangles);
}

/// Two corners at a vertex share a normal here if and only if OpenMesh gives them one. (Values differ: OpenMesh weighs all faces alike.)
TEST(CreaseNormals, JoinTheCornersThatOpenMeshJoins) {
    for (const double crease : {5.0, 20.0, 40.0, 55.0}) {
        Mesh mesh = bumpy();
        set_crease_normals(mesh, crease);
        topology::HalfEdges edges = topology::half_edges(topology::weld(mesh));
        ASSERT_TRUE(edges.manifold);
        edges.mesh.request_face_normals();
        edges.mesh.update_face_normals();
        std::map<std::pair<uint32_t, int>, Vec3> theirs;   // by triangle and vertex
        for (const auto side : edges.mesh.halfedges())
            theirs[{edges.triangle_of[size_t(edges.mesh.face_handle(side).idx())], edges.mesh.to_vertex_handle(side).idx()}] =
                topology::from_openmesh(edges.mesh.calc_halfedge_normal(side, crease * kPi / 180));
        size_t same = 0, different = 0;
        for (uint32_t a = 0; a < 3 * mesh.triangles.size(); ++a)
            for (uint32_t b = 0; b < a; ++b) {
                const uint32_t vertex = mesh.triangles[a / 3][int(a % 3)];
                if (mesh.triangles[b / 3][int(b % 3)] != vertex) continue;
                const bool ours = mesh.normals.corners[a] == mesh.normals.corners[b];
                ASSERT_EQ(ours, length(theirs[{a / 3, int(vertex)}] - theirs[{b / 3, int(vertex)}]) < 1e-9) << crease;
                (ours ? same : different)++;
            }
        EXPECT_GT(std::min(same, different), 50u) << crease;
    }
}

}  // namespace
}  // namespace alidade
