// SPDX-License-Identifier: Apache-2.0
/// Programs of the scene language with their expectation inside: `// expect TEXT` is the next line that the program prints, `// expect error L:C TEXT`
/// the next error. A file holds many programs; `//---- name` begins one.
#include "importers/pov/reader.h"

#include "core/diagnostics.h"

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

INSTANTIATE_TEST_SUITE_P(Programs, PovLanguage, testing::ValuesIn(programs()), [](const testing::TestParamInfo<LanguageProgram>& info) {
    std::string name = std::to_string(info.index) + "_";
    for (char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
});
