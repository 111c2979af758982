// SPDX-License-Identifier: Apache-2.0
/// STL files, text and binary: what is read, how the two are told apart, and where errors stand.
#include "importers/mesh/stl.h"

#include "tests/importers/mesh_text.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using mesh::read_stl;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kFacet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

/// A fan of n triangles in a plane that is not aligned with the axes: n + 2 different vertices.
std::vector<Vec3f> fan(int n) {
    std::vector<Vec3f> corners;
    const auto rim = [](int i) { return Vec3f(float(i), float(i * i) / 4, 0.5f + float(i)); };
    for (int i = 0; i < n; ++i) {
        corners.emplace_back(-1.0f, 3.0f, 0.0f);
        corners.push_back(rim(i));
        corners.push_back(rim(i + 1));
    }
    return corners;
}

std::string binary(const std::vector<Vec3f>& corners, std::string header = {}) {
    header.resize(80, ' ');
    std::string out = header + bytes_of(uint32_t(corners.size() / 3));
    for (size_t i = 0; i < corners.size(); ++i) {
        if (i % 3 == 0) out += std::string(12, '\xff');   // the normal, not finite
        for (int k = 0; k < 3; ++k) out += bytes_of(corners[i][k]);
        if (i % 3 == 2) out += "ab";
    }
    return out;
}

std::string text(const std::vector<Vec3f>& corners) {
    std::string out = "solid fan of triangles\n";
    for (size_t i = 0; i < corners.size(); ++i) {
        if (i % 3 == 0) out += "facet normal 0 0 0\n outer loop\n";
        out += "  vertex " + std::to_string(corners[i].x) + " " + std::to_string(corners[i].y) + " " + std::to_string(corners[i].z) + "\n";
        if (i % 3 == 2) out += " endloop\nendfacet\n";
    }
    return out + "endsolid\n";
}

std::vector<Vec3> as_doubles(const std::vector<Vec3f>& corners) { return {corners.begin(), corners.end()}; }

TEST(Stl, TextAndBinaryGiveTheTrianglesThatWereWritten) {
    const std::vector<Vec3f> corners = fan(40);
    for (const std::string& file : {text(corners), binary(corners), binary(corners, "solid this is not text\nfacet")}) {
        const Mesh mesh = mesh_of(read_stl, file);
        EXPECT_EQ(corners_of(mesh), as_doubles(corners));
        EXPECT_EQ(mesh.positions.size(), 42u) << "equal vertices are one";
        EXPECT_FALSE(mesh.normals.present());
        EXPECT_TRUE(mesh.exact_positions.empty());
    }
}

TEST(Stl, MinusZeroIsZero) {
    const Mesh mesh = mesh_of(read_stl, binary({{0.0f, 0.0f, 0.0f}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0.0f, -0.0f}, {0, 1, 0}, {-1, 0, 0}}));
    EXPECT_EQ(mesh.positions.size(), 4u);
}

TEST(Stl, TextOfAnyCaseWithSeveralSolids) {
    const Mesh mesh = mesh_of(read_stl, "\r\nSOLID a\r\n FACET NORMAL nan nan nan\r\n  OUTER LOOP\r\n   VERTEX 0 0 0\r\n   Vertex +1e0 0 0\r\n   vertex 0 1 0\r\n  ENDLOOP\r\n"
                                        " ENDFACET\r\nENDSOLID a\r\nsolid b\r\nfacet\r\nouter loop\r\nvertex 0 0 0\r\nvertex 0 1 0\r\nvertex 0 0 5\r\nendloop\r\nendfacet\r\nendsolid\r\n");
    EXPECT_EQ(corners_of(mesh), (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 5}}));
    EXPECT_EQ(mesh.positions.size(), 4u);
}

struct BadStl {
    std::string text;
    const char* error;   ///< how the messages begin
};

