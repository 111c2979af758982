// SPDX-License-Identifier: Apache-2.0
/// PLY files: what is read, in all three encodings, and where errors stand.
#include "importers/mesh/ply.h"

#include "core/image.h"
#include "tests/importers/mesh_text.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using mesh::read_ply;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_indices\nend_header\n";
const std::string kSquareVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// The text of a square whose faces are `faces`, one a line.
std::string square(int count, const std::string& faces) {
    return "ply\nformat ascii 1.0\nelement vertex 4\n" + kXyz + "element face " + std::to_string(count) + "\n" + kFaces + kSquareVertices + faces;
}

TEST(Ply, FacesAreCutIntoTriangles) {
    const Mesh mesh = mesh_of(read_ply, square(1, "4 0 1 2 3\n"));
    EXPECT_EQ(corners_of(mesh), (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.faces, (std::vector<uint32_t>{0, 0}));
    EXPECT_FALSE(mesh.normals.present());
    EXPECT_TRUE(mesh.uvs.empty() && mesh.colors.empty() && mesh.exact_positions.empty());
}

TEST(Ply, AllAttributesOfAVertexInAnyOrder) {
    const Mesh mesh = mesh_of(read_ply,
                              "ply\r\ncomment made by hand\r\nformat ascii 1.0\r\nobj_info none\r\nelement vertex 3\r\nproperty uchar alpha\r\nproperty uchar red\r\n"
                              "property float t\r\nproperty float s\r\nproperty uchar green\r\nproperty double z\r\nproperty double y\r\nproperty double x\r\n"
                              "property float nz\r\nproperty float nx\r\nproperty float ny\r\nproperty uchar blue\r\nproperty float quality\r\n"
                              "property list uchar float more\r\nelement face 1\r\nproperty float area\r\nproperty list uint8 uint32 vertex_index\r\nend_header\r\n"
                              "51 255 0.25 0.5 0 3 2 1 2 0 0 128 7 2 8 9\r\n255 0 0 0 0 3 2 2 2 0 0 0 7 0\r\n\r\n255 0 0 0 0 3 3 1 2 0 0 0 7 1 1\r\n0.5 3 0 1 2\r\n");
    EXPECT_EQ(corners_of(mesh), (std::vector<Vec3>{{1, 2, 3}, {2, 2, 3}, {1, 3, 3}}));
    EXPECT_EQ(mesh.normals.values.at(0), Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.uvs.at(0).values.at(0), Vec2f(0.5f, 0.75f));
    const Vec4f color = mesh.colors.at(0).values.at(0);
    EXPECT_EQ(color.x, 1.0f);
    EXPECT_EQ(color.y, 0.0f);
    EXPECT_FLOAT_EQ(color.z, float(srgb_to_linear(128 / 255.0)));
    EXPECT_FLOAT_EQ(color.w, 0.2f);
}

TEST(Ply, FloatColoursAreLinear) {
    const Mesh mesh = mesh_of(read_ply, "ply\nformat ascii 1.0\nelement vertex 3\n" + kXyz +
                                            "property float red\nproperty float green\nproperty float blue\nelement face 1\n" + kFaces +
                                            "0 0 0 0.5 2 0\n1 0 0 0 0 0\n0 1 0 nan 0 0\n3 0 1 2\n");
    EXPECT_EQ(mesh.colors.at(0).values.at(0), Vec4f(0.5f, 2, 0, 1));
    EXPECT_EQ(mesh.colors.at(0).values.at(2), Vec4f(1)) << "not finite";
}

TEST(Ply, FacesMayStandBeforeTheirVertices) {
    const Mesh mesh = mesh_of(read_ply, "ply\nformat ascii 1.0\nelement face 1\nproperty list int short vertex_indices\nelement edge 1\nproperty int a\nelement vertex 3\n" +
                                            kXyz + "property float nx\nproperty float ny\nproperty float nz\nend_header\n3 2 1 0\n77\n" +
                                            "0 0 0 0 0 1\n0 1 0 0 1 0\n1 0 0 1 0 0\n");
    EXPECT_EQ(corners_of(mesh), (std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}));
    EXPECT_EQ(mesh.normals.values.at(mesh.normals.index(0, 0, mesh.triangles[0])), Vec3f(1, 0, 0));
}

