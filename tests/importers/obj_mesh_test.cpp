// SPDX-License-Identifier: Apache-2.0
/// What an OBJ file says, in the meshes that come of it.
#include "tests/importers/obj_files.h"

#include "core/image.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::ElementsAre;

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<Index3> triangles_of(const Mesh& mesh) { return mesh.triangles; }

/// Ways to write the same triangle of the square's corners 1, 2 and 3.
TEST_F(ObjFiles, SpellingsOfATriangle) {
    const char* same[] = {"f 1 2 3\n",     "f -4 -3 -2\n",  "f 1 -3 3\n",    "f\t1\t 2 3  \n",       "f 1 2 3",    "f 1 2 3\r\n",
                          "f 1 2 3 # 4\n", "f 1 2 \\\n3\n", "f 1 \\\r\n2 3\n", "f \\\n1 2 3 \\\n\n", "f 1/ 2/ 3/\n", "f 1// 2// 3//\n",
                          "  f 1 2 3\n",   "#f 2 3 4\nf 1 2 3\n", "f +1 02 3\n", "g a f 1 2\nf 1 2 3\n", "f 1 2 3\\"};
    for (const char* text : same) {
        const Mesh mesh = mesh_of(std::string(kSquare) + text);
        ASSERT_EQ(triangles_of(mesh), std::vector<Index3>{Index3(0, 1, 2)}) << text;
        EXPECT_THAT(mesh.positions, ElementsAre(Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0))) << text;
        EXPECT_TRUE(mesh.faces.empty() && mesh.slots.empty() && !mesh.normals.present() && mesh.uvs.empty()) << text;
    }
}

TEST_F(ObjFiles, FacesMayStandBeforeTheirVertices) {
    const Mesh mesh = mesh_of(std::string("f 1/1/1 2/1/1 3/1/1\n") + kSquare + "vt 0.25 0.25\nvn 0 0 2\n");
    EXPECT_EQ(triangles_of(mesh), std::vector<Index3>{Index3(0, 1, 2)});
    EXPECT_THAT(mesh.normals.values, ElementsAre(Vec3f(0, 0, 1)));
    EXPECT_THAT(mesh.uvs[0].values, ElementsAre(Vec2f(0.25f, 0.75f)));
}

