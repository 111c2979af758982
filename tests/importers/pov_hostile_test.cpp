// SPDX-License-Identifier: Apache-2.0
/// Scenes that are made to hurt: each ends in an error that says where, soon. Limits are lowered where only their size would take time.
#include "importers/pov/reader.h"

#include "core/diagnostics.h"
#include "tests/core/folder_test.h"
#include "tests/core/run_size.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

using namespace alidade;
using namespace alidade::pov;

namespace {

/// Made when its test runs: some are 100 MB.
struct Text {
    std::string head, piece = {};
    size_t times = 0;
    std::string tail = {};

    std::string made() const;
};

struct Hostile {
    const char* name;
    Text text;
    std::string message;
};

std::string repeated(const std::string& piece, size_t times) {
    std::string all;
    all.reserve(piece.size() * times);
    for (size_t i = 0; i < times; ++i) all += piece;
    return all;
}

std::string Text::made() const { return head + repeated(piece, times) + tail; }

std::string macro_bomb() {
    std::string text;
    for (char c = 'A'; c < 'J'; ++c) text += std::string("#macro ") + c + "() " + repeated(std::string(1, char(c + 1)) + "() ", 10) + "#end\n";
    return text + "#macro J() #end\nA()\n";
}

std::vector<Hostile> cases() {
    return {
        {"EndlessWhile", {"#while (1) #declare A = 1; #end"}, "never end"},
        {"EndlessFor", {"#for (i, 0, 1) #declare i = 0; #end"}, "never end"},
        {"MacroBomb", {macro_bomb()}, "never end"},
        {"EndlessRecursion", {"#macro M() M() #end M()"}, "call one another"},
        {"RecursionInDeclarations", {"#macro M() #local A = M() + 1; A #end #declare B = M();"}, "call one another"},
        {"HugeArray", {"#declare A = array[1e9];"}, "elements"},
        {"HugeArrayOfManyDimensions", {"#declare A = array[10000][10000][10000];"}, "elements"},
        {"ManyArrays", {"#declare A = array[1000000]; #declare B = array[100]; #for (i, 0, 99) #declare B[i] = A; #end"}, "elements"},
        {"Control", {"sphere { 0, \x01 1 }"}, "the byte 0x01 means nothing here"},
        {"DeepBrackets", {"#declare A = ", "(", 1000000}, "nested too deeply"},
        {"DeepCalls", {"#declare A = ", "abs(", 100000}, "nested too deeply: more than 500"},
        {"DeepStrings", {"#declare A = ", "concat(", 100000}, "nested too deeply"},
        {"DeepSubscripts", {"#declare A = array[1] { 0 } #declare B = ", "A[", 100000}, "nested too deeply"},
        {"DeepCallsOfFunctions", {"#declare F = function(x) { x } #declare A = ", "F(", 100000}, "nested too deeply"},
        {"DeepFunctions", {"#declare F = function(x) { ", "(", 100000, "x } #declare A = F(1);"}, "of a function are nested too deeply"},
        {"DeepSigns", {"#declare F = function(x) { ", "-", 100000, "x } #declare A = F(1);"}, "- is not expected in a function"},
        {"PrintingForEver", {"#for (i, 0, 1e300, 1) #debug \"x\" #end"}, "never end"},
        {"DeepUnary", {"#declare A = ", "-", 1000000, "1;"}, "nested too deeply"},
        {"DeepBlocks", {"", "union {", 1000000}, "nested too deeply"},
        {"DeepEntries", {"sphere {", "[", 1000000}, "] is expected, not ["},
        {"DeepMaps", {"pigment { color_map {", "[0 pigment { color_map {", 1000000}, "nested too deeply"},
        {"DeepVectors", {"#declare A = ", "<", 1000000}, "nested too deeply"},
        {"DeepConditions", {"#declare A = (", "1 ? ", 1000000}, "nested too deeply"},
        {"DeepIfs", {"", "#if (1) ", 1000000}, "has no #end"},
        {"DeepComments", {"", "/*", 1000000}, "not closed"},
        {"DeepArrays", {"#declare A = ", "array[1] {", 100000}, "nested too deeply"},
        {"ObjectsOfOneAnother", {"#declare A = sphere { 0, 1 } #while (1) #declare A = union { object { A } } #end"}, "too deeply"},
        {"ArraysOfOneAnother", {"#declare A = array[1] {1} #while (1) #declare B = array[1] {A} #declare A = B; #end"}, "too deeply"},
        {"FunctionsOfOneAnother", {"#declare A = function { x } #while (1) #declare B = function { A(x, y, z) } #declare A = B; #end"}, "too deeply"},
        {"FunctionsThatDouble", {"#declare F = function(x) { x } #for (i, 1, 60) #declare G = function(x) { F(x) + F(x) } #declare F = G; #end #debug str(F(1), 0, 3)"}, "never end"},
        {"LongString", {"#declare A = \"0123456789\"; #while (1) #declare A = concat(A, A); #end"}, "string has more than"},
        {"ManyObjects", {"#while (1) union { sphere { 0, 1 } sphere { 1, 2 } } #end"}, "words and values"},
        {"ManyTerms", {"#declare A = ", "1+", 1000000}, "expected"},
        {"LongLine", {"", "sphere { 0, 1 } ", 6'400'000, "&"}, "words and values"},
        {"LongName", {"", "a", 100'000'000}, "more than 200 characters"},
        {"LongVector", {"quartic { <", "1,", 1000000, ">"}, "more than 1000"},
        {"ManyErrors", {"", "#declare A = ;\n", 100000}, "expected"},
        {"EndOfTextEverywhere", {"#macro M("}, "expected"},
    };
}

class PovHostile : public testing::TestWithParam<Hostile> {};

/// CPU seconds that a hostile scene may take: more where the tests run at a part of their sizes, which means under a sanitizer.
double allowed_seconds() {
    return 10 / std::min(test::run_scale(), 1.0);
}

}  // namespace