TEST(Ply, TextureCoordinatesOfCorners) {
    const Mesh mesh = mesh_of(read_ply, "ply\nformat ascii 1.0\nelement vertex 4\n" + kXyz + "element face 2\nproperty list uchar int vertex_indices\n" +
                                            "property list uchar float texcoord\nend_header\n" + kSquareVertices + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0.5 0 0 0 0 1\n");
    const auto& uv = mesh.uvs.at(0);
    EXPECT_EQ(uv.values.at(uv.index(0, 2, mesh.triangles[0])), Vec2f(1, 0));
    EXPECT_EQ(uv.values.at(uv.index(1, 0, mesh.triangles[1])), Vec2f(0.5f, 1));
}

TEST(Ply, StripsAlternate) {
    const Mesh mesh = mesh_of(read_ply, "ply\nformat ascii 1.0\nelement vertex 4\n" + kXyz + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                                            kSquareVertices + "8 0 1 3 2 -1 2 1 0\n");
    EXPECT_EQ(corners_of(mesh),
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
}

TEST(Ply, DigitsBeyondFloatAreKept) {
    const std::string header = "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n" + kFaces;
    std::string data;
    for (const double v : {0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}) data += bytes_of(v, true);
    data += '\3';
    for (const int i : {0, 1, 2}) data += bytes_of(i, true);
    EXPECT_EQ(mesh_of(read_ply, header + data).exact_positions.at(0), Vec3(0.1, 0, 0));
}

/// A wavy sheet of n x n quads, as a PLY file in any encoding; values that all types can hold exactly.
struct Sheet {
    int n;

    float height(int i, int j) const { return float((i * 7 + j * 5) % 16) / 8; }
    std::string header(const std::string& format, const std::string& line_end) const {
        std::string text = "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string((n + 1) * (n + 1)) +
                           "\nproperty float x\nproperty short y\nproperty double z\nproperty uchar flag\nelement face " + std::to_string(n * n) +
                           "\nproperty ushort group\nproperty list ushort uint vertex_indices\nend_header\n";
        for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += line_end.size()) text.replace(at, 1, line_end);
        return text;
    }
    template <class Write> std::string data(Write write) const {
        std::string out;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j) out += write(height(i, j)) + write(int16_t(i - 3)) + write(double(j) / 2) + write(uint8_t(10)) + write('\n');
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                out += write(uint16_t(i)) + write(uint16_t(4));
                for (const int k : {i * (n + 1) + j, i * (n + 1) + j + 1, (i + 1) * (n + 1) + j + 1, (i + 1) * (n + 1) + j}) out += write(uint32_t(k));
                out += write('\n');
            }
        return out;
    }
};

struct AsText {
    std::string operator()(char c) const { return {c}; }
    template <class T> std::string operator()(T value) const { return " " + std::to_string(value); }
};
struct AsBytes {
    bool big;
    std::string operator()(char) const { return {}; }
    template <class T> std::string operator()(T value) const { return bytes_of(value, big); }
};

TEST(Ply, AllEncodingsGiveTheSameTriangles) {
    const Sheet sheet{9};
    for (const std::string line_end : {"\n", "\r\n", "\r"}) {
        const std::vector<Vec3> text = corners_of(mesh_of(read_ply, sheet.header("ascii", line_end) + sheet.data(AsText())));
        EXPECT_EQ(text.size(), 9u * 9 * 2 * 3);
        EXPECT_EQ(text[0], Vec3(sheet.height(0, 0), -3, 0));
        EXPECT_EQ(corners_of(mesh_of(read_ply, sheet.header("binary_little_endian", line_end) + sheet.data(AsBytes{false}))), text);
        EXPECT_EQ(corners_of(mesh_of(read_ply, sheet.header("binary_big_endian", line_end) + sheet.data(AsBytes{true}))), text);
    }
}