TEST_F(ObjFiles, CornersKeepTheirOwnNormalsAndTextureCoordinates) {
    const Mesh mesh = mesh_of(std::string(kSquare) + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.25 9\nvn 0 0 1\nvn 0 3 4\nvn 1 0 0\nf 1/1/1 2/2/2 3/3/1\nf 1/4/3 3/3/3 4/1/3\n");
    ASSERT_EQ(mesh.triangles.size(), 2u);
    ASSERT_EQ(mesh.uvs.size(), 1u);
    const auto uv = [&](size_t t, int c) { return mesh.uvs[0].values[mesh.uvs[0].index(t, c, mesh.triangles[t])]; };
    const auto normal = [&](size_t t, int c) { return mesh.normals.values[mesh.normals.index(t, c, mesh.triangles[t])]; };
    EXPECT_EQ(uv(0, 0), Vec2f(0, 1)) << "v grows downwards in the scene";
    EXPECT_EQ(uv(0, 2), Vec2f(1, 0));
    EXPECT_EQ(uv(1, 0), Vec2f(0.5f, 0.75f));
    EXPECT_EQ(normal(0, 1), Vec3f(0, 0.6f, 0.8f)) << "normals have length 1";
    EXPECT_EQ(normal(1, 0), Vec3f(1, 0, 0));
    EXPECT_EQ(normal(0, 0), Vec3f(0, 0, 1));
}

TEST_F(ObjFiles, AttributesIndexedAsThePositionsNeedNoCorners) {
    const Mesh mesh = mesh_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 4/4 2/2 1/1\nf 2/2 3/3 4/4\n");
    EXPECT_TRUE(mesh.uvs[0].corners.empty());
    EXPECT_EQ(mesh.uvs[0].values.size(), 4u);
    EXPECT_THAT(mesh.positions, ElementsAre(Vec3f(0, 1, 0), Vec3f(1, 0, 0), Vec3f(0, 0, 0), Vec3f(1, 1, 0))) << "in the order of their first use";
}

TEST_F(ObjFiles, CornersWithoutTextureCoordinatesTakeTheOrigin) {
    const Mesh mesh = mesh_of(std::string(kSquare) + "vt 0.5 0.5\nf 1/1 2 3/1\n");
    ASSERT_EQ(mesh.uvs.size(), 1u);
    EXPECT_EQ(mesh.uvs[0].values[mesh.uvs[0].index(0, 1, mesh.triangles[0])], Vec2f(0, 1));
    EXPECT_EQ(mesh.uvs[0].values[mesh.uvs[0].index(0, 2, mesh.triangles[0])], Vec2f(0.5f, 0.5f));
}

TEST_F(ObjFiles, PolygonsRememberWhichTheyWere) {
    const Mesh mesh = mesh_of(std::string(kSquare) + "f 1 2 3 4\nf 1 2 3\nf 1 1 2\nf 4 3 2 1\n");
    EXPECT_THAT(mesh.faces, ElementsAre(0, 0, 1, 3, 3)) << "a polygon that is left out is counted";
}

TEST_F(ObjFiles, ObjectsAreNodesAndMaterialsAreSlots) {
    const ImportResult result = import_text(std::string("usemtl a\n") + kSquare +
                                            "f 1 2 3\no first thing\nusemtl b\nf 1 2 3\ng x y\nusemtl a\nf 2 3 4\nusemtl b\nf 1 3 4\no empty\no last\nf 1 2 4\n");
    ASSERT_TRUE(result) << said(result);
    const Scene& scene = result->scene;
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_EQ(scene.roots.size(), 3u);
    EXPECT_EQ(scene.nodes[0].name, "a") << "the file's own name, before any o";
    EXPECT_EQ(scene.nodes[1].name, "first thing");
    EXPECT_EQ(scene.nodes[1].from.line, 7u);
    EXPECT_EQ(scene.nodes[2].name, "last");
    EXPECT_THAT(std::get<Mesh>(scene.shapes[1].geometry).slots, ElementsAre(0, 1, 0)) << "in the order of their first use";
    EXPECT_EQ(scene.nodes[1].materials.size(), 2u);
    EXPECT_TRUE(std::get<Mesh>(scene.shapes[2].geometry).slots.empty());
    EXPECT_EQ(scene.nodes[2].materials.size(), 1u) << "the material stays in force over an o";
}

TEST_F(ObjFiles, VertexColorsAreDecoded) {
    const Mesh mesh = mesh_of("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
    ASSERT_EQ(mesh.colors.size(), 1u);
    EXPECT_THAT(mesh.colors[0].values, ElementsAre(Vec4f(1, float(srgb_to_linear(0.5)), 0, 1), Vec4f(1), Vec4f(0, 0, 1, 1)));
}

// ---- Normals that the file leaves out ----

Vec3 normal_at(const Mesh& mesh, size_t triangle, int corner) {
    return Vec3(mesh.normals.values[mesh.normals.index(triangle, corner, mesh.triangles[triangle])]);
}

/// Two faces of a roof over the ridge from 1 to 2; each falls by 45 degrees.
constexpr const char* kRoof = "v 0 1 0\nv 0 1 1\nv -1 0 0\nv -1 0 1\nv 1 0 0\nv 1 0 1\n";

TEST_F(ObjFiles, WithoutSmoothingThereAreNoNormals) {
    for (const char* s : {"", "s off\n", "s 0\n"}) EXPECT_FALSE(mesh_of(std::string(kRoof) + s + "f 1 3 4 2\nf 1 2 6 5\n").normals.present()) << s;
}

TEST_F(ObjFiles, SmoothingAveragesOverTheGroup) {
    const Mesh mesh = mesh_of(std::string(kRoof) + "s 1\nf 1 3 4 2\nf 1 2 6 5\n");
    const double h = std::sqrt(0.5);
    EXPECT_LT(length(normal_at(mesh, 0, 0) - Vec3(0, 1, 0)), 1e-6) << "on the ridge";
    EXPECT_LT(length(normal_at(mesh, 0, 1) - Vec3(-h, h, 0)), 1e-6) << "at the eaves";
    EXPECT_LT(length(normal_at(mesh, 3, 2) - Vec3(h, h, 0)), 1e-6);
}

TEST_F(ObjFiles, GroupsDoNotMix) {
    const double h = std::sqrt(0.5);
    for (const char* second : {"s 2\n", "s off\n"}) {
        const Mesh mesh = mesh_of(std::string(kRoof) + "s 1\nf 1 3 4 2\n" + second + "f 1 2 6 5\n");
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(length(normal_at(mesh, 0, c) - Vec3(-h, h, 0)), 1e-6);
            EXPECT_LT(length(normal_at(mesh, 2, c) - Vec3(h, h, 0)), 1e-6);
        }
    }
}

/// Cutting one side of a cube's corner into more polygons must not pull the normal to that side.
TEST_F(ObjFiles, SmoothingWeighsByAngle) {
    const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\nv 1 0.5 0\n";
    const Mesh whole = mesh_of(corner + "s 1\nf 1 2 5 3\nf 1 4 2\nf 1 3 4\n");
    const Mesh cut = mesh_of(corner + "s 1\nf 1 2 6\nf 1 6 5\nf 1 5 3\nf 1 4 2\nf 1 3 4\n");
    const Vec3 want = normalized(Vec3(1, 1, 1));   // the sides look along z, y and x, each with a right angle
    EXPECT_LT(length(normal_at(whole, 0, 0) - want), 1e-6);
    EXPECT_LT(length(normal_at(cut, 0, 0) - want), 1e-6);
}

TEST_F(ObjFiles, TheFilesNormalsComeFirst) {
    const Mesh mesh = mesh_of(std::string(kRoof) + "vn 1 0 0\nvn 0 0 0\nf 1//1 3//1 4//2 2\n");
    const double h = std::sqrt(0.5);
    EXPECT_EQ(normal_at(mesh, 0, 0), Vec3(1, 0, 0));
    EXPECT_LT(length(normal_at(mesh, 0, 2) - Vec3(-h, h, 0)), 1e-6) << "a normal without a direction is none: the polygon's own";
}

// ---- Coordinates that float does not hold ----

TEST_F(ObjFiles, FarObjectsAreCountedFromAnOriginOfTheirOwn) {
    const Mesh mesh = mesh_of("v 4500000.125 300000.25 10\nv 4500001.125 300000.25 10\nv 4500000.125 300001.25 10.5\nf 1 2 3\n");
    EXPECT_NE(mesh.origin, Vec3(0));
    EXPECT_EQ(corner_at(mesh, 0, 0), Vec3(4500000.125, 300000.25, 10)) << "not a digit is lost";
    EXPECT_EQ(corner_at(mesh, 0, 2), Vec3(4500000.125, 300001.25, 10.5));
    for (const Vec3f& p : mesh.positions) EXPECT_LT(max_abs(p), 4);
}

TEST_F(ObjFiles, NearObjectsStayWhereTheyAre) {
    EXPECT_EQ(mesh_of("v 10 10 10\nv 11 10 10\nv 10 11 10\nf 1 2 3\n").origin, Vec3(0));
    EXPECT_EQ(mesh_of("v 0 0 0\nv 1e9 0 0\nv 0 1e9 0\nf 1 2 3\n").origin, Vec3(0)) << "large is not far";
}

/// Kept if rounding to float moves a number by more than half a unit of its last digit.
TEST_F(ObjFiles, ExactPositionsAreKeptWhereTheFileHasThem) {
    const auto exact = [&](const std::string& x) { return mesh_of("v " + x + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").exact_positions; };
    for (const char* x : {"0.1", "0.123456", "-3.25", "123456", "1e-30", "0.333333343", "16777216", "0.10000000149011612"}) EXPECT_TRUE(exact(x).empty()) << x;
    for (const char* x : {"0.1234567891", "123.456789", "16777217", "1.00000000000001"}) {
        ASSERT_EQ(exact(x).size(), 3u) << x;
        EXPECT_EQ(exact(x)[0].x, std::stod(x)) << x;
    }
}

TEST_F(ObjFiles, DumpIsTheSameEveryTime) {
    const std::string text = std::string(kRoof) + "s 1\nf 1 3 4 2\nf 1 2 6 5\n";
    const ImportResult a = import_text(text), b = import_text(text);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(dump(a->scene), dump(b->scene));
}

}  // namespace
}  // namespace alidade
