// SPDX-License-Identifier: Apache-2.0
#include "tests/core/folder_test.h"
#include "tests/importers/gltf_text.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;

class ImportScene : public test::FolderTest {
  protected:
    static std::string outcome(const std::string& path) {
        const auto result = import_scene(path);
        return result ? "loaded" : result.error().text();
    }
};

TEST_F(ImportScene, SaysWhyAFileCannotBeOne) {
    EXPECT_THAT(outcome((folder_ / "none.gltf").string()), HasSubstr("none.gltf: error: there is no such file"));
    EXPECT_THAT(outcome(folder_.string()), HasSubstr("error: is a directory, not a scene"));
    EXPECT_THAT(outcome("/dev/null"), HasSubstr("error: is a device or a pipe, not a file"));
    EXPECT_THAT(outcome(put("empty.gltf", "")), HasSubstr("error: the file is empty"));
    EXPECT_EQ(outcome(put("empty.pov", "")), "loaded") << "as in POV-Ray: nothing is seen";
    EXPECT_THAT(outcome(put("a.docx", "PK\x03\x04")), HasSubstr("error: the format is not recognised\nhint: known formats: glTF 2.0"));
}

TEST_F(ImportScene, ContentBeatsTheEnding) {
    EXPECT_EQ(outcome(put("a.png", gltf_test::glb(gltf_test::with_asset("")))), "loaded");
    EXPECT_EQ(outcome(put("a", gltf_test::with_asset(""))), "loaded");
    EXPECT_THAT(outcome(put("b.GLB", "nonsense")), HasSubstr("b.GLB:1:2: error: JSON")) << "the ending decides where the content does not";
}

TEST_F(ImportScene, BuffersAndImagesBesideTheSceneAreFound) {
    put("a b.bin", std::string(12, '\0'));
    put("t.png", "not read here");
    const std::string path = put("s.gltf", gltf_test::with_asset(R"("buffers":[{"byteLength":12,"uri":"a%20b.bin"}],"images":[{"uri":"t.png"}])"));
    const auto result = import_scene(path);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->scene.images.at(0).path, (folder_ / "t.png").string());
    EXPECT_EQ(result->diagnostics.warnings(), 0u) << result->diagnostics.text();

    EXPECT_THAT(outcome(put("t.gltf", gltf_test::with_asset(R"("buffers":[{"byteLength":12,"uri":"gone.bin"}])"))),
                HasSubstr("/buffers/0/uri: error: cannot read"));
    EXPECT_THAT(outcome(put("u.gltf", gltf_test::with_asset(R"("buffers":[{"byteLength":13,"uri":"a%20b.bin"}])"))),
                HasSubstr("/buffers/0/byteLength: error: claims 13 bytes, but there are only 12"));
    EXPECT_THAT(outcome(put("v.gltf", gltf_test::with_asset(R"("buffers":[{"byteLength":12,"uri":"."}])"))),
                HasSubstr("/buffers/0/uri: error: cannot read"))
        << "a directory";
    EXPECT_THAT(outcome(put("w.gltf", gltf_test::with_asset(R"("images":[{"uri":"../t.png"}])"))),
                HasSubstr("/images/0/uri: error: URI \"../t.png\" is refused: \"..\" is not allowed"));
}

TEST_F(ImportScene, AnImageThatIsNotThereIsAWarning) {
    const auto result = import_scene(put("s.gltf", gltf_test::with_asset(R"("images":[{"uri":"gone.png"}],"textures":[{"source":0}],
        "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])")));
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_THAT(result->diagnostics.text(), HasSubstr("/images/0/uri: warning: there is no file"));
    EXPECT_THAT(result->diagnostics.text(), HasSubstr("/textures/0: warning: the texture has no image that can be read: it is left out"));
    EXPECT_EQ(result->scene.signals.size(), 1u) << "nobody is to look for it again";
}

TEST_F(ImportScene, FilesBeyondTheLimitAreNotRead) {
    ImportOptions options;
    options.max_file_bytes = 20;
    const auto result = import_scene(put("s.gltf", gltf_test::with_asset("")), options);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().text(), HasSubstr("cannot read the file"));
}

/// Every importer of the table meets nonsense: it must say so, and not fall over.
TEST_F(ImportScene, EveryImporterRefusesNonsense) {
    for (const ImporterEntry& importer : importers()) {
        EXPECT_STRNE(importer.doc, "") << importer.name;
        const std::string ending = std::string(importer.extensions).substr(0, std::string(importer.extensions).find(' '));
        for (const std::string& content : {std::string(1000, '\0'), std::string(1000, '\xff'), std::string("\x01\x02\x03")}) {
            const auto result = importer.import(put("nonsense" + ending, content), {});
            EXPECT_TRUE(!result && result.error().has_errors()) << importer.name;
        }
    }
}

}  // namespace
}  // namespace alidade
