// SPDX-License-Identifier: Apache-2.0
/// One row a rule of glTF 2.0: a fragment that breaks it, and the message that must come, at its JSON pointer.
#include "tests/importers/gltf_text.h"

#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

struct Rule {
    const char* members;    ///< of the root, beside "asset"
    const char* expected;   ///< "pointer: severity: message" as it begins
};

void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.members; }

std::string said_of(const std::string& members) {
    const auto result = import_text(with_asset(members));
    return result ? result->diagnostics.text() : result.error().text();
}

class Rules : public testing::TestWithParam<Rule> {};

TEST_P(Rules, IsReportedAtItsPlace) {
    EXPECT_THAT(said_of(GetParam().members), testing::HasSubstr(std::string("test.gltf:") + GetParam().expected));
}

// ---- types, required properties, ranges: each kind of field once, and places where files go wrong ----

constexpr Rule kSchema[] = {
    {R"("nodes":{})", "/nodes: error: must be an array, not an object"},
    {R"("nodes":[7])", "/nodes/0: error: must be an object, not a number"},
    {R"("materials":[null])", "/materials/0: error: must be an object, not null"},
    {R"("nodes":[{"name":7}])", "/nodes/0/name: error: must be a string, not a number"},
    {R"("materials":[{"doubleSided":1}])", "/materials/0/doubleSided: error: must be a boolean, not a number"},
    {R"("nodes":[{"mesh":"0"}])", "/nodes/0/mesh: error: must be an index, not a string"},
    {R"("nodes":[{"mesh":0.5}],"meshes":[])", "/nodes/0/mesh: error: must be an index, not a number with a fraction"},
    {R"("extensionsUsed":[1])", "/extensionsUsed/0: error: must be a string, not a number"},
    {R"("extensions":[])", "/extensions: error: must be an object, not an array"},
    {R"("nodes":[{"extensions":7}])", "/nodes/0/extensions: error: must be an object, not a number"},
    {R"("scenes":[{"extensions":7}])", "/scenes/0/extensions: error: must be an object, not a number"},
    {R"("nodes":[{"matrix":[1,2,3]}])", "/nodes/0/matrix: error: has 3 elements, but needs 16"},
    {R"("nodes":[{"translation":[1,2,"3"]}])", "/nodes/0/translation/2: error: must be a number, not a string"},
    {R"("meshes":[{}])", "/meshes/0: error: property \"primitives\" is missing"},
    {R"("meshes":[{"primitives":[]}])", "/meshes/0/primitives: error: has 0 elements, but needs at least 1"},
    {R"("meshes":[{"primitives":[{}]}])", "/meshes/0/primitives/0: error: property \"attributes\" is missing"},
    {R"("meshes":[{"primitives":[{"attributes":[]}]}])", "/meshes/0/primitives/0/attributes: error: must be an object, not an array"},
    {R"("meshes":[{"primitives":[{"attributes":{"A/B":0}}]}])",
     "/meshes/0/primitives/0/attributes/A~1B: error: index 0 is out of range: /accessors has 0 elements"},
    {R"("meshes":[{"primitives":[{"attributes":{},"mode":7}]}])", "/meshes/0/primitives/0/mode: error: 7 is not one of 0, 1, 2, 3, 4, 5, 6"},
    {R"("accessors":[{"componentType":5124,"count":1,"type":"SCALAR"}])", "/accessors/0/componentType: error: 5124 is not one of"},
    {R"("accessors":[{"componentType":5126,"count":1,"type":"VEC5"}])", "/accessors/0/type: error: \"VEC5\" is not one of SCALAR, VEC2"},
    {R"("accessors":[{"componentType":5126,"count":0,"type":"SCALAR"}])", "/accessors/0/count: error: 0 must be at least 1"},
    {R"("accessors":[{"componentType":5126,"count":1e300,"type":"SCALAR"}])", "/accessors/0/count: error: must be an integer"},
    {R"("accessors":[{"componentType":5126,"count":9007199254740994,"type":"SCALAR"}])", "/accessors/0/count: error: 9007199254740994 must be at least 1 and at most 2^53"},
    {R"("accessors":[{"componentType":5126,"count":18446744073709551615,"type":"SCALAR"}])", "/accessors/0/count: error: 18446744073709551615 must be at least 1 and at most 2^53"},
    {R"("accessors":[{"componentType":5126,"count":1e30,"type":"SCALAR"}])", "/accessors/0/count: error: must be an integer, not 1e+30, which is beyond 2^53"},
    {R"("accessors":[{"componentType":5126,"count":1,"type":"VEC2","max":[1]}])", "/accessors/0/max: error: has 1 elements, but VEC2 has 2"},
    {R"("bufferViews":[{"byteLength":1}])", "/bufferViews/0: error: property \"buffer\" is missing"},
    {R"("buffers":[{"byteLength":1}],"bufferViews":[{"buffer":0,"byteLength":1,"byteStride":256}])",
     "/bufferViews/0/byteStride: error: 256 must be at least 4 and at most 252"},
    {R"("buffers":[{"byteLength":-1}])", "/buffers/0/byteLength: error: -1 must be at least 1"},
    {R"("cameras":[{"type":"perspective","perspective":{"yfov":0,"znear":1}}])", "/cameras/0/perspective/yfov: error: 0.0 must be greater than 0"},
    {R"("cameras":[{"type":"orthographic","orthographic":{"xmag":1,"zfar":1,"znear":0}}])",
     "/cameras/0/orthographic: error: property \"ymag\" is missing"},
    {R"("cameras":[{"type":"fisheye"}])", "/cameras/0/type: error: \"fisheye\" is not one of perspective, orthographic"},
    {R"("samplers":[{"wrapS":1}])", "/samplers/0/wrapS: error: 1 is not one of 33071, 33648, 10497"},
    {R"("textures":[{"source":0}])", "/textures/0/source: error: index 0 is out of range: /images has 0 elements"},
    {R"("materials":[{"normalTexture":{}}])", "/materials/0/normalTexture: error: property \"index\" is missing"},
    {R"("materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,1,1]}}])",
     "/materials/0/pbrMetallicRoughness/baseColorFactor: error: has 3 elements, but needs 4"},
    {R"("materials":[{"pbrMetallicRoughness":{"metallicFactor":2}}])",
     "/materials/0/pbrMetallicRoughness/metallicFactor: warning: 2.0 should be at least 0 and at most 1: 1 is used"},
    {R"("materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,1,-3,1]}}])",
     "/materials/0/pbrMetallicRoughness/baseColorFactor/2: warning: -3.0 should be at least 0 and at most 1: 0 is used"},
    {R"("materials":[{"alphaMode":"Blend"}])", "/materials/0/alphaMode: error: \"Blend\" is not one of OPAQUE, MASK, BLEND"},
    {R"("skins":[{"joints":[]}])", "/skins/0/joints: error: has 0 elements, but needs at least 1"},
    {R"("scene":3,"scenes":[{}])", "/scene: error: index 3 is out of range: /scenes has 1 elements"},
    {R"("animations":[{"channels":[],"samplers":[{"input":0}]}])", "/animations/0/samplers/0: error: property \"output\" is missing"},
    {R"("nodes":[{"extensions":{"KHR_lights_punctual":{}}}])", "/nodes/0/extensions/KHR_lights_punctual: error: property \"light\" is missing"},
    {R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":0}}}])",
     "/nodes/0/extensions/KHR_lights_punctual/light: error: index 0 is out of range: /extensions/KHR_lights_punctual/lights has 0 elements"},
};
INSTANTIATE_TEST_SUITE_P(Schema, Rules, testing::ValuesIn(kSchema));

