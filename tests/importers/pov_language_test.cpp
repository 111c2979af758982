// SPDX-License-Identifier: Apache-2.0
/// Programs of the scene language with their expectation inside: `// expect TEXT` is the next line that the program prints, `// expect error L:C TEXT`
/// the next error. A file holds many programs; `//---- name` begins one.
#include "importers/pov/reader.h"

#include "core/diagnostics.h"
#include "tests/core/folder_test.h"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

using namespace alidade;
using namespace alidade::pov;

namespace {

struct LanguageProgram {
    std::string name, text;
    std::vector<std::string> output, errors;
};

void take_expectation(const std::string& line, LanguageProgram& program) {
    const std::string mark = "// expect ", error = "error ";
    const size_t at = line.find(mark);
    if (at == std::string::npos) return;
    const std::string expected = line.substr(at + mark.size());
    if (expected.rfind(error, 0) == 0) program.errors.push_back(expected.substr(error.size()));
    else program.output.push_back(expected);
}

std::vector<LanguageProgram> programs() {
    std::vector<LanguageProgram> all;
    for (const char* file : {"values", "control", "errors"}) {
        std::ifstream in(std::string(PROGRAMS) + "/" + file + ".pov");
        for (std::string line; std::getline(in, line);) {
            if (line.rfind("//---- ", 0) == 0) {
                all.push_back({std::string(file) + ": " + line.substr(7), "", {}, {}});
                continue;
            }
            all.back().text += line + "\n";
            take_expectation(line, all.back());
        }
    }
    return all;
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

class PovLanguage : public testing::TestWithParam<LanguageProgram> {};

}  // namespace

TEST_P(PovLanguage, DoesWhatItsCommentsSay) {
    const LanguageProgram& program = GetParam();
    std::string printed;
    ReadOptions options;
    options.print = [&](TextStream stream, const std::string& text) { if (stream == TextStream::debug) printed += text; };
    Diagnostics said;
    read_program_text("program.pov", program.text, options, said);
    EXPECT_EQ(lines(printed), program.output);
    std::vector<Diagnostic> errors;
    for (const Diagnostic& d : said.list())
        if (d.severity == Severity::error) errors.push_back(d);
    ASSERT_EQ(errors.size(), program.errors.size()) << said.text();
    for (size_t i = 0; i < errors.size(); ++i) {
        const std::string got = std::to_string(errors[i].at.line) + ":" + std::to_string(errors[i].at.column) + " " + errors[i].message;
        const size_t blank = program.errors[i].find(' ');
        EXPECT_EQ(got.substr(0, got.find(' ')), program.errors[i].substr(0, blank)) << said.text();
        EXPECT_NE(got.find(program.errors[i].substr(blank + 1)), std::string::npos) << got;
    }
}

/// As POV-Ray: bytes beyond ASCII are passed where the scene begins, and nowhere else; a carriage return ends a comment.
TEST(PovText, MarksAndLineEndsOfOtherEditors) {
    std::string printed;
    ReadOptions options;
    options.print = [&](TextStream stream, const std::string& text) { if (stream == TextStream::debug) printed += text; };
    Diagnostics marked, late;
    read_program_text("program.pov", "\xEF\xBB\xBF// of Windows\r\n// of an old Macintosh\r#debug \"one \" // \r#debug \"two\" // the end", options, marked);
    EXPECT_EQ(printed, "one two");
    EXPECT_TRUE(marked.list().empty()) << marked.text();
    read_program_text("program.pov", " \xEF\xBB\xBF", options, late);
    EXPECT_NE(late.text().find("the byte 0xEF means nothing here"), std::string::npos) << late.text();
}

namespace {
struct Reads {
    std::string data, expected;      ///< what is printed of it, or a part of the error or warning
};

/// What `program` prints and says of a file "d.txt" beside it.
std::string outcome(const std::string& data, const std::string& program) {
    const test::TempFolder folder;
    std::ofstream(folder.path() / "d.txt", std::ios::binary) << data;
    std::string printed;
    ReadOptions options;
    options.print = [&](TextStream, const std::string& text) { printed += text; };
    Diagnostics said;
    read_program_text((folder.path() / "program.pov").string(), program, options, said);
    return printed + said.text();
}
}  // namespace

/// The bytes of data files as POV-Ray reads them: a value, and one more token that is mostly a comma; with the file's end behind a value its name is gone.
TEST(PovText, DataFiles) {
    const std::string numbers = "#fopen F \"d.txt\" read #declare B = 9; #read(F, A, B) #debug concat(str(defined(F), 0, 0), str(A, 0, 1), \"|\", str(B, 0, 1))";
    const std::string text = "#fopen F \"d.txt\" read #read(F, A) #debug concat(str(defined(F), 0, 0), str(strlen(A), 0, 0), str(asc(substr(A, 2, 1)), 0, 0))";
    using namespace std::string_literals;
    for (const auto& [data, expected] : {Reads{"1,2", "01.0|2.0"}, {"1,2,", "11.0|2.0"}, {"1;2", "01.0|2.0"}, {"1 2 3", "01.0|3.0"}, {"1 2 3", "a comma is missing, and what stands there is lost"}, {"- 1 -+2", "0-1.0|2.0"},
                                        {"1\0,\0\0002\x1a"s, "01.0|2.0"}, {"1//\r,/*/* */*/2", "01.0|2.0"}, {"1,2 a", "11.0|2.0"}, {"1e,2E+", "01.0|2.0"}, {"<1 +.5>.y,2", "B"}, {"1,,2", "line 1, column 3: a number is expected"},
                                        {"1,\n2..3", "line 2, column 3: the number has a second point"}, {"1,-", "not the end of the file"}, {"<1>", "a second component"}, {"<1,2,3,4,5,6>", "the > of the vector"},
                                        {"1,2 /*", "the comment is not closed"}, {"\xEF\xBB\xBF" "1,2", "the byte 0xEF"}})
        EXPECT_NE(outcome(data, numbers).find(expected), std::string::npos) << data << ": " << outcome(data, numbers);
    const std::string vectors = "#fopen F \"d.txt\" read #while (defined(F)) #read(F, A) #debug concat(vstr(3, A + <0,0,0>, \",\", 0, 0), \" \") #end";
    EXPECT_NE(outcome("<1,2,3>\n<4,5,6>\n", vectors).find("1,2,3 4,4,4 5,5,5 6,6,6 6,6,6 "), std::string::npos) << outcome("<1,2,3>\n<4,5,6>\n", vectors);
    for (const auto& [data, expected] : {Reads{"\"a\r\nb\"", "0310"}, {"\"a\n\rb\",", "1310"}, {"\"a\rb\"", "0310"}, {"\"a\r\rb\"", "0410"}, {"\"a\\nb\"", "0310"}, {"\"ab\0c\""s, "0298"}, {"\"ab\" \x1a", "0298"},
                                        {"\"a\\0b\"", "this escape sequence is not known"}, {"\"ab", "the string is not closed"}})
        EXPECT_NE(outcome(data, text).find(expected), std::string::npos) << data << ": " << outcome(data, text);
}

/// The same rules hold in scenes; a file of NULs is no scene, though they are blanks.
TEST(PovText, BytesOfScenes) {
    using namespace std::string_literals;
    for (const auto& [program, expected] : {Reads{"#debug\0str(3e,0,0)#debug\0\0str(strlen(\"a\r\nb\rc\"),0,0)"s, "35"}, {"#debug vstr(3,<1,2,3e->,\" \",0,1)", "1.0 2.0 3.0"}, {"#debug vstr(3,<1,2.5.5,3>,\" \",0,1)", "program.pov:1:21: error: the number has a second point"},
                                           {"#declare A = 3; #debug str(A,0,0) // to the end of what is no small string\n#\n", "3"}, {std::string(9, '\0'), "the file is no text"}, {"\xEF\xBB\xBF", "the file is no text"}})
        EXPECT_NE(outcome("", program).find(expected), std::string::npos) << program << ": " << outcome("", program);
}

INSTANTIATE_TEST_SUITE_P(Programs, PovLanguage, testing::ValuesIn(programs()), [](const testing::TestParamInfo<LanguageProgram>& info) {
    std::string name = std::to_string(info.index) + "_";
    for (char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
});
