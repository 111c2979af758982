// SPDX-License-Identifier: Apache-2.0
/// OFF files: what is read, and where errors stand.
#include "importers/mesh/off.h"

#include "core/image.h"
#include "tests/importers/mesh_text.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using mesh::read_off;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Off, FacesAreCutIntoTriangles) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const std::string& text : {"OFF\n4 1 0\n" + kSquare + "4 0 1 2 3\n", "OFF 4 1\n" + kSquare + "4 0 1 2 3", "# a square\r\n\r\nOFF # of four\r\n# vertices\r\n4 1 0 # edges\r\n\r\n" + kSquare + "\n\n4 0 1 2 3 # face\r\n\r\n"}) {
        const Mesh mesh = mesh_of(read_off, text);
        EXPECT_EQ(corners_of(mesh), corners) << text;
        EXPECT_EQ(said(import_text(read_off, text)), "");
        EXPECT_FALSE(mesh.normals.present());
    }
}

TEST(Off, TheFirstWordSaysWhatVerticesHave) {
    const Mesh mesh = mesh_of(read_off, "STCN4OFF\n3 1 0\n2 4 6 2 0 0 9 0.25 0.5 1 0.5 0.75 1\n1 0 0 1 0 1 0 0 0 0 1 0 0\n0 1 0 1 1 0 0 0 0 0 1 0 0\n3 0 1 2\n");
    EXPECT_EQ(corners_of(mesh), (std::vector<Vec3>{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.normals.values, (std::vector<Vec3f>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(mesh.colors.at(0).values.at(0), Vec4f(0.25f, 0.5f, 1.0f, 0.5f));
    EXPECT_EQ(mesh.uvs.at(0).values.at(0), Vec2f(0.75f, 0.0f));
}

TEST(Off, ColoursOverOneAreBytes) {
    const Mesh mesh = mesh_of(read_off, "COFF\n3 1 0\n0 0 0 255 128 0 51\n1 0 0 0 0 0 1\n0 1 0 255 255 255\n3 0 1 2\n");
    const std::vector<Vec4f>& colors = mesh.colors.at(0).values;
    EXPECT_EQ(colors.at(0).x, 1.0f);
    EXPECT_FLOAT_EQ(colors.at(0).y, float(srgb_to_linear(128 / 255.0)));
    EXPECT_FLOAT_EQ(colors.at(0).w, 0.2f);
    EXPECT_EQ(colors.at(1), Vec4f(0, 0, 0, 1 / 255.0f));
    EXPECT_EQ(colors.at(2), Vec4f(1));
}

struct BadOff {
    std::string text;
    const char* error;   ///< how the messages begin
};

TEST(Off, ErrorsStandAtTheirPlace) {
    const BadOff table[] = {
        {"", "a:1:1: error: the file ends before its first word"},
        {"OFT\n", "a:1:1: error: \"OFT\" is no first word of an OFF file"},
        {"nOFF\n3\n", "a:1:1: error: meshes of any dimension (nOFF) are not supported"},
        {"OFF BINARY\n", "a:1:5: error: binary OFF files are not supported"},
        {"OFF\n", "a:2:1: error: the file ends before its counts"},
        {"OFF\n-3 1 0\n", "a:2:1: error: \"-3\" is not the number of vertices"},
        {"OFF\n3\n", "a:2:2: error: \"\" is not the number of faces"},
        {"OFF\n99999999999999999999 1 0\n", "a:2:1: error: \"99999999999999999999\" is not the number of vertices"},
        {"OFF\n353535235358 6 0\n0 0 0\n", "a:2:1: error: 353535235358 vertices are promised: the file has bytes for 1 at most"},
        {"OFF\n1 353535235358 0\n0 0 0\n", "a:2:1: error: 353535235358 faces are promised: the file has bytes for 0 at most"},
        {"OFF\n18446744073709551615 18446744073709551615 0\n", "a:2:1: error: 18446744073709551615 vertices are promised"},
        {"OFF\n1 1 0\n0 0\n4 5 6\n", "a:3:1: error: a vertex needs 3 numbers, here are 2"},
        {"COFF\n1 0 0\n0 0 0 1 1\n", "a:3:1: error: a vertex needs 6 numbers, here are 5"},
        {"OFF\n1 0 0\n0 o 0\n", "a:3:3: error: \"o\" is not a number\n    0 o 0\n      ^"},
        {"OFF\n2 0 0\n0.00000 0.0 0.0\n", "a:4:1: error: the file ends before its last vertex"},
        {"OFF\n1 1 0\n0.00 0 0\n", "a:4:1: error: the file ends before its last face"},
        {"OFF\n4 1 0\n" + kSquare + "3 0 1 4\n", "a:7:7: error: index 4 of a vertex: there are only 4, counted from 0"},
        {"OFF\n4 1 0\n" + kSquare + "3 0 -1 2\n", "a:7:5: error: index -1 of a vertex"},
        {"OFF\n4 1 0\n" + kSquare + "3 0 1.5 2\n", "a:7:5: error: \"1.5\" is not the index of a vertex"},
        {"OFF\n4 1 0\n" + kSquare + "3 0 1\n", "a:7:6: error: the line ends before the last index"},
        {"OFF\n4 1 0\n" + kSquare + "18446744073709551615 0 1 2\n", "a:7:27: error: the line ends before the last index"},
        {"OFF\n4 1 0\n" + kSquare + "x 0 1 2\n", "a:7:1: error: \"x\" is not the number of a face's corners"},
    };
    for (const BadOff& bad : table) {
        const ImportResult result = import_text(read_off, bad.text);
        ASSERT_FALSE(result) << bad.text;
        EXPECT_THAT(said(result), StartsWith(bad.error)) << bad.text;
    }
}

TEST(Off, WhatIsLeftOutIsSaidOnce) {
    EXPECT_THAT(said(import_text(read_off, "OFF\n4 2 0\n" + kSquare + "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n")),
                StartsWith("a:7:9: warning: colours of faces are not supported: left out (2 times)"));
    EXPECT_THAT(said(import_text(read_off, "OFF\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n")), StartsWith("a:3:7: warning: a vertex has more than 3 numbers: the rest is left out (3 times)"));
    EXPECT_THAT(said(import_text(read_off, "OFF\n4 1 0\n" + kSquare + "3 0 1 2\nmore\n")), StartsWith("a:8:1: note: what stands behind the last of 1 faces is left out"));
    const ImportResult points = import_text(read_off, "OFF\n4 0 0\n" + kSquare);
    ASSERT_TRUE(points) << said(points);
    EXPECT_TRUE(points->scene.shapes.empty());
    EXPECT_THAT(said(points), HasSubstr("no faces that can be drawn: the scene is empty"));
}

TEST(Off, DamageDoesNoHarm) {
    expect_no_harm(read_off, "OFF\n4 2 5\n" + kSquare + "3 0 1 2 255 0 0\n4 0 1 2 3\n", "0123456789-+.e \n#");
    expect_no_harm(read_off, "STCN4OFF\n3 1 0\n2 4 6 2 0 0 9 0.25 0.5 1 0.5 0.75 1\n1 0 0 1 0 1 0 0 0 0 1 0 0\n0 1 0 1 1 0 0 0 0 0 1 0 0\n3 0 1 2\n", "0123456789-+.e \nn");
}

TEST(Off, IsRecognisedByItsFirstWord) {
    EXPECT_TRUE(looks_like_off(as_bytes("OFF\n8 6 0\n")));
    EXPECT_TRUE(looks_like_off(as_bytes("# cube\nSTCN4OFF 8 6 0\n")));
    EXPECT_FALSE(looks_like_off(as_bytes("OFF we go\n")));
    EXPECT_FALSE(looks_like_off(as_bytes("COFFEE\n8\n")));
    EXPECT_FALSE(looks_like_off({}));
}

TEST(OffCorpus, LoadsWhatIsGoodAndRefusesWhatIsBad) {
    if (!std::filesystem::exists(SHARED_DATA "/manifest.csv")) GTEST_SKIP() << "no shared data at " << SHARED_DATA;
    const auto [good, bad] = expect_corpus(".off", import_off);
    EXPECT_GE(good, 3u);
    EXPECT_GE(bad, 1u) << "OutOfMemory.off";
}

}  // namespace
}  // namespace alidade
