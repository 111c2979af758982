// SPDX-License-Identifier: Apache-2.0
/// The half-edge mesh holds what it can of a surface, and says what it cannot; no triangle is lost, moved or turned on the way.
#include "tests/core/run_size.h"
#include "tests/topology/surfaces.h"
#include "topology/half_edges.h"

namespace alidade {
namespace {

using namespace topology;

/// The three points of a triangle, turned so that the smallest index comes first.
using Corners = std::array<Vec3, 3>;
Corners face_corners(TriangleHalfEdges& mesh, OpenMesh::FaceHandle face) {
    Corners out;
    size_t k = 0;
    for (const auto v : mesh.fv_range(face)) out[k++ % 3] = from_openmesh(mesh.point(v));
    return out;
}
bool same_up_to_rotation(const Corners& a, const Corners& b) {
    for (size_t r = 0; r < 3; ++r)
        if (a[0] == b[r] && a[1] == b[(r + 1) % 3] && a[2] == b[(r + 2) % 3]) return true;
    return false;
}

/// What is in the half-edges, what they refused, and what was unsound before are together the triangles of the mesh, each once and with its own points.
void expect_same_triangles(const std::string& name, const Mesh& mesh) {
    const Welded surface = weld(mesh);
    HalfEdges edges = half_edges(surface);
    std::vector<int> seen(mesh.triangles.size(), 0);
    ASSERT_EQ(edges.mesh.n_faces(), edges.triangle_of.size()) << name;
    for (size_t f = 0; f < edges.triangle_of.size(); ++f) {
        const uint32_t t = edges.triangle_of[f];
        const Index3& v = mesh.triangles[t];
        ++seen[t];
        ASSERT_TRUE(same_up_to_rotation(face_corners(edges.mesh, OpenMesh::FaceHandle(int(f))), {position(mesh, v.x), position(mesh, v.y), position(mesh, v.z)}))
            << name << " triangle " << t;
    }
    for (const uint32_t t : edges.refused) ++seen[t];
    for (size_t t = 0; t < seen.size(); ++t) seen[t] += !surface.sound[t];
    ASSERT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; })) << name;
}

TEST(HalfEdges, HoldTheTrianglesOfEveryFile) {
    const size_t meshes = for_each_mesh_file(test::run_size(8 << 20), expect_same_triangles);
    EXPECT_GE(meshes, 3u) << "the assets are always here";
    RecordProperty("meshes", int(meshes));
}

TEST(HalfEdges, HoldTheTrianglesOfAnyMess) {
    for (uint32_t seed = 0; seed < 300; ++seed) expect_same_triangles("mess", mess(seed, 3 + int(seed % 20), int(seed % 60)));
}

TEST(HalfEdges, SeamsOfAttributesAreNoHoles) {
    HalfEdges edges = half_edges(weld(soup(cube())));
    EXPECT_TRUE(edges.manifold);
    EXPECT_EQ(edges.mesh.n_vertices(), 8u);
    EXPECT_EQ(edges.mesh.n_edges(), 18u);
    for (const auto e : edges.mesh.edges()) EXPECT_FALSE(edges.mesh.is_boundary(e));
}

TEST(HalfEdges, ZeroHasTwoSignsAndOnePlace) {
    const Mesh mesh = mesh_from({{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {1, -0.0, 0}, {0, 0, 1}}, {{0, 1, 2}, {4, 3, 5}});
    EXPECT_EQ(weld(mesh).points.size(), 4u);
}

TEST(HalfEdges, PlacesThatAreNotFiniteAreNoPlaces) {
    Mesh mesh = cube();
    mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
    mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
    mesh.triangles.emplace_back(0, 8, 9);
    const Welded surface = weld(mesh);
    EXPECT_EQ(surface.sound_count(), 12u);
    EXPECT_TRUE(half_edges(surface).manifold);
}

TEST(HalfEdges, RefuseWhatDoesNotFit) {
    for (const Mesh& mesh : {together(cube(), cube(Vec3(1, 1, 0))), together(cube(), cube(Vec3(1))), moebius(12), together(octahedron(), octahedron())}) {
        const HalfEdges edges = half_edges(weld(mesh));
        EXPECT_FALSE(edges.manifold);
        EXPECT_GT(edges.refused.size(), 0u);
    }
    EXPECT_FALSE(half_edges(weld(mesh_from({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}))).manifold) << "two fans at a vertex";
}

/// Looking edges up takes steps around vertices: a million triangles around one must not take a million squared.
TEST(HalfEdges, CrowdsAreLeftToThemselves) {
    const int n = 300000;
    Mesh mesh;
    mesh.positions.emplace_back(0.f, 0.f, 1.f);
    for (int i = 0; i < n; ++i) mesh.positions.emplace_back(float(i), float(i % 7), 0.f);
    for (uint32_t i = 1; i + 1 < uint32_t(n); ++i) mesh.triangles.emplace_back(0, i, i + 1);
    expect_same_triangles("crowd", mesh);
    EXPECT_EQ(half_edges(weld(mesh)).refused.size(), mesh.triangles.size());
}

}  // namespace
}  // namespace alidade
