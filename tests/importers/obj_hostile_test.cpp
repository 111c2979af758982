// SPDX-License-Identifier: Apache-2.0
/// Damaged and malicious OBJ files, and the files that others collected. Never a crash, never a hang, always a scene that validates or an error.
#include "tests/core/run_size.h"
#include "tests/importers/obj_files.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <random>
#include <sstream>

namespace alidade {
namespace {

namespace fs = std::filesystem;

/// One of everything.
constexpr std::string_view kAll =
    "# all\nmtllib a.mtl\no one\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 0.5 0.25 1\nv 0 1 0\nv 0.5 0.5 1e-3 1\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n"
    "usemtl m\ns 1\nf 1/1/1 2/2/1 3/3/2 4\nf -1//-1 -2//-2 -3//-1\ng a b\ns off\nusemtl n\nf 1 2 3 5 4\nl 1 2\nf 1 \\\n 2 \\\n 3\no two\nf 3 4 5\n";
constexpr std::string_view kLibrary = "newmtl m\nKd 1 0 0\nNs 10\nd 0.5\nmap_Kd -s 1 2 -o 0 t.png\nillum 2\nnewmtl n\nKd 0.5\nPr 0.25\nTr 0.1\n";

void expect_scene_or_error(const ImportResult& result, const std::string& text) {
    if (result) EXPECT_FALSE(validate(result->scene).has_errors()) << validate(result->scene).text() << text;
    else EXPECT_TRUE(result.error().has_errors()) << text;
}

TEST_F(ObjFiles, TruncatedAnywhere) {
    write("a.mtl", kLibrary);
    size_t loaded = 0;
    for (size_t length = 0; length <= kAll.size(); ++length) {
        const ImportResult result = import_text(kAll.substr(0, length));
        expect_scene_or_error(result, std::string(kAll.substr(0, length)));
        loaded += result.has_value();
    }
    EXPECT_GT(loaded, kAll.size() / 2);
    EXPECT_LT(loaded, kAll.size()) << "cut in a face or a number";
}

TEST_F(ObjFiles, DamagedAnywhere) {
    std::mt19937 random(13);
    const std::string_view likely = "0123456789-+.e/ \n\\vftnosg#\r\t";
    for (int round = 0; round < 1000; ++round) {
        std::string obj(kAll), mtl(kLibrary);
        for (int i = round % 4; i >= 0; --i) {
            std::string& text = random() % 4 ? obj : mtl;
            text[random() % text.size()] = random() % 4 ? likely[random() % likely.size()] : char(random());
        }
        write("a.mtl", mtl);
        expect_scene_or_error(import_text(obj), obj);
    }
}

TEST_F(ObjFiles, RandomStatements) {
    std::mt19937 random(17);
    const char* words[] = {"v", "vt", "vn", "f", "f", "f", "o", "g", "s", "usemtl", "mtllib", "1", "2", "3", "-1", "0", "1/1", "1//1", "2/2/2", "nan", "1e30", "-0.5", "off", "\\\n", "\n", "\n"};
    for (int round = 0; round < 600; ++round) {
        std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        for (int i = 0; i < 60; ++i) text += words[random() % std::size(words)], text += " ";
        expect_scene_or_error(import_text(text), text);
    }
}

/// Small files that would take quadratic time in a careless reader.
TEST_F(ObjFiles, MaliciousSizesEndSoon) {
    std::vector<std::string> texts(5, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\n");
    const size_t many = std::max(test::run_size(100000), size_t(20000));
    for (size_t i = 0; i < many; ++i) {
        texts[0] += "o x\nf 1 2 3\n";                                             // many objects
        texts[1] += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";               // many materials
        texts[2] += "s " + std::to_string(i + 1) + "\nf 1 2 3 4\n";               // many smoothing groups
        texts[3] += "word" + std::to_string(i) + "\n";                            // many unknown statements
    }
    texts[4] += "f";
    for (size_t i = 0; i < 2 * many; ++i) texts[4] += i % 2 ? " 1 2" : " 4 3";         // one polygon that is all self-crossings
    texts[4] += "\n";
    for (size_t i = 0; i < texts.size(); ++i) {
        const std::clock_t start = std::clock();
        expect_scene_or_error(import_text(texts[i]), std::to_string(i));
        EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 60) << "text " << i;   // with sanitizers; 3 s without
    }
}

/// The row's fields; the file's name, its class, and what it exercises are of interest.
std::vector<std::string> fields(const std::string& row) {
    std::vector<std::string> out(1);
    bool quoted = false;
    for (const char c : row) {
        if (c == '"') quoted = !quoted;
        else if (c == ',' && !quoted) out.emplace_back();
        else out.back() += c;
    }
    return out;
}

/// The OBJ files of the shared data load, or are refused if its list says that they must be.
TEST(ObjCorpus, LoadsWhatIsGoodAndRefusesWhatIsBad) {
    const fs::path data = SHARED_DATA;
    std::ifstream list(data / "manifest.csv");
    if (!list) GTEST_SKIP() << "no shared data at " << data;
    size_t good = 0, bad = 0;
    for (std::string row; std::getline(list, row);) {
        const std::vector<std::string> f = fields(row);
        const fs::path file = data / f[0];
        if (file.extension() != ".obj" || !fs::exists(file)) continue;
        const ImportResult result = import_obj(file.string(), {});
        if (f[1] == "obj") {
            EXPECT_TRUE(result) << file << "\n" << result.error().text();
            ++good;
        } else if (row.find("must-refuse=yes") != std::string::npos) {
            EXPECT_FALSE(result) << file;
            ++bad;
        }
        expect_scene_or_error(result, f[0]);
    }
    EXPECT_GT(good, 50u);
    EXPECT_GT(bad, 3u);
}

}  // namespace
}  // namespace alidade