// ---- extensions ----

constexpr Rule kExtensions[] = {
    {R"("extensionsUsed":["ACME_x"],"extensionsRequired":["ACME_x"])",
     "/extensionsRequired/0: error: the file requires the extension ACME_x, which is unknown"},
    {R"("extensionsRequired":["EXT_texture_avif"])",
     "/extensionsRequired/0: error: the file requires the extension EXT_texture_avif, which is not supported\nhint: convert the textures"},
    {R"("extensionsRequired":["MSFT_texture_dds"])", "/extensionsRequired/0: error: the file requires the extension MSFT_texture_dds"},
    {R"("extensionsRequired":["KHR_texture_basisu"])", "/extensionsRequired/0: error: the file requires the extension KHR_texture_basisu"},
    {R"("extensionsRequired":["KHR_materials_unlit"])",
     "/extensionsRequired/0: warning: extension KHR_materials_unlit is required, but not listed in extensionsUsed"},
    {R"("extensionsRequired":["KHR_materials_sheen"])",
     "/extensionsRequired/0: warning: extension KHR_materials_sheen is not supported and is ignored: cloth has no sheen"},
    {R"("materials":[{"extensions":{"ACME_x":{}}}])", "/materials/0/extensions/ACME_x: warning: unknown extension ACME_x is ignored"},
    {R"("nodes":[{"extensions":{"EXT_mesh_gpu_instancing":{}}}])",
     "/nodes/0/extensions/EXT_mesh_gpu_instancing: error: property \"attributes\" is missing"},
    {R"("materials":[{"extensions":{"KHR_materials_ior":{"ior":0.5}}}])",
     "/materials/0/extensions/KHR_materials_ior/ior: warning: 0.5 should be 0 or at least 1"},
    {R"("meshes":[{"primitives":[{"attributes":{},"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":-1}}}}]}])",
     "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/POSITION: error: -1 must be at least 0"},
    {R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"area"}]}})",
     "/extensions/KHR_lights_punctual/lights/0/type: warning: unknown type of light \"area\": it is left out"},
    {R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","spot":{"innerConeAngle":0.5,"outerConeAngle":0.4}}]}})",
     "/extensions/KHR_lights_punctual/lights/0/spot: warning: the inner angle 0.5 is larger than the outer angle 0.4"},
};
INSTANTIATE_TEST_SUITE_P(Extensions, Rules, testing::ValuesIn(kExtensions));

