// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's own includes, where the package povray-includes has put them: each is read without an error.
#include "importers/pov/reader.h"
#include "importers/pov/source.h"

#include "core/diagnostics.h"

#include <filesystem>
#include <gtest/gtest.h>

using namespace alidade;
using namespace alidade::pov;

namespace {

std::vector<std::string> standard_includes() {
    std::vector<std::string> names;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(kStandardIncludes, missing))
        if (entry.path().extension() == ".inc") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

class PovInclude : public testing::TestWithParam<std::string> {};

}  // namespace

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(PovInclude);

/// Colours and shapes come first, because several includes use them without including them; POV-Ray asks for that too.
TEST_P(PovInclude, IsReadWithoutAnError) {
    Diagnostics said;
    const std::string text = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#include \"colors.inc\"\n#include \"shapes.inc\"\n#include \"" + GetParam() + "\"\nsphere { 0, 1 }\n";
    const Program program = read_program_text("scene.pov", text, {}, said);
    EXPECT_FALSE(said.has_errors()) << said.text();
    ASSERT_GE(program.blocks.size(), 2u);
    EXPECT_EQ(program.blocks.back()->word, "sphere"_w) << "reading came to the end";
}

INSTANTIATE_TEST_SUITE_P(Standard, PovInclude, testing::ValuesIn(standard_includes()), [](const auto& info) {
    std::string name = info.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

TEST(PovIncludes, AreNamedWhereTheyAreMissing) {
    if (standard_includes().empty()) GTEST_SKIP() << "povray-includes is not installed";
    const auto hint = [](const char* text) {
        Diagnostics said;
        read_program_text("scene.pov", text, {}, said);
        return said.list().empty() ? std::string() : said.list().front().hint;
    };
    EXPECT_EQ(hint("sphere { 0, 1 pigment { Red } }"), "colors.inc declares it: #include \"colors.inc\"");
    EXPECT_EQ(hint("sphere { 0, 1 finish { Shiny } }"), "finish.inc declares it: #include \"finish.inc\"");
    EXPECT_EQ(hint("#declare Diameter = 2; sphere { 0, Diametre }"), "did you mean Diameter?");
    EXPECT_EQ(hint("sphere { 0, Fo }"), "") << "short names are near to everything";
    for (const char* no_word_fits : {"sphere { 0, Radius }", "sphere { 0, Colour }", "sphere { 0, Transform }"}) EXPECT_EQ(hint(no_word_fits), "") << no_word_fits;
    EXPECT_EQ(hint("#declare Raduis = 1; sphere { 0, Radius }"), "did you mean Raduis?") << "not the word radius";
    EXPECT_EQ(hint("#declare Pigmen = 1; sphere { 0, 1 pigmnt { rgb 1 } }"), "did you mean pigment?");
    EXPECT_EQ(hint("#declare R = 2 * sqrtt(2);"), "did you mean sqrt?");
    EXPECT_EQ(hint("Sphere { 0, 1 }"), "did you mean sphere?") << "and not the Sphere of shapes_old.inc";
    EXPECT_EQ(hint("light_source { 0, rbg 1 }"), "did you mean rgb?");
    EXPECT_EQ(hint("#include \"colrs.inc\""), "did you mean colors.inc?");
    EXPECT_EQ(hint("#include \"COLRS.INC\""), "did you mean colors.inc?");
    EXPECT_THAT(hint("#include \"some other.inc\""), testing::HasSubstr("say where it lies"));
    EXPECT_EQ(hint("sphere { 0, AA }"), "") << "which shapes.inc has for itself";
}

TEST(PovIncludes, AreAllThere) {
    if (standard_includes().empty()) GTEST_SKIP() << "povray-includes is not installed";
    EXPECT_EQ(standard_includes().size(), 39u);
}
