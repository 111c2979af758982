// SPDX-License-Identifier: Apache-2.0
/// OBJ scenes from strings, for tests.
#pragma once

#include "importers/mesh/obj.h"
#include "scene/queries.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace alidade {

/// A folder of its own for each test, removed afterwards.
class ObjFiles : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = testing::TempDir() + "alidade-obj-XXXXXX";
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    std::string write(const std::string& name, std::string_view text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }
    ImportResult import_text(std::string_view text, const ImportOptions& options = {}) const { return import_obj(write("a.obj", text), options); }

    /// The only mesh of a text that must load.
    Mesh mesh_of(std::string_view text) const {
        const ImportResult result = import_text(text);
        if (!result) {
            ADD_FAILURE() << text << "\n" << result.error().text();
            return {};
        }
        EXPECT_FALSE(validate(result->scene).has_errors()) << validate(result->scene).text();
        EXPECT_EQ(result->scene.shapes.size(), 1u) << text;
        return result->scene.shapes.empty() ? Mesh() : std::get<Mesh>(result->scene.shapes[0].geometry);
    }
    /// All that was said, with the folder's name taken out.
    std::string said(const ImportResult& result) const {
        std::string text = result ? result->diagnostics.text() : result.error().text();
        for (size_t at; (at = text.find(folder_ + "/")) != std::string::npos;) text.erase(at, folder_.size() + 1);
        return text;
    }

    std::string folder_;
};

/// The place of a triangle's corner.
inline Vec3 corner_at(const Mesh& mesh, size_t triangle, int corner) { return mesh.origin + Vec3(mesh.positions[mesh.triangles[triangle][corner]]); }

}  // namespace alidade