/// After any line end, data that begins with the byte of LF.
TEST(Ply, DataMayBeginWithALineEnd) {
    for (const std::string line_end : {"\n", "\r\n", "\r"}) {
        std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\nelement face 1\n"
                             "property list uchar uchar vertex_indices\nend_header\n";
        for (size_t at = 0; (at = header.find('\n', at)) != std::string::npos; at += line_end.size()) header.replace(at, 1, line_end);
        const std::string data("\n\r\n\1\0\0\0\1\0\3\0\1\2", 13);
        EXPECT_EQ(corners_of(mesh_of(read_ply, header + data)), (std::vector<Vec3>{{10, 13, 10}, {1, 0, 0}, {0, 1, 0}}));
    }
}

struct BadPly {
    std::string text;
    const char* error;   ///< how the messages begin
};

const std::string kHead = "ply\nformat ascii 1.0\n";

TEST(Ply, ErrorsStandAtTheirPlace) {
    const BadPly table[] = {
        {"", "a:1:1: error: a PLY file begins with the line \"ply\""},
        {"plx\n", "a:1:1: error: a PLY file begins"},
        {"ply\n", "a:2:1: error: the file ends in its header"},
        {"ply\nformat ascii 1.0\n", "a:3:1: error: the file ends in its header: there is no end_header"},
        {"ply\nend_header\n", "a:2:1: error: the header has no format statement"},
        {"ply\nformat text 1.0\n", "a:2:8: error: \"text\" is no PLY encoding"},
        {"ply\nformat ascii 2.0\n", "a:2:14: error: PLY version \"2.0\" is not known"},
        {kHead + "elephant\n", "a:3:1: error: \"elephant\" is no statement of a PLY header"},
        {kHead + "property float x\n", "a:3:1: error: a property before any element"},
        {kHead + "element\n", "a:3:1: error: element without a name"},
        {kHead + "element vertex -1\n", "a:3:16: error: \"-1\" is not the number of elements"},
        {kHead + "element vertex 99999999999999999999\n", "a:3:16: error: \"99999999999999999999\" is not the number"},
        {kHead + "element vertex 1\nelement vertex 1\n", "a:4:1: error: there is already an element of this name"},
        {kHead + "element vertex 1\nproperty real x\n", "a:4:10: error: \"real\" is not a PLY type"},
        {kHead + "element vertex 1\nproperty float\n", "a:4:1: error: property without a name"},
        {kHead + "element face 1\nproperty list float int vertex_indices\n", "a:4:15: error: the length of a list must be an integer"},
        {kHead + "element vertex 1\nproperty float x\nend_header\n1\n", "a:3:1: error: the vertices have no property y"},
        {kHead + "element vertex 353535235358\n" + kXyz + "end_header\n0 0 0\n", "a:3:1: error: 353535235358 elements are promised: the file has bytes for 1 at most"},
        {square(1, "3 0 1 4\n"), "a:14:7: error: index 4 of a vertex: there are only 4, counted from 0\n    3 0 1 4\n          ^"},
        {square(1, "3 0 -1 2\n"), "a:14:5: error: index -1 of a vertex"},
        {square(1, "3 0 1.5 2\n"), "a:14:5: error: index 1.5 of a vertex"},
        {square(1, "3 0 nan 2\n"), "a:14:5: error: index nan of a vertex"},
        {square(1, "3 0 x 2\n"), "a:14:5: error: \"x\" is not a number"},
        {square(1, "3 0 1\n2\n"), "a:14:6: error: the line ends before the last value"},
        {square(1, "-3 0 1 2\n"), "a:14:1: error: a list of -3 items"},
        {square(1, "1e9 0 1 2\n"), "a:14:1: error: a list of 1000000000 items: the file has bytes for 4 at most"},
        {square(2, "3 0 1 2\n"), "a:15:1: error: the file ends before its last element"},
    };
    for (const BadPly& bad : table) {
        const ImportResult result = import_text(read_ply, bad.text);
        ASSERT_FALSE(result) << bad.text;
        EXPECT_THAT(said(result), StartsWith(bad.error)) << bad.text;
    }
}

