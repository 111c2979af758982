// SPDX-License-Identifier: Apache-2.0
/// Scenes of a few lines, read.
#pragma once

#include "importers/importer.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace alidade {

class PovBuilders : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / fmt::format("alidade_pov_builders_{}", std::random_device{}());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    ImportResult import(const std::string& text, const ImportOptions& options = {}) const { return import_scene(write("s.pov", text), options); }
    /// The scene, or an empty one and a failure.
    Scene scene(const std::string& text) const {
        auto result = import(text);
        EXPECT_TRUE(result) << (result ? "" : result.error().text());
        return result ? std::move(result->scene) : Scene();
    }
    std::string said(const std::string& text) const {
        const auto result = import(text);
        return result ? result->diagnostics.text() : result.error().text();
    }
    static void expect_near(const Vec3& a, const Vec3& b, double error = 1e-12) { EXPECT_LT(length(a - b), error) << a.x << " " << a.y << " " << a.z; }

    std::filesystem::path folder_;
};

}  // namespace alidade