TEST_P(PovHostile, EndsInALocatedErrorSoon) {
    const std::clock_t begin = std::clock();   // of this process: the machine may be busy with others
    Diagnostics said;
    ReadOptions options;
    options.limits.tokens_read = 40'000'000;     // a fifth of the default
    options.limits.loop_turns = 5'000'000;
    options.limits.depth = 2'000;               // what is read is taken apart on this thread's stack
    read_program_text("hostile.pov", GetParam().text.made(), options, said);
    ASSERT_TRUE(said.has_errors());
    const Diagnostic& last = said.list().back();
    EXPECT_NE(said.text().find(GetParam().message), std::string::npos) << said.text().substr(0, 2000);
    EXPECT_GT(last.at.line, 0u);
    EXPECT_GT(last.at.column, 0u);
    EXPECT_LT(said.text().size(), 100000u) << "messages show a part of a long line";
    EXPECT_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, allowed_seconds());
}

INSTANTIATE_TEST_SUITE_P(Scenes, PovHostile, testing::ValuesIn(cases()), [](const auto& info) { return std::string(info.param.name); });

/// An include that includes itself, and one that leads out of the folder by a link.
TEST(PovFiles, CyclesAndLinksOutAreErrors) {
    namespace fs = std::filesystem;
    const test::TempFolder temporary;
    const fs::path& folder = temporary.path();
    fs::create_directories(folder / "scene");
    std::ofstream(folder / "scene" / "a.inc") << "#include \"a.inc\"\n";
    std::ofstream(folder / "secret.inc") << "#debug \"secret\"\n";
    fs::create_symlink(folder / "secret.inc", folder / "scene" / "link.inc");
    const std::string scene = (folder / "scene" / "scene.pov").string();
    for (const auto& [text, message] : {std::pair("#include \"a.inc\"", "include or call one another"), std::pair("#include \"link.inc\"", "is not found"),
                                        std::pair("#include \"../secret.inc\"", "is not found"), std::pair("#fopen F \"../secret.inc\" read", "is not found")}) {
        Diagnostics said;
        read_program_text(scene, text, {}, said);
        ASSERT_TRUE(said.has_errors()) << text;
        EXPECT_NE(said.text().find(message), std::string::npos) << said.text();
    }
}