TEST(Stl, ErrorsStandAtTheirPlace) {
    const std::string begin = "solid\nfacet normal 0 0 1\nouter loop\n";
    const BadStl table[] = {
        {"", "a: error: neither STL text nor binary STL"},
        {"solidity\n", "a: error: neither STL text nor binary STL"},
        {binary(fan(3)).substr(0, 84 + 149), "a: error: the file is cut off: it promises 3 triangles and holds 2"},
        {binary({}).substr(0, 80) + "\xff\xff\xff\xff", "a: error: the file is cut off: it promises 4294967295 triangles and holds 0"},
        {"solid\n" + kFacet, "a:9:1: error: the file is cut off: it holds 1 triangles and no endsolid"},
        {begin + "vertex 0 0\n", "a:4:1: error: a vertex needs 3 numbers"},
        {begin + "vertex 0 0 z\n", "a:4:12: error: \"z\" is not a number\n    vertex 0 0 z\n               ^"},
        {begin + "vertex 0 0 0\nendloop\n", "a:5:1: error: a loop ends that has 1 vertices: it must have 3"},
        {begin + "vertex 0 0 0\nendfacet\n", "a:5:1: error: \"endfacet\" in a loop"},
        {begin + "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n", "a:8:1: error: a loop ends that has 4 vertices"},
        {"solid\nvertex 0 0 0\n", "a:2:1: error: a vertex outside of a loop"},
        {"solid\nendloop\n", "a:2:1: error: a loop ends that has 0 vertices"},
        {"solid\nendsolid\nouter loop\n", "a:3:1: error: a loop outside of a solid"},
    };
    for (const BadStl& bad : table) {
        const ImportResult result = import_text(read_stl, bad.text);
        ASSERT_FALSE(result) << bad.text;
        EXPECT_THAT(said(result), StartsWith(bad.error)) << bad.text;
    }
}

TEST(Stl, WhatIsLeftOutIsSaid) {
    EXPECT_EQ(said(import_text(read_stl, binary(fan(1)))), "");
    EXPECT_EQ(said(import_text(read_stl, binary(fan(2)) + "rest")), "a: note: 4 bytes behind the last of 2 triangles are left out\n");
    EXPECT_THAT(said(import_text(read_stl, "solid\ncolor 1 0 0\n" + kFacet + "endsolid\n")), StartsWith("a:2:1: warning: unknown statement \"color\""));
    for (const std::string& empty : {std::string("solid nothing\nendsolid nothing\n"), binary({})}) {
        const ImportResult result = import_text(read_stl, empty);
        ASSERT_TRUE(result) << said(result);
        EXPECT_TRUE(result->scene.shapes.empty());
        EXPECT_THAT(said(result), HasSubstr("no faces that can be drawn: the scene is empty"));
    }
}

TEST(Stl, DamageDoesNoHarm) {
    expect_no_harm(read_stl, text(fan(3)), "0123456789-+.e \nxyz");
    expect_no_harm(read_stl, binary(fan(5)), std::string_view("\0\1\2\4\x7f\xff\xc0", 7));
}

TEST(Stl, IsRecognisedByItsBeginning) {
    EXPECT_TRUE(looks_like_stl(as_bytes("solid a b\n  facet normal 0 0 1\n")));
    EXPECT_TRUE(looks_like_stl(as_bytes("SOLID\nendsolid\n")));
    EXPECT_TRUE(looks_like_stl(as_bytes(binary(fan(2)))));
    EXPECT_FALSE(looks_like_stl(as_bytes(binary(fan(2)) + "x")));
    EXPECT_FALSE(looks_like_stl(as_bytes("solid ground\nsphere\n")));
    EXPECT_FALSE(looks_like_stl({}));
}

TEST(StlCorpus, LoadsWhatIsGood) {
    if (!std::filesystem::exists(SHARED_DATA "/manifest.csv")) GTEST_SKIP() << "no shared data at " << SHARED_DATA;
    EXPECT_GE(expect_corpus(".stl", import_stl).first, 10u);
}

}  // namespace
}  // namespace alidade
