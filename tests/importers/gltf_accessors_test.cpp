// SPDX-License-Identifier: Apache-2.0
/// Accessors of every type, against values computed by hand from glTF 2.0, sections 3.6.2.2 to 3.6.2.4.
#include "importers/gltf/accessors.h"
#include "tests/importers/gltf_text.h"

#include <gmock/gmock.h>
#include <random>

namespace alidade::gltf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Case {
    const char* name;
    int component, type;
    bool normalized;
    size_t count, stride;
    std::string bytes;
    std::vector<float> values;
};

Model model_of(const Case& c) {
    Model model;
    model.buffers.emplace_back();
    model.buffers[0].data.assign(c.bytes.begin(), c.bytes.end());
    model.bufferViews.emplace_back();
    model.bufferViews[0].buffer = 0;
    model.bufferViews[0].byteLength = c.bytes.size();
    model.bufferViews[0].byteStride = c.stride;
    tinygltf::Accessor a;
    a.bufferView = 0;
    a.componentType = c.component;
    a.type = c.type;
    a.count = c.count;
    a.normalized = c.normalized;
    model.accessors.push_back(a);
    return model;
}

template <class T> std::string packed(std::initializer_list<T> values) { return gltf_test::packed(values); }

std::vector<Case> cases() {
    const std::string bytes_08 = packed<uint8_t>({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
    return {
        {"byte", 5120, TINYGLTF_TYPE_SCALAR, false, 3, 0, packed<int8_t>({-128, 0, 127}), {-128, 0, 127}},
        {"normalised byte", 5120, TINYGLTF_TYPE_SCALAR, true, 4, 0, packed<int8_t>({-128, -127, 0, 127}), {-1, -1, 0, 1}},
        {"unsigned byte", 5121, TINYGLTF_TYPE_VEC2, false, 2, 0, packed<uint8_t>({0, 255, 1, 2}), {0, 255, 1, 2}},
        {"normalised unsigned byte", 5121, TINYGLTF_TYPE_SCALAR, true, 3, 0, packed<uint8_t>({0, 51, 255}), {0, 0.2f, 1}},
        {"short", 5122, TINYGLTF_TYPE_SCALAR, false, 2, 0, packed<int16_t>({-32768, 32767}), {-32768, 32767}},
        {"normalised short", 5122, TINYGLTF_TYPE_SCALAR, true, 3, 0, packed<int16_t>({-32768, -32767, 32767}), {-1, -1, 1}},
        {"unsigned short", 5123, TINYGLTF_TYPE_VEC3, false, 1, 0, packed<uint16_t>({0, 1, 65535}), {0, 1, 65535}},
        {"normalised unsigned short", 5123, TINYGLTF_TYPE_SCALAR, true, 2, 0, packed<uint16_t>({13107, 65535}), {0.2f, 1}},
        {"unsigned int", 5125, TINYGLTF_TYPE_SCALAR, false, 2, 0, packed<uint32_t>({7, 1u << 24}), {7, 16777216}},
        {"float", 5126, TINYGLTF_TYPE_VEC4, false, 1, 0, packed<float>({1, -2, 3.5f, 1e30f}), {1, -2, 3.5f, 1e30f}},
        {"strided", 5121, TINYGLTF_TYPE_VEC3, false, 3, 5, bytes_08, {0, 1, 2, 5, 6, 7, 10, 11, 12}},
        // Columns of matrices start at multiples of 4 bytes.
        {"matrix of 2 padded columns of bytes", 5121, TINYGLTF_TYPE_MAT2, false, 2, 0, bytes_08, {0, 1, 4, 5, 8, 9, 12, 13}},
        {"matrix of 3 padded columns of bytes", 5121, TINYGLTF_TYPE_MAT3, false, 1, 0, bytes_08, {0, 1, 2, 4, 5, 6, 8, 9, 10}},
        {"matrix of 3 padded columns of shorts",
         5123,
         TINYGLTF_TYPE_MAT3,
         false,
         1,
         0,
         packed<uint16_t>({1, 2, 3, 99, 4, 5, 6, 99, 7, 8, 9, 99}),
         {1, 2, 3, 4, 5, 6, 7, 8, 9}},
        {"matrix of 2 columns of shorts", 5123, TINYGLTF_TYPE_MAT2, false, 1, 0, packed<uint16_t>({1, 2, 3, 4}), {1, 2, 3, 4}},
        {"matrix of 4 columns of bytes", 5121, TINYGLTF_TYPE_MAT4, false, 1, 0, bytes_08, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}},
    };
}

TEST(Accessors, EveryTypeAgainstTheTable) {
    for (const Case& c : cases()) EXPECT_EQ(read_floats(model_of(c), 0), c.values) << c.name;
}

/// Reading some elements is reading all and keeping those.
TEST(Accessors, ASelectionAgreesWithReadingAll) {
    std::string bytes(64 * 8, '\0');
    std::mt19937 random(1);
    for (char& b : bytes) b = char(random());
    Model model = model_of({"", 5123, TINYGLTF_TYPE_VEC3, true, 60, 8, bytes, {}});
    // Sparse: elements 3 and 40 are replaced by what elements 1 and 2 of another view hold.
    model.buffers.emplace_back();
    const std::string sparse = packed<uint16_t>({3, 40}) + packed<uint16_t>({1, 2, 3, 4, 5, 6});
    model.buffers[1].data.assign(sparse.begin(), sparse.end());
    model.bufferViews.emplace_back();
    model.bufferViews[1].buffer = 1;
    model.bufferViews[1].byteLength = sparse.size();
    auto& s = model.accessors[0].sparse;
    s.isSparse = true, s.count = 2, s.indices.bufferView = 1, s.indices.byteOffset = 0, s.indices.componentType = 5123, s.values.bufferView = 1,
    s.values.byteOffset = 4;

    const std::vector<float> all = read_floats(model, 0);
    EXPECT_FLOAT_EQ(all[3 * 3 + 1], 2 / 65535.0f);
    EXPECT_FLOAT_EQ(all[3 * 40 + 2], 6 / 65535.0f);
    for (const std::vector<uint32_t>& which : {std::vector<uint32_t>{0}, {3}, {2, 3, 4, 59}, {39, 41}, {3, 40}}) {
        const std::vector<float> some = read_floats(model, 0, which);
        ASSERT_EQ(some.size(), 3 * which.size());
        for (size_t i = 0; i < which.size(); ++i)
            for (size_t k = 0; k < 3; ++k) EXPECT_EQ(some[3 * i + k], all[3 * which[i] + k]) << which[i];
    }
}

TEST(Accessors, IntegersAreExact) {
    const Model model = model_of({"", 5125, TINYGLTF_TYPE_SCALAR, false, 3, 0, packed<uint32_t>({0, 16777217, 4294967295u}), {}});
    EXPECT_THAT(read_integers(model, 0), ElementsAre(0u, 16777217u, 4294967295u));
}

TEST(Accessors, NonFiniteFloatsAreFound) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
        Reporter report("x", false);
        check_accessor_data(model_of({"", 5126, TINYGLTF_TYPE_VEC2, false, 2, 0, packed<float>({0, 1, 2, bad}), {}}), report);
        EXPECT_THAT(report.diagnostics().text(), HasSubstr("/accessors/0: error: element 1 is "));
    }
}

/// A few kilobytes of JSON that read one large buffer thousands of times are refused before the work is done.
TEST(Accessors, ManyReadersOfOneBufferAreRefused) {
    Model model = model_of({"", 5121, TINYGLTF_TYPE_SCALAR, false, 1 << 20, 0, std::string(1 << 20, '\0'), {}});
    model.accessors.resize(16, model.accessors[0]);
    Reporter few("x", false);
    check_accessor_data(model, few);
    EXPECT_FALSE(few.failed());
    model.accessors.resize(10000, model.accessors[0]);
    Reporter many("x", false);
    check_accessor_data(model, many);
    EXPECT_THAT(many.diagnostics().text(), HasSubstr("far more numbers than the buffers"));
}

}  // namespace
}  // namespace alidade::gltf
