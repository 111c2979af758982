// SPDX-License-Identifier: Apache-2.0
#include "povray_values.h"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace alidade {

bool povray_is_installed() { return std::system("command -v povray > /dev/null 2>&1") == 0; }

std::string pov_text(const Vec3& p) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", p.x, p.y, p.z); }

std::vector<double> povray_values(const std::string& prelude, const std::vector<std::string>& expressions) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / fmt::format("alidade_povray_values_{}", std::random_device{}());
    fs::create_directories(folder);
    {
        std::ofstream scene(folder / "scene.pov");
        scene << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n" << prelude << "\n";
        for (const std::string& e : expressions) scene << "#debug concat(str(" << e << ", 0, 17), \"\\n\")\n";
        scene << "sphere { 0, 1 }\n";
    }
    const std::string command = fmt::format("cd '{}' && povray +Iscene.pov -D -F +W1 +H1 +WT1 -GA +GDdebug.txt +GFfatal.txt > /dev/null 2>&1", folder.string());
    const int code = std::system(command.c_str());
    std::ifstream said(folder / "fatal.txt");
    const std::string fatal((std::istreambuf_iterator<char>(said)), {});
    std::vector<double> values;
    std::ifstream debug(folder / "debug.txt");
    for (std::string word; debug >> word;) values.push_back(std::strtod(word.c_str(), nullptr));   // which reads "-nan" too
    EXPECT_EQ(code, 0) << fatal;
    EXPECT_EQ(values.size(), expressions.size()) << fatal;
    if (values.size() != expressions.size()) values.clear();
    fs::remove_all(folder);
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

}  // namespace alidade