/// What a scene writes, it can read again; elsewhere than in the allowed folder it writes nothing.
TEST(PovFiles, WritingAndReadingBack) {
    namespace fs = std::filesystem;
    const test::TempFolder temporary;
    const fs::path& folder = temporary.path();
    ReadOptions options;
    options.write_folder = folder.string();
    std::string printed;
    options.print = [&](TextStream, const std::string& text) { printed += text; };
    Diagnostics said;
    read_program_text("scene.pov",
                      "#fopen F \"o.txt\" write #write(F, 1, \",\", <1,2,3>, \",\", 1/3, \",\\\"text\\\",\", 5, \"\\n\") #fclose F\n"
                      "#fopen G \"o.txt\" read #read(G, A, V, B, T)\n"
                      "#debug concat(str(A, 0, 0), vstr(3, V, \",\", 0, 0), str(B, 0, 6), T, str(defined(G), 0, 0)) #read(G, A) #debug str(defined(G), 0, 0)",
                      options, said);
    EXPECT_FALSE(said.has_errors()) << said.text();
    EXPECT_EQ(printed, "11,2,30.333333text10");
    std::ifstream in(folder / "o.txt");
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "1,<1,2,3> ,0.333333,\"text\",5");
    Diagnostics refused;
    read_program_text("scene.pov", "#fopen F \"../o.txt\" write", options, refused);
    EXPECT_NE(refused.text().find("outside"), std::string::npos) << refused.text();
}

/// An include that the scene writes anew is read anew, in memory and on the disk; strings.inc needs that. POV-Ray prints the same.
TEST(PovFiles, WhatIsWrittenIsIncludedAsItIs) {
    namespace fs = std::filesystem;
    for (const bool on_disk : {false, true}) {
        const test::TempFolder temporary;
        const fs::path& folder = temporary.path();
        ReadOptions options;
        if (on_disk) options.write_folder = folder.string();
        std::string printed;
        options.print = [&](TextStream where, const std::string& text) { printed += where == TextStream::debug ? text : ""; };
        Diagnostics said;
        read_program_text((folder / "scene.pov").string(),
                          "#macro Through(N) #fopen W \"a.inc\" write #write(W, \"#declare G = \", N, \";\") #fclose W #include \"a.inc\" #debug str(G, 0, 0) #end\n"
                          "Through(1) Through(2) Through(2) Through(3)\n",
                          options, said);
        EXPECT_FALSE(said.has_errors()) << said.text();
        EXPECT_EQ(printed, "1223");
        EXPECT_EQ(fs::exists(folder / "a.inc"), on_disk);
    }
}

/// Without leave to write, a scene's files are in memory alone.
TEST(PovFiles, WhatMayNotBeWrittenIsKept) {
    std::string printed;
    ReadOptions options;
    options.print = [&](TextStream, const std::string& text) { printed += text; };
    Diagnostics said;
    const std::string name = "alidade_kept_in_memory.txt";
    const std::string open = "#fopen F \"" + name + "\" ";
    read_program_text("scene.pov", open + "write #write(F, 1, \",\\n\") #fclose F\n" + open + "append #write(F, 2) #fclose F\n" + open + "read #read(F, A, B) #debug str(A + B, 0, 0)", options, said);
    EXPECT_FALSE(said.has_errors()) << said.text();
    EXPECT_EQ(printed, "3");
    EXPECT_NE(said.text().find("is not written, since --allow-write DIR has not allowed it"), std::string::npos) << said.text();
    EXPECT_FALSE(std::filesystem::exists(name));
}

/// Include names in another case are found with a warning, and not at all when the reader is strict.
TEST(PovFiles, OtherCase) {
    namespace fs = std::filesystem;
    const test::TempFolder temporary;
    const fs::path& folder = temporary.path();
    std::ofstream(folder / "lower.inc") << "#declare A = 1;\n";
    for (bool strict : {false, true}) {
        ReadOptions options;
        options.strict = strict;
        Diagnostics said;
        read_program_text((folder / "s.pov").string(), "#include \"LOWER.INC\"\nsphere { 0, A }\n", options, said);
        EXPECT_EQ(said.has_errors(), strict) << said.text();
        EXPECT_EQ(said.warnings(), strict ? 0u : 1u);
    }
}
