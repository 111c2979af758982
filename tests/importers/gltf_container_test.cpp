// SPDX-License-Identifier: Apache-2.0
#include "tests/importers/gltf_text.h"

#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

using testing::HasSubstr;

const std::string kEmpty = R"({"asset":{"version":"2.0"}})";

std::string outcome(const std::string& file) {
    const auto result = import_text(file);
    return (result ? "loaded\n" + result->diagnostics.text() : "refused\n" + result.error().text());
}

std::string with_u32(std::string file, size_t at, uint32_t value) {
    for (int i = 0; i < 4; ++i) file[at + size_t(i)] = char(value >> (8 * i) & 255);
    return file;
}

TEST(Glb, ReadsItsChunks) {
    const std::string json =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":3}],"bufferViews":[{"buffer":0,"byteLength":3}],"images":[{"bufferView":0,"mimeType":"image/png"}]})";
    const auto result = import_text(glb(json, "abc"));
    ASSERT_TRUE(result) << result.error().text();
    ASSERT_EQ(result->scene.images.size(), 1u);
    const auto& bytes = result->scene.images[0].bytes;
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), "abc");
}

TEST(Glb, RefusesWhatDoesNotAddUp) {
    const std::string good = glb(kEmpty, "abcd");
    EXPECT_THAT(outcome(good), HasSubstr("loaded"));
    EXPECT_THAT(outcome(good.substr(0, 8)), HasSubstr("ends inside its header"));
    EXPECT_THAT(outcome(with_u32(good, 4, 1)), HasSubstr("container version 1 is not supported"));
    EXPECT_THAT(outcome(with_u32(good, 8, 1000)), HasSubstr("the header claims 1000 bytes"));
    EXPECT_THAT(outcome(with_u32(good, 8, 0)), HasSubstr("the header claims 0 bytes"));
    EXPECT_THAT(outcome(with_u32(good, 8, uint32_t(good.size() - 1))), HasSubstr("chunk 1 claims 4 bytes, but only 3 are left"));
    EXPECT_THAT(outcome(with_u32(with_u32(good, 8, uint32_t(good.size() - 1)), good.size() - 12, 3)),
                HasSubstr("error: GLB: chunk 1 has a length that is not a multiple of 4"));
    EXPECT_THAT(outcome(with_u32(good, 12, 0xfffffffc)), HasSubstr("chunk 0 claims 4294967292 bytes"));
    EXPECT_THAT(outcome(with_u32(good, 16, 0x004E4942)), HasSubstr("the first chunk is not JSON"));
    EXPECT_THAT(outcome(with_u32(good, good.size() - 8, 0x4E4F534A)), HasSubstr("is JSON, which is only allowed as chunk 0"));
    EXPECT_THAT(outcome(with_u32(good, good.size() - 12, 8)), HasSubstr("claims 8 bytes, but only 4 are left"));
}

TEST(Glb, ToleratesWhatIsUnambiguous) {
    const std::string good = glb(kEmpty, "abcd");
    EXPECT_THAT(outcome(good + "more"), HasSubstr("loaded\ntest.gltf: warning: GLB: 4 bytes after the end are ignored"));
    EXPECT_THAT(outcome(with_u32(good, good.size() - 8, 0x12345678)), HasSubstr("loaded")) << "unknown chunks are skipped";
    // A JSON chunk of odd length, as some writers leave it, before the binary chunk.
    std::string odd = good.substr(0, 20) + kEmpty + good.substr(good.size() - 12);
    ASSERT_EQ(kEmpty.size(), 27u);
    odd = with_u32(with_u32(odd, 8, uint32_t(odd.size())), 12, 27);
    EXPECT_THAT(outcome(odd), HasSubstr("loaded\ntest.gltf: warning: GLB: chunk 0 has a length that is not a multiple of 4 (27)"));
}

/// A binary chunk that should be there, in a GLB and in a text file.
TEST(Glb, NeedsTheChunkThatItsBufferNames) {
    EXPECT_THAT(outcome(glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":3}]})")),
                HasSubstr("/buffers/0: error: the buffer has no uri, and the file has no binary chunk"));
    EXPECT_THAT(outcome(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":3}]})"), HasSubstr("loaded"));
}

TEST(JsonText, ErrorsHaveLineAndColumn) {
    EXPECT_THAT(outcome("{\n  \"asset\": {\n    \"version\": }\n}"),
                HasSubstr("test.gltf:3:16: error: JSON: syntax error while parsing value - unexpected '}'"));
    EXPECT_THAT(outcome("{\"a\": 1e999}"), HasSubstr("error: JSON: number overflow"));
    EXPECT_THAT(outcome("{\"a\": \"\xff\"}"),
                HasSubstr("test.gltf:1:8: error: JSON: syntax error while parsing value - invalid string: ill-formed UTF-8"));
    EXPECT_THAT(outcome("[]"), HasSubstr("a glTF file is a JSON object, this is an array"));
    EXPECT_THAT(outcome(""), HasSubstr("refused"));
}

TEST(JsonText, DepthIsLimited) {
    const std::string deep(70, '['), end(70, ']');
    EXPECT_THAT(outcome(R"({"asset":{"version":"2.0"},"extras":)" + deep + end + "}"), HasSubstr("nested deeper than 64 levels"));
    EXPECT_THAT(outcome(std::string(1 << 20, '[')), HasSubstr("nested deeper than 64 levels"));
    EXPECT_THAT(outcome(R"({"asset":{"version":"2.0"},"extras":")" + deep + "\\\"" + deep + "\"}"), HasSubstr("loaded"))
        << "brackets inside a string are text";
}

TEST(JsonText, AByteOrderMarkIsSkipped) { EXPECT_THAT(outcome("\xEF\xBB\xBF" + kEmpty), HasSubstr("loaded")); }

}  // namespace
}  // namespace alidade::gltf_test
