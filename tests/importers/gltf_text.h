// SPDX-License-Identifier: Apache-2.0
/// glTF files made of text, for tests.
#pragma once

#include "importers/gltf/gltf.h"

#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace alidade::gltf_test {

inline std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text.data(), text.size())); }

/// {"asset":{"version":"2.0"}, members}
inline std::string with_asset(const std::string& members) { return R"({"asset":{"version":"2.0"})" + (members.empty() ? "" : "," + members) + "}"; }

inline ImportResult import_text(const std::string& text, const ImportOptions& options = {}) {
    return import_gltf_bytes(bytes_of(text), "test.gltf", "", options);
}

/// The scene of `members`; fails the test if there is none.
inline Scene scene_of(const std::string& members, const ImportOptions& options = {}) {
    const auto result = import_text(with_asset(members), options);
    EXPECT_TRUE(result) << (result ? "" : result.error().text());
    return result ? result->scene : Scene();
}

inline std::string base64(const std::string& bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? uint8_t(bytes[i + k]) : 0);
        for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

template <class T> std::string packed(std::initializer_list<T> values) {
    std::string out(values.size() * sizeof(T), '\0');
    if (values.size()) std::memcpy(out.data(), std::data(values), out.size());
    return out;
}

inline std::string buffer_json(const std::string& bytes) {
    return R"({"byteLength":)" + std::to_string(bytes.size()) + R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + "\"}";
}

inline const Mesh& mesh_of(const Scene& scene, size_t shape = 0) { return std::get<Mesh>(scene.shapes.at(shape).geometry); }

/// A GLB with chunks that are padded as they must be.
inline std::string glb(std::string json, std::string bin = {}) {
    const auto u32 = [](size_t v) {
        std::string s;
        for (int i = 0; i < 4; ++i) s += char(v >> (8 * i) & 255);
        return s;
    };
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bin.resize((bin.size() + 3) / 4 * 4, '\0');
    std::string out = u32(json.size()) + "JSON" + json;
    if (!bin.empty()) out += u32(bin.size()) + std::string("BIN\0", 4) + bin;
    return "glTF" + u32(2) + u32(out.size() + 12) + out;
}

}  // namespace alidade::gltf_test