// ---- buffers, views, accessors ----

#define FOUR_BYTES R"("buffers":[{"byteLength":4,"uri":"data:;base64,AAECAw=="}],)"

constexpr Rule kRanges[] = {
    {R"("buffers":[{"byteLength":4,"uri":"data:;base64,AAEC"}])", "/buffers/0/byteLength: error: claims 4 bytes, but there are only 3"},
    {R"("buffers":[{"byteLength":4,"uri":"data:;base64,????"}])", "/buffers/0/uri: error: byte 0x3f is not a base64 digit"},
    {R"("buffers":[{"byteLength":4,"uri":"a.bin"}])", "/buffers/0/uri: error: URI \"a.bin\" is refused: files beside the scene may not be read here"},
    {R"("buffers":[{"byteLength":4}],"bufferViews":[{"buffer":0,"byteLength":4}])", "/buffers/0: error: the buffer has no uri"},
    {FOUR_BYTES R"("bufferViews":[{"buffer":0,"byteLength":5}])", "/bufferViews/0: error: ends at byte 5, but its buffer has 4 bytes"},
    {FOUR_BYTES R"("bufferViews":[{"buffer":0,"byteOffset":9007199254740992,"byteLength":9007199254740992}])",
     "/bufferViews/0: error: ends at byte 18014398509481984"},
    {FOUR_BYTES R"("bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR"}])",
     "/accessors/0: error: 2 elements of 4 bytes at offset 0 do not fit into their buffer view of 4 bytes"},
    {FOUR_BYTES
     R"("bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"bufferView":0,"componentType":5125,"count":9007199254740992,"type":"MAT4"}])",
     "/accessors/0: error: 9007199254740992 elements of 64 bytes at offset 0 do not fit"},
    {FOUR_BYTES
     R"("bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"bufferView":0,"byteOffset":9007199254740992,"componentType":5121,"count":1,"type":"SCALAR"}])",
     "/accessors/0: error: 1 elements of 1 bytes at offset 9007199254740992 do not fit"},
    {FOUR_BYTES
     R"("bufferViews":[{"buffer":0,"byteLength":4,"byteStride":4}],"accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"VEC2"}])",
     "/accessors/0: error: the elements have 8 bytes, but the byteStride of their view is 4"},
    {FOUR_BYTES
     R"("bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"bufferView":0,"byteOffset":1,"componentType":5123,"count":1,"type":"SCALAR"}])",
     "/accessors/0: warning: the elements are not aligned to 2 bytes"},
    {R"("accessors":[{"componentType":5126,"count":2147483648,"type":"MAT4"}])",
     "/accessors/0: error: accessors without a buffer view claim more than 256 MiB of zeros"},
    {FOUR_BYTES R"("bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"componentType":5121,"count":2,"type":"SCALAR","sparse":
        {"count":3,"indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}])",
     "/accessors/0/sparse/count: error: 3 sparse values are more than the 2 elements of the accessor"},
    {FOUR_BYTES R"("bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"componentType":5121,"count":9,"type":"SCALAR","sparse":
        {"count":5,"indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}])",
     "/accessors/0/sparse/indices: error: 5 elements of 1 bytes at offset 0 do not fit"},
    {FOUR_BYTES R"("bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"componentType":5121,"count":3,"type":"SCALAR","sparse":
        {"count":2,"indices":{"bufferView":0,"byteOffset":2,"componentType":5121},"values":{"bufferView":0}}}])",
     "/accessors/0: error: sparse index 1 is 3, but the accessor has 3 elements"},
    {R"("buffers":[{"byteLength":4,"uri":"data:;base64,AQECAw=="}],"bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"componentType":5121,"count":4,"type":"SCALAR",
        "sparse":{"count":2,"indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}])",
     "/accessors/0: error: sparse index 1 is 1, after 1: they must increase"},
    {R"("images":[{}])", "/images/0: error: the image has neither a uri nor a bufferView"},
    {R"("images":[{"uri":"data:;base64,?"}])", "/images/0/uri: error: byte 0x3f"},
};
INSTANTIATE_TEST_SUITE_P(Ranges, Rules, testing::ValuesIn(kRanges));

