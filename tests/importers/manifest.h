// SPDX-License-Identifier: Apache-2.0
/// The list of the shared collection of files.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace alidade::gltf_test {

struct ManifestRow {
    std::string file, kind, exercises;
    bool must_be_refused() const { return kind == "bad" && exercises.find("must-refuse=yes") != std::string::npos; }
};

/// The glTF rows of the manifest in the folder `data`, comma-separated, with quotes where a field holds a comma. None if it is not there.
inline std::vector<ManifestRow> gltf_manifest(const std::string& data) {
    std::ifstream in(data + "/manifest.csv");
    std::vector<ManifestRow> rows;
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> fields(1);
        bool quoted = false;
        for (const char c : line) {
            if (c == '"') quoted = !quoted;
            else if (c == ',' && !quoted) fields.emplace_back();
            else fields.back() += c;
        }
        const std::string ending = std::filesystem::path(fields[0]).extension().string();
        if ((ending == ".gltf" || ending == ".glb") && fields.size() >= 9) rows.push_back({fields[0], fields[1], fields[8]});
    }
    return rows;
}

}  // namespace alidade::gltf_test
