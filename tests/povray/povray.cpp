// SPDX-License-Identifier: Apache-2.0
#include "tests/povray/povray.h"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace alidade {

namespace {

std::string whole_file(const std::filesystem::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

bool povray_is_installed() { return std::system("command -v povray > /dev/null 2>&1") == 0; }

std::string pov_text(const Vec3& p) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", p.x, p.y, p.z); }

std::string povray_debug(const std::string& scene) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / fmt::format("alidade_povray_{}", std::random_device{}());
    fs::create_directories(folder);
    std::ofstream(folder / "scene.pov") << scene << "sphere { 0, 1 }\n";
    const std::string command = fmt::format("cd '{}' && povray +Iscene.pov -D -F +W1 +H1 +WT1 -GA +GDdebug.txt +GFfatal.txt > /dev/null 2>&1", folder.string());
    const int code = std::system(command.c_str());
    EXPECT_EQ(code, 0) << whole_file(folder / "fatal.txt");
    std::string printed = whole_file(folder / "debug.txt");
    fs::remove_all(folder);
    return printed;
}

std::vector<double> povray_values(const std::string& prelude, const std::vector<std::string>& expressions) {
    std::string scene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n" + prelude + "\n";
    for (const std::string& e : expressions) scene += fmt::format("#debug concat(str({}, 0, 17), \"\\n\")\n", e);
    std::vector<double> values;
    std::istringstream printed(povray_debug(scene));
    for (std::string word; printed >> word;) values.push_back(std::strtod(word.c_str(), nullptr));   // which reads "-nan" too
    EXPECT_EQ(values.size(), expressions.size());
    if (values.size() != expressions.size()) values.clear();
    return values;
}

std::vector<PovVector> pov_vectors() {
    std::vector<PovVector> rows;
    std::ifstream file(std::filesystem::path(ALIDADE_SHARED_RESEARCH) / "pov-pattern-vectors.csv");
    std::string line;
    for (std::getline(file, line); std::getline(file, line);) {   // declarations hold commas, in quotes; the last four columns do not
        std::vector<std::string> tail;
        std::string rest = line;
        for (int i = 0; i < 4; ++i) {
            const size_t comma = rest.rfind(',');
            tail.push_back(rest.substr(comma + 1));
            rest.resize(comma);
        }
        const size_t comma = rest.find(',');
        std::string declaration = rest.substr(comma + 1);
        if (declaration.size() > 1 && declaration.front() == '"') declaration = declaration.substr(1, declaration.size() - 2);
        rows.push_back({rest.substr(0, comma), declaration, {std::stod(tail[3]), std::stod(tail[2]), std::stod(tail[1])}, std::stod(tail[0])});
    }
    return rows;
}

namespace {

/// Fields between commas, in quotes where they hold any; a quote in quotes is doubled.
std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> out(1);
    bool quoted = false;
    for (size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') out.back() += line[i++];
        else if (line[i] == '"') quoted = !quoted;
        else if (line[i] == ',' && !quoted) out.emplace_back();
        else out.back() += line[i];
    }
    return out;
}

Vec3 vector_of(const std::string& text) {
    Vec3 v(0);
    EXPECT_EQ(std::sscanf(text.c_str(), "%lf,%lf,%lf", &v.x, &v.y, &v.z), 3) << text;
    return v;
}

}  // namespace

std::vector<PovObjectVector> pov_object_vectors() {
    std::vector<PovObjectVector> rows;
    std::ifstream file(std::filesystem::path(ALIDADE_SHARED_RESEARCH) / "pov-object-vectors.csv");
    std::string line;
    for (std::getline(file, line); std::getline(file, line);) {
        const std::vector<std::string> f = fields(line);
        EXPECT_EQ(f.size(), 6u) << line;
        if (f.size() == 6) rows.push_back({f[0], f[1], vector_of(f[2]), vector_of(f[3]), vector_of(f[4]), vector_of(f[5])});
    }
    return rows;
}

}  // namespace alidade