TEST(Ply, ErrorsInBinaryDataNameTheByte) {
    const Sheet sheet{2};
    const std::string header = sheet.header("binary_little_endian", "\n"), data = sheet.data(AsBytes{false});
    const size_t first_face = header.size() + 9 * 15, first_index = first_face + 4;
    std::string far = header + data;
    far[first_index + 3] = '\x01';
    EXPECT_EQ(said(import_text(read_ply, far)), "a: error: byte " + std::to_string(first_index) + ": index 16777216 of a vertex: there are only 9, counted from 0\n");
    std::string is_long = header + data;
    is_long[first_face + 3] = '\x10';
    EXPECT_THAT(said(import_text(read_ply, is_long)), StartsWith("a: error: byte " + std::to_string(first_face + 2) + ": a list of 4100 items: the file has bytes for"));
    const std::string cut = header + data.substr(0, data.size() - 1);
    EXPECT_THAT(said(import_text(read_ply, cut)), HasSubstr("a list of 4 items: the file has bytes for 3 at most"));
}

TEST(Ply, WithoutFacesTheSceneIsEmpty) {
    for (const std::string& text : {kHead + "element vertex 1\n" + kXyz + "end_header\n1 2 3\n", kHead + "element vertex 0\n" + kXyz + "end_header\n", kHead + "end_header\n",
                                   square(2, "2 0 1\n0\n"), square(1, "3 1 1 2\n")}) {
        const ImportResult result = import_text(read_ply, text);
        ASSERT_TRUE(result) << said(result);
        EXPECT_TRUE(result->scene.shapes.empty() && result->scene.roots.empty());
        EXPECT_THAT(said(result), HasSubstr("no faces that can be drawn: the scene is empty"));
    }
}

TEST(Ply, WhatIsLeftOutIsSaid) {
    EXPECT_EQ(said(import_text(read_ply, square(1, "3 0 1 2\n"))), "");
    EXPECT_EQ(said(import_text(read_ply, square(1, "3 0 1 2\nrest\n"))), "a: note: 5 bytes behind the last of 2 elements are left out\n");
    EXPECT_EQ(said(import_text(read_ply, square(2, "3 0 1 2 9\n3 0 2 3 9 9\n"))), "a: warning: a line has more values than its element: the rest is left out (2 times)\n");
    ImportOptions strict;
    strict.strict = true;
    EXPECT_FALSE(import_text(read_ply, square(1, "3 0 1 2 9\n"), strict));
    EXPECT_EQ(said(import_text(read_ply, kHead + "element vertex 3\n" + kXyz + "property int w\nelement face 1\n" + kFaces + "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n")),
              "a: note: properties that are not used: vertex w\n");
}

TEST(Ply, CountsOfWhatTakesNoBytesDoNotHang) {
    EXPECT_TRUE(import_text(read_ply, kHead + "element nothing 18446744073709551615\nend_header\n"));
    EXPECT_TRUE(import_text(read_ply, kHead + "element vertex 18446744073709551615\nend_header\n"));
}

TEST(Ply, DamageDoesNoHarm) {
    const Sheet sheet{2};
    expect_no_harm(read_ply, sheet.header("ascii", "\r\n") + sheet.data(AsText()), "0123456789-+.e \n\r");
    expect_no_harm(read_ply, sheet.header("binary_little_endian", "\n") + sheet.data(AsBytes{false}), std::string_view("\0\1\2\3\4\x7f\xff\xc0", 8));
    expect_no_harm(read_ply, sheet.header("binary_big_endian", "\r") + sheet.data(AsBytes{true}), "0123456789 abcdefiloprtuvx\n");
}

TEST(Ply, IsRecognisedByItsFirstLine) {
    EXPECT_TRUE(looks_like_ply(as_bytes("ply\nformat")));
    EXPECT_TRUE(looks_like_ply(as_bytes("ply\r\n")));
    EXPECT_FALSE(looks_like_ply(as_bytes("plywood\n")));
    EXPECT_FALSE(looks_like_ply(as_bytes("ply")));
}

TEST(PlyCorpus, LoadsWhatIsGoodAndRefusesWhatIsBad) {
    if (!std::filesystem::exists(SHARED_DATA "/manifest.csv")) GTEST_SKIP() << "no shared data at " << SHARED_DATA;
    const auto [good, bad] = expect_corpus(".ply", import_ply);
    EXPECT_GE(good, 15u);
    EXPECT_GE(bad, 1u);
}

}  // namespace
}  // namespace alidade
