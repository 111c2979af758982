// SPDX-License-Identifier: Apache-2.0
/// Damaged files: whatever the damage, the importer ends, and either refuses or returns a scene that validates.
#include "core/image.h"
#include "importers/gltf/gltf.h"
#include "scene/queries.h"
#include "tests/core/run_size.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

using Bytes = std::vector<std::byte>;

/// Loads damaged bytes; a scene that comes out must hold together.
void survive(const Bytes& bytes, size_t& loaded) {
    const auto result = import_gltf_bytes(bytes, "damaged.glb", "", {});
    if (!result) {
        ASSERT_TRUE(result.error().has_errors());
        return;
    }
    ++loaded;
    const Diagnostics problems = validate(result->scene);
    ASSERT_FALSE(problems.has_errors()) << problems.text();
}

class Mutations : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        const auto bytes = read_file(std::string(SHARED_DATA) + "/blender/" + GetParam());
        if (!bytes) GTEST_SKIP() << "the shared scenes are not here";
        file_ = *bytes;
        uint32_t json = 0;
        std::memcpy(&json, file_.data() + 12, 4);
        json_bytes_ = 20 + json;
    }
    Bytes file_;
    size_t json_bytes_ = 0;
    std::mt19937 random_{20261121};
};

TEST_P(Mutations, Truncated) {
    size_t loaded = 0;
    for (int i = 0; i < 200; ++i) {
        const size_t size = i < 100 ? random_() % json_bytes_ : random_() % file_.size();
        survive(Bytes(file_.begin(), file_.begin() + std::ptrdiff_t(size)), loaded);
    }
    EXPECT_EQ(loaded, 0u) << "the header says how long the file is";
}

/// Bytes of the JSON chunk: most damage it, some only change a number, a name or a reference.
TEST_P(Mutations, BytesOfTheJson) {
    size_t loaded = 0;
    for (size_t i = 0; i < std::max(test::run_size(1000), size_t(200)); ++i) {
        Bytes damaged = file_;
        for (size_t k = 0; k <= i % 3; ++k) damaged[20 + random_() % (json_bytes_ - 20)] = std::byte(random_());
        survive(damaged, loaded);
    }
    EXPECT_GT(loaded, 0u) << "a changed name is no damage";
}

/// Digits replaced by digits keep the JSON valid: wrong offsets, counts, types and indices everywhere.
TEST_P(Mutations, DigitsOfTheJson) {
    size_t loaded = 0;
    for (size_t i = 0; i < std::max(test::run_size(1000), size_t(200)); ++i) {
        Bytes damaged = file_;
        for (size_t k = 0; k <= i % 5;) {
            std::byte& b = damaged[20 + random_() % (json_bytes_ - 20)];
            if (b < std::byte('0') || b > std::byte('9')) continue;
            b = std::byte('0' + random_() % 10), ++k;
        }
        survive(damaged, loaded);
    }
    EXPECT_GT(loaded, 0u);
}

TEST_P(Mutations, BytesOfTheBuffer) {
    size_t loaded = 0;
    for (int i = 0; i < 100; ++i) {
        Bytes damaged = file_;
        for (int k = 0; k < 20; ++k) damaged[json_bytes_ + 8 + random_() % (file_.size() - json_bytes_ - 8)] = std::byte(random_());
        survive(damaged, loaded);
    }
    EXPECT_GT(loaded, 0u);
}

INSTANTIATE_TEST_SUITE_P(Blender, Mutations, testing::Values("prims.glb", "textured.glb"),
                         [](const auto& info) { return info.index ? "textured" : "prims"; });

}  // namespace
}  // namespace alidade
