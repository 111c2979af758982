// SPDX-License-Identifier: Apache-2.0
/// Meshes from strings, damage to such strings, and the rows of the shared data, for tests of the readers of PLY, STL and OFF.
#pragma once

#include "importers/mesh/mesh_file.h"
#include "scene/queries.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

namespace alidade {

inline std::span<const std::byte> as_bytes(std::string_view text) { return {reinterpret_cast<const std::byte*>(text.data()), text.size()}; }

inline ImportResult import_text(mesh::MeshReader read, std::string_view text, const ImportOptions& options = {}) {
    return mesh::import_mesh_bytes(as_bytes(text), "a", options, read);
}

/// All that was said.
inline std::string said(const ImportResult& result) { return result ? result->diagnostics.text() : result.error().text(); }

/// The only mesh of a text that must load; without triangles if there is none.
inline Mesh mesh_of(mesh::MeshReader read, std::string_view text) {
    const ImportResult result = import_text(read, text);
    EXPECT_TRUE(result) << text << "\n" << said(result);
    if (!result || result->scene.shapes.empty()) return {};
    EXPECT_FALSE(validate(result->scene).has_errors()) << validate(result->scene).text();
    return std::get<Mesh>(result->scene.shapes[0].geometry);
}

/// The corners of all triangles, in order.
inline std::vector<Vec3> corners_of(const Mesh& mesh) {
    std::vector<Vec3> corners;
    for (const Index3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) corners.push_back(mesh.origin + Vec3(mesh.positions[t[k]]));
    return corners;
}

/// The bytes of a value, in the order of a file.
template <class T> std::string bytes_of(T value, bool big_endian = false) {
    std::string out(sizeof value, '\0');
    std::memcpy(out.data(), &value, sizeof value);
    if (big_endian) std::reverse(out.begin(), out.end());
    return out;
}

inline void expect_scene_or_error(const ImportResult& result, std::string_view text) {
    if (result) EXPECT_FALSE(validate(result->scene).has_errors()) << validate(result->scene).text() << text;
    else EXPECT_TRUE(result.error().has_errors()) << text;
}

/// Reads all beginnings of a text, and the text with some bytes changed, many times: each gives a scene that validates, or an error.
inline void expect_no_harm(mesh::MeshReader read, const std::string& text, std::string_view likely, int rounds = 2000) {
    for (size_t length = 0; length < text.size(); ++length) {
        const std::string part = text.substr(0, length);   // its own memory, so that reading beyond it is found
        expect_scene_or_error(import_text(read, part), part);
    }
    std::mt19937 random(29);
    for (int round = 0; round < rounds; ++round) {
        std::string damaged = text;
        for (int i = round % 4; i >= 0; --i) damaged[random() % text.size()] = random() % 2 ? likely[random() % likely.size()] : char(random());
        expect_scene_or_error(import_text(read, damaged), damaged);
    }
}

/// Imports the files of the shared data with this ending, in lower or upper case: class obj loads, must-refuse is refused. Returns how many of each.
inline std::pair<size_t, size_t> expect_corpus(const std::string& ending, ImportResult (*import)(const std::string&, const ImportOptions&)) {
    const std::filesystem::path data = SHARED_DATA;
    std::ifstream list(data / "manifest.csv");
    size_t good = 0, bad = 0;
    for (std::string row; std::getline(list, row);) {
        const std::string name = row.substr(0, row.find(',')), rest = row.substr(std::min(row.size(), name.size() + 1));
        std::string lower = name;
        for (char& c : lower) c = char(std::tolower(static_cast<unsigned char>(c)));
        const std::filesystem::path file = data / name;
        if (!lower.ends_with(ending) || !std::filesystem::exists(file)) continue;
        const ImportResult result = import(file.string(), {});
        expect_scene_or_error(result, name);
        if (rest.starts_with("obj,")) {
            EXPECT_TRUE(result) << said(result);
            ++good;
        } else if (row.find("must-refuse=yes") != std::string::npos) {
            EXPECT_FALSE(result) << name;
            ++bad;
        }
    }
    return {good, bad};
}

}  // namespace alidade
