// SPDX-License-Identifier: Apache-2.0
/// Limits of what a scene may ask for: each can be raised and lowered by its name, and its error says so.
#include "importers/pov/limits.h"

#include "importers/importer.h"
#include "tests/core/folder_test.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade::pov {
namespace {

using testing::HasSubstr;

/// A scene for each limit that exceeds the default no, and a low one yes.
const char* scene_of(const std::string& limit) {
    if (limit == "steps" || limit == "turns") return "#for(I, 1, 1000) #declare A = I; #end";
    if (limit == "tokens") return "sphere { 0, 1 } sphere { 0, 1 } sphere { 0, 1 } sphere { 0, 1 } sphere { 0, 1 } sphere { 0, 1 }";
    if (limit == "levels") return "#macro A(N) #if(N) A(N - 1) #end #end A(40)";
    if (limit == "nesting") return "#declare A = ((((((((((((((((((((((((1))))))))))))))))))))))));";
    if (limit == "depth") return "#declare A = sphere { 0, 1 } #for(I, 1, 30) #declare A = union { object { A } sphere { I, 1 } } #end object { A }";
    if (limit == "elements") return "#declare A = array[100];";
    if (limit == "items") return "union { #for(I, 1, 40) sphere { I, 1 } #end }";
    if (limit == "copies") return "#declare A = sphere { 0, 1 } #for(I, 1, 6) #declare A = merge { object { A } object { A translate x } } #end object { A }";
    if (limit == "string") return "#declare A = concat(\"0123456789012345678901234567890\", \"0123456789012345678901234567890\");";
    if (limit == "written") return "#fopen F \"a\" write #write(F, \"0123456789012345678901234567890\") #fclose F";
    return nullptr;
}

std::string said_of(const std::string& text, const Limits& limits) {
    const test::TempFolder folder;
    const std::string path = (folder.path() / "scene.pov").string();
    std::ofstream(path) << text << "\n";
    ImportOptions options;
    options.limits = limits;
    options.write_folder = folder.path().string();
    const ImportResult read = import_scene(path, options);
    return read ? "" : read.error().text();
}

TEST(PovLimits, EachEndsAndCanBeRaised) {
    for (const LimitEntry& entry : limit_entries()) {
        SCOPED_TRACE(entry.name);
        const char* text = scene_of(entry.name);
        ASSERT_TRUE(text);
        EXPECT_EQ(said_of(text, {}), "");
        Limits low;
        ASSERT_EQ(set_limit(low, std::string(entry.name) + "=20"), "");
        const std::string said = said_of(text, low);
        EXPECT_THAT(said, HasSubstr(std::string("--limit ") + entry.name + "="));
        EXPECT_THAT(said, HasSubstr("scene.pov:1:"));
        ASSERT_EQ(set_limit(low, std::string(entry.name) + "=2e3"), "");
        EXPECT_EQ(low.*entry.value, 2000u);
        low.tokens_read = std::max(low.tokens_read, uint64_t(100'000));
        EXPECT_EQ(said_of(text, low), "");
    }
}

TEST(PovLimits, WordsThatSetNone) {
    Limits limits;
    EXPECT_THAT(set_limit(limits, "turnes=3"), HasSubstr("there is no limit 'turnes': steps, turns"));
    for (const char* word : {"turns", "turns=", "turns=0", "turns=x", "turns=1e300", "turns=nan", "nesting=1e5", "turns=3x"}) EXPECT_THAT(set_limit(limits, word), HasSubstr("a number from 1 to")) << word;
    EXPECT_EQ(limits.loop_turns, Limits().loop_turns);
}

/// As people's loops make them, which POV-Ray takes 10,000 deep.
TEST(PovLimits, ObjectsOfObjectsStandDeepInOneAnother) {
    for (const char* operation : {"union", "difference"})
        EXPECT_EQ(said_of(std::string("#declare A = sphere { 0, 1 }\n#for(I, 1, 5000) #declare A = ") + operation + " { object { A } sphere { I, 1 } } #end\nobject { A }", {}), "") << operation;
}

/// Levels of two names each are more objects than any memory holds, but a scene of as many objects of its own is not too large.
TEST(PovLimits, ObjectsThatAreNamedTwiceAgainAndAgain) {
    for (const char* operation : {"union", "merge", "intersection", "difference"}) {
        const std::string text = std::string("#declare A = sphere { 0, 1 }\n#for(I, 1, 40) #declare A = ") + operation + " { object { A } object { A translate x * I } } #end\nobject { A }";
        EXPECT_THAT(said_of(text, {}), HasSubstr("scene.pov:3:")) << operation;
        EXPECT_THAT(said_of(text, {}), HasSubstr("the limit is 1000000")) << operation;
    }
    for (const char* map : {"pigment_map { [0 P] [1 P scale 2] }", "pigment_map { [0 P scale 3] [1 P scale 2] }"})
        EXPECT_THAT(said_of(std::string("#declare P = pigment { rgb 1 }\n#for(I, 1, 40)\n#declare P = pigment { gradient x ") + map + " } #end\nsphere { 0, 1 pigment { P } }", {}), HasSubstr("scene.pov:4:")) << map;
    EXPECT_THAT(said_of("#declare N = normal { bumps }\n#for(I, 1, 40)\n#declare N = normal { average normal_map { [1 N] [1 N scale 2] } } #end\nsphere { 0, 1 normal { N } }", {}), HasSubstr("the limit is 1000000"));
    // One of a map's entries is looked up, or two: what a scene is, and not what it could be.
    for (const char* map : {"gradient x pigment_map { [.5 P] [.5 P scale 2] }", "checker pigment { P } pigment { P scale 2 }"})
        EXPECT_EQ(said_of(std::string("#declare P = pigment { rgb 1 }\n#for(I, 1, 40)\n#declare P = pigment { ") + map + " } #end\nsphere { 0, 1 pigment { P } }", {}), "") << map;
    Limits low;
    low.copies = 10;
    EXPECT_EQ(said_of("#for(I, 1, 50) sphere { I, 1 } #end", low), "");
}

/// Bounds of bounds that double at every level have their box in the time that one level takes.
TEST(PovLimits, ExtentsOfBoundsThatDouble) {
    const auto loop = [](const std::string& step, int times) { return "#declare A = sphere { 0, 1 }\n#for(I, 1, " + std::to_string(times) + ")\n#declare A = " + step + "\n#declare M = max_extent(A); #end sphere { 0, 1 }"; };
    for (const char* limit : {"bounded_by { object { A } object { A } }", "clipped_by { object { A } object { A } }"}) {
        const std::string twice = std::string("sphere { 0, 1 ") + limit;
        EXPECT_EQ(said_of(loop(twice + " }", 200), {}), "");
        EXPECT_EQ(said_of(loop(twice + " scale 2 }", 200), {}), "");
    }
    EXPECT_THAT(said_of(loop("object { A bounded_by { sphere { 0, 9 } } scale 2 }", 1500), {}), HasSubstr("error: more than 1000000 copies of what clips and bounds objects are moved"));
    EXPECT_EQ(said_of(loop("union { object { A } object { A translate x } bounded_by { sphere { 0, 9 } } }", 200), {}), "");
}

/// What is asked of each ray or point by functions that call one another, or that call themselves twice.
TEST(PovLimits, WhatIsAskedInOneAnother) {
    const auto loop = [](const std::string& begin, const std::string& step, int times) { return "#declare A = " + begin + ";\n#for(I, 1, " + std::to_string(times) + ")\n#declare A = " + step + " #end\n"; };
    const std::string ball = "sphere { 0, 1 }";
    EXPECT_THAT(said_of(loop(ball, "sphere { 0, 1 bounded_by { object { A } } }", 3000) + "object { A }", {}), HasSubstr("scene.pov:3:"));
    EXPECT_THAT(said_of(loop(ball, "sphere { 0, 1 bounded_by { object { A } } bounded_by { object { A translate x } } }", 26) + "object { A }", {}), HasSubstr("the limit is 1000000"));
    EXPECT_THAT(said_of(loop("pigment { rgb 1 }", "pigment { pigment_pattern { A } }", 3000) + "sphere { 0, 1 pigment { A } }", {}), HasSubstr("more than 1000 levels deep"));
    EXPECT_THAT(said_of(loop("texture { pigment { rgb 1 } }", "texture { average texture_map { [1 A] [1 A scale 2] } }", 30) + "sphere { 0, 1 texture { A } }", {}), HasSubstr("textures that are named in one another"));
    EXPECT_THAT(said_of(loop("function { x }", "function { pattern { function { A(x, y, z) } } }", 3000) + "sphere { 0, 1 pigment { function { A(x, y, z) } } }", {}), HasSubstr("too deep"));
    EXPECT_THAT(said_of(loop("function { x }", "function { pattern { function { A(x, y, z) } } }", 400) + "sphere { 0, 1 pigment { function { A(x, y, z) } } }", {}), HasSubstr("error"));
    EXPECT_EQ(said_of(loop("function { x }", "function { pattern { function { A(x, y, z) } } }", 50) + "sphere { 0, 1 pigment { function { A(x, y, z) } } }", {}), "");
    EXPECT_THAT(said_of(loop("function { x }", "function { A(x, y, z) + A(y, z, x) }", 30) + "sphere { 0, 1 pigment { function { A(x, y, z) } } }", {}), HasSubstr("the limit is 1000000"));
    EXPECT_THAT(said_of(loop("function { x }", "function { pattern { function { A(x, y, z) + A(y, z, x) } } }", 30) + "sphere { 0, 1 normal { function { A(x, y, z) } } }", {}), HasSubstr("the limit is 1000000"));
    EXPECT_THAT(said_of(loop("function { x }", "function { A(x, y, z) }", 300) + "sphere { 0, 1 pigment { function { A(x, y, z) } } }", {}), HasSubstr("more than 200 functions call one another"));
    EXPECT_EQ(said_of(loop("texture { pigment { rgb 1 } }", "texture { checker texture { A } texture { A scale 2 } }", 30) + "sphere { 0, 1 texture { A } }", {}), "");
}

/// Functions of pigments of functions: shown, asked while the scene is read, in maps, and in the pictures of one another.
TEST(PovLimits, FunctionsOfPigmentsOfFunctions) {
    const auto loop = [](const std::string& step, int times) { return "#declare A = function { pigment { gradient x } };\n#for(I, 1, " + std::to_string(times) + ")\n#declare A = function { pigment { " + step + " } } #end\n"; };
    for (const char* step : {"function { A(x, y, z).red }", "average pigment_map { [1 function { A(x, y, z).hf }] [1 rgb 1] }", "image_map { function 2,2 { A(x, y, z).red } }", "image_pattern { function 2,2 { pigment { function { A(x, y, z).red } } } }", "pigment_pattern { function { A(x, y, z).red } }"})
        for (const char* asked : {"sphere { 0, 1 pigment { function { A(x, y, z).red } } }", "sphere { 0, 1 normal { function { A(x, y, z).gray } } }", "#declare Value = A(1, 2, 3).red; sphere { 0, 1 }", "sphere { 0, 1 pigment { image_map { function 2,2 { A(x, y, z).red } } } }"}) {
            EXPECT_EQ(said_of(loop(step, 20) + asked, {}), "") << step << "  " << asked;
            said_of(loop(step, 480) + asked, {});   // as deep as it may be taken
            EXPECT_THAT(said_of(loop(step, 3000) + asked, {}), HasSubstr(": error: ")) << step << "  " << asked;
        }
}

}  // namespace
}  // namespace alidade::pov
