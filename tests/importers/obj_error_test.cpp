// SPDX-License-Identifier: Apache-2.0
/// What is wrong in an OBJ file is said at its line and column, and nothing of the file is taken.
#include "tests/importers/obj_files.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Bad {
    const char* text;
    const char* error;   ///< how the messages begin
};

const Bad kBad[] = {
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "a.obj:4:7: error: the index of a vertex is 0\n    f 1 2 0\n          ^\nhint: indices count from 1"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a.obj:4:7: error: index 4 of a vertex: there are only 3"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "a.obj:4:7: error: index -4 of a vertex: there are only 3 before this line"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/0 2 3\n", "a.obj:4:5: error: the index of a texture coordinate is 0"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//0 2 3\n", "a.obj:4:6: error: the index of a normal is 0"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "a.obj:4:1: error: a face needs 3 corners, here are 2"},
    {"v 0 0 0\nf\n", "a.obj:2:1: error: a face needs 3 corners, here are 0"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", "a.obj:4:7: error: \"x\" is not the index of a vertex"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3.5\n", "a.obj:4:8: error: \"3.5\" is not a corner"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3/x\n", "a.obj:4:9: error: \"x\" is not the index of a texture coordinate"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1/1 2 3\n", "a.obj:4:8: error: \"1/1/1/1\" is not a corner"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 99999999999999999999 2 3\n", "a.obj:4:3: error: index 99999999999999999999 of a vertex: there are only 3"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4294967297/1\n", "a.obj:4:7: error: index -4294967297 of a vertex: there are only 3 before this line"},
    {"v 1 2\n", "a.obj:1:1: error: v needs 3 numbers, here are 2"},
    {"  v 1 2 # 3\n", "a.obj:1:3: error: v needs 3 numbers, here are 2"},
    {"v 1,5 0 0\n", "a.obj:1:3: error: \"1,5\" is not a number"},
    {"v 0 0 0x10\n", "a.obj:1:7: error: \"0x10\" is not a number"},
    {"v 1e 0 0\n", "a.obj:1:3: error: \"1e\" is not a number"},
    {"v . 0 0\n", "a.obj:1:3: error: \".\" is not a number"},
    {"v --1 0 0\n", "a.obj:1:3: error: \"--1\" is not a number"},
    {"vn 0 1\n", "a.obj:1:1: error: vn needs 3 numbers, here are 2"},
    {"vt\n", "a.obj:1:1: error: vt needs 1 numbers, here are 0"},
    {"\r\nv 0 0 0\rv 0 0\r\n", "a.obj:3:1: error: v needs 3 numbers"},
    {"v 0 \\\n 0 \\\n z\n", "a.obj:3:2: error: \"z\" is not a number"},
    {"", "a.obj: error: no OBJ statement is in this file"},
    {"hello world\nthis is text\n", "a.obj:1:1: warning: unknown statement \"hello\""},
    {"\xff\xfe" "v\0 \0000\0", "a.obj: error: the file is UTF-16\nhint: save it as UTF-8"},
};

TEST_F(ObjFiles, ErrorsStandAtTheirLineAndColumn) {
    for (const Bad& bad : kBad) {
        const ImportResult result = import_text(bad.text);
        ASSERT_FALSE(result) << bad.text << "\n" << dump(result->scene);
        EXPECT_TRUE(result.error().has_errors());
        EXPECT_THAT(said(result), StartsWith(bad.error)) << bad.text;
    }
}

TEST_F(ObjFiles, BinaryFilesAreRefused) {
    const ImportResult result = import_text(std::string_view("v 0 0 0\0f", 9));
    ASSERT_FALSE(result);
    EXPECT_THAT(said(result), HasSubstr("binary"));
    EXPECT_THAT(said(import_obj(path("none.obj"), {})), HasSubstr("No such file"));
    EXPECT_THAT(said(import_obj(folder_, {})), HasSubstr("is a directory"));
}

TEST_F(ObjFiles, AllErrorsAreSaidUpToALimit) {
    const ImportResult two = import_text("v 0 0\nv 0 0 0\nv a 0 0\n");
    EXPECT_EQ(two.error().errors(), 2u);
    std::string many;
    for (int i = 0; i < 100000; ++i) many += "v 0 0\n";
    EXPECT_EQ(import_text(many).error().errors(), Diagnostics::kKept);
}