// ---- the tree of nodes ----

constexpr Rule kTree[] = {
    {R"("nodes":[{"children":[1]},{"children":[0]}])", "/nodes/0: error: the node is its own ancestor"},
    {R"("nodes":[{"children":[0]}])", "/nodes/0: error: the node is its own ancestor"},
    {R"("nodes":[{},{"children":[3]},{"children":[1]},{"children":[2]}])", "/nodes/1: error: the node is its own ancestor"},
    {R"("nodes":[{"children":[2]},{"children":[2]},{}])", "/nodes/1/children/0: error: node 2 is already a child of node 0"},
    {R"("nodes":[{"children":[1,1]},{}])", "/nodes/0/children/1: error: 1 is in the list twice"},
    {R"("nodes":[{"children":[7]}])", "/nodes/0/children/0: error: index 7 is out of range: /nodes has 1 elements"},
    {R"("nodes":[{"children":[1]},{}],"scenes":[{"nodes":[0,1]}])", "/scenes/0/nodes/1: error: node 1 is not a root: it is a child of node 0"},
    {R"("nodes":[{"skin":0},{}],"skins":[{"joints":[1]}])", "/nodes/0: error: property \"skin\" needs a mesh, and the node has none"},
    {R"("nodes":[{"weights":[1]}])", "/nodes/0: error: property \"weights\" needs a mesh, and the node has none"},
    {R"("nodes":[{"rotation":[0,0,0,2]}])", "/nodes/0/rotation: warning: the quaternion has length 2: it is normalised"},
    {R"("nodes":[{"rotation":[0,0,0,0]}])", "/nodes/0/rotation: warning: the quaternion has no direction: no rotation is used"},
    {R"("nodes":[{"matrix":[1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])", "/nodes/0/matrix: warning: the last row is not 0, 0, 0, 1: it is ignored"},
    {R"("nodes":[{"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1],"scale":[1,1,1]}])",
     "/nodes/0: warning: the node has a matrix: its other transforms are ignored"},
    {R"("nodes":[{}],"scenes":[{},{}])", "/scenes: note: the file does not say which of its 2 scenes to show: the first is used"},
    {R"("cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":0,"zfar":1,"znear":0}}])",
     "/cameras/0/orthographic: error: xmag and ymag must not be 0"},
    {R"("cameras":[{"type":"perspective","perspective":{"yfov":4,"znear":1}}])", "/cameras/0/perspective: warning: a yfov of 4 is not less than pi"},
};
INSTANTIATE_TEST_SUITE_P(Tree, Rules, testing::ValuesIn(kTree));