struct Odd {
    const char* text;
    const char* warning;
};

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// What is left out is said once, at its first place, with its count; the rest is there.
TEST_F(ObjFiles, WhatIsLeftOutIsSaidOnce) {
    const Odd odds[] = {
        {"l 1 2\nl 2 3\n", "a.obj:5:1: warning: l is not supported: left out (2 times)"},
        {"p 1\n", "a.obj:5:1: warning: p is not supported: left out"},
        {"curv2 1 2\n", "warning: curv2 is not supported"},
        {"frobnicate 3\n", "a.obj:5:1: warning: unknown statement \"frobnicate\""},
        {"v nan 0 0\nf 1 2 4\n", "a.obj:6: warning: faces with a vertex that is not finite or is beyond 3.4e38 are left out: 1"},
        {"v 1e300 0 0\nf 1 2 4\nf 2 4 3\n", "are left out: 2"},
        {"f 1 1 2\n", "a.obj:5: warning: faces with fewer than three different corners are left out: 1"},
        {"v 1 0 0\nf 2 4 3\n", "faces with fewer than three different corners are left out: 1"},
        {"v 0 0 0 0.5\n", "the weight w of a vertex is for curves only"},
        {"v 0 0 0 1 1\n", "v with 5 numbers"},
        {"v 0 0 0 1 1 1 1\n", "v has more than 6 numbers"},
        {"v 0 0 0 nan 0 0\n", "a vertex colour is not finite"},
        {"vt nan\n", "a texture coordinate is not finite"},
        {"vn nan 0 0\n", "a normal is not finite"},
        {"s smooth\n", "a smoothing group is a number or off"},
        {"f 1/7 2 3\n", "a.obj:5:5: warning: an index of a texture coordinate names nothing: left out"},
        {"f 1//-1 2 3\n", "a.obj:5:6: warning: an index of a normal names nothing: left out"},
        {"mtllib none.mtl\n", "a.obj:5:1: warning: no material library: cannot read none.mtl: No such file"},
        {"mtllib ../x.mtl\n", "the material library \"../x.mtl\" is not read: \"..\" is not allowed"},
        {"mtllib /etc/passwd\n", "absolute paths are not allowed"},
        {"usemtl red\nf 3 2 1\n", "a.obj:5:1: warning: no library defines the material \"red\": gray is taken"},
    };
    for (const Odd& odd : odds) {
        const ImportResult result = import_text(std::string(kTriangle) + odd.text);
        ASSERT_TRUE(result) << odd.text << said(result);
        EXPECT_EQ(result->diagnostics.warnings(), 1u) << said(result);
        EXPECT_THAT(said(result), HasSubstr(odd.warning)) << odd.text;
        ASSERT_EQ(result->scene.shapes.size(), 1u);
        EXPECT_EQ(corner_at(std::get<Mesh>(result->scene.shapes[0].geometry), 0, 1), Vec3(1, 0, 0)) << "the first triangle stays: " << odd.text;
    }
}

TEST_F(ObjFiles, StrictMakesErrorsOfWhatIsNotUnderstood) {
    ImportOptions strict;
    strict.strict = true;
    EXPECT_TRUE(import_text(kTriangle, strict));
    EXPECT_FALSE(import_text(std::string(kTriangle) + "frobnicate\n", strict));
}

TEST_F(ObjFiles, WithoutFacesTheSceneIsEmpty) {
    for (const char* text : {"v 0 0 0\n", "# v\no name\n", "mtllib a.mtl\nusemtl b\n", "v 0 0 0\nl 1 1\n"}) {
        const ImportResult result = import_text(text);
        ASSERT_TRUE(result) << text << said(result);
        EXPECT_TRUE(result->scene.shapes.empty());
        EXPECT_THAT(said(result), HasSubstr("the scene is empty"));
    }
}

TEST(ObjRecognition, ByTheFirstStatement) {
    const auto looks = [](std::string_view text) { return looks_like_obj(std::as_bytes(std::span(text))); };
    for (const char* text : {"v 0 0 0", "# Blender\n\no Cube\n", "\xef\xbb\xbfmtllib a.mtl\n", "  g x\n", "usemtl a b\n"}) EXPECT_TRUE(looks(text)) << text;
    for (const char* text : {"", "#\n", "glTF", "{\"asset\": 1}", "camera { }", "vertex 1", "v", "ply\nformat", "solid x"}) EXPECT_FALSE(looks(text)) << text;
}

}  // namespace
}  // namespace alidade