// ---- versions ----

std::string version_outcome(const std::string& asset, const std::string& rest = "") {
    const auto result = import_text("{" + asset + rest + "}");
    return result ? "loaded" : result.error().text();
}

TEST(Version, OnlyTwoIsRead) {
    using testing::HasSubstr;
    EXPECT_EQ(version_outcome(R"("asset":{"version":"2.0"})"), "loaded");
    EXPECT_EQ(version_outcome(R"("asset":{"version":"2.1","minVersion":"2.0"})"), "loaded");
    EXPECT_THAT(version_outcome(R"("asset":{"version":"2.1","minVersion":"2.1"})"), HasSubstr("/asset/minVersion: error: the file needs glTF 2.1"));
    EXPECT_THAT(version_outcome(R"("asset":{"version":"1.0"})"),
                HasSubstr("/asset/version: error: glTF version \"1.0\" is not supported, only 2.x is\nhint: convert the file to glTF 2.0"));
    EXPECT_THAT(version_outcome(R"("asset":{"version":2.0})"), HasSubstr("/asset: error: property \"version\" is missing or not a string"));
    EXPECT_THAT(version_outcome(R"("asset":[])"), HasSubstr("/asset: error: must be an object, not an array"));
    EXPECT_THAT(version_outcome(R"("meshes":{})"), HasSubstr("error: property \"asset\" is missing\nhint: convert the file to glTF 2.0"));
    EXPECT_THAT(version_outcome(R"("a":{})"), HasSubstr("hint: is this a glTF file?"));
}

/// What is not understood is a warning, and an error for those who ask for strictness.
TEST(Strict, WarningsAboutTheUnknownBecomeErrors) {
    const std::string file = with_asset(R"("materials":[{"extensions":{"KHR_materials_sheen":{}}}])");
    EXPECT_TRUE(import_text(file));
    ImportOptions strict;
    strict.strict = true;
    EXPECT_FALSE(import_text(file, strict));
    EXPECT_TRUE(import_text(with_asset(R"("extensionsUsed":["KHR_xmp_json_ld"],"extensions":{"KHR_xmp_json_ld":{"packets":[]}})"), strict))
        << "metadata are no loss";
}

/// JSON has one kind of number: 1.0 is an integer, too.
TEST(Schema, WholeNumbersAreIntegers) {
    const auto result = import_text(with_asset(R"("nodes":[{"children":[1.0]},{}],"scene":0.0,"scenes":[{"nodes":[0e0]}])"));
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->scene.roots, std::vector<NodeId>{NodeId{0}});
}

}  // namespace
}  // namespace alidade::gltf_test
