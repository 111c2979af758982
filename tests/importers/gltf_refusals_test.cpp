// SPDX-License-Identifier: Apache-2.0
/// Broken files of the shared collection: each is refused for what is wrong with it, and at its place.
#include "importers/importer.h"
#include "tests/importers/manifest.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

const std::string kData = SHARED_DATA;

/// What must be said of a file: the JSON pointer, or its end, and how the sentence begins. Written from what is wrong in the file, as the collection's
/// validator codes name it, not from what the importer said.
struct Refusal {
    const char *file, *cause;
};
constexpr Refusal kTable[] = {
    // ---- glTF 1.0 ----
    {"assimp/test/models/glTF/BoxTextured-glTF-MaterialsCommon/BoxTextured.gltf",
     "/asset/version: error: glTF version \"1.0\" is not supported"},
    {"assimp/test/models/glTF/CesiumMilkTruck/CesiumMilkTruck.gltf",
     "/asset/version: error: glTF version 1 is not supported"},
    {"gltf-pipeline/specs/data/1.0/box-textured-separate/box-textured-separate.gltf",
     "/asset/version: error: glTF version 1 is not supported"},
    {"gltf-pipeline/specs/data/1.0/box/box.gltf",
     "/asset/version: error: glTF version \"1.0\" is not supported"},
    // ---- the container ----
    {"glTF-Validator/test/base/data/glb/chunk_too_big.glb",
     "error: GLB: the header claims 13 bytes in all, too few for a chunk"},
    {"glTF-Validator/test/base/data/glb/only_header.glb",
     "error: GLB: the header claims 12 bytes in all, too few for a chunk"},
    {"glTF-Validator/test/base/data/glb/zero_length.glb",
     "error: GLB: the header claims 0 bytes in all, too few for a chunk"},
    {"glTF-Validator/test/base/data/glb/invalid_magic.glb",
     "error: neither GLB, whose first bytes would be \"glTF\", nor JSON"},
    {"glTF-Validator/test/base/data/glb/misplaced_bin_chunk.glb",
     "error: GLB: chunk 2 is BIN, which is only allowed as chunk 1"},
    {"glTF-Validator/test/base/data/glb/only_bin_chunk.glb",
     "error: GLB: the first chunk is not JSON"},
    {"glTF-Validator/test/base/data/glb/two_bin_chunks.glb",
     "error: GLB: the first chunk is not JSON"},
    {"glTF-Validator/test/base/data/glb/unaligned_chunk.glb",
     "error: GLB: chunk 0 has a length that is not a multiple of 4 (27)"},
    {"glTF-Validator/test/base/data/buffer/no_bin_chunk.glb",
     "/buffers/0: error: the buffer has no uri, and the file has no binary chunk"},
    // ---- types ----
    {"assimp/test/models/glTF2/SchemaFailures/sceneWrongType.gltf",
     "/scene: error: must be an index, not a string"},
    {"assimp/test/models/glTF2/wrongTypes/badArray.gltf",
     "/meshes/0/primitives: error: must be an array, not an object"},
    {"assimp/test/models/glTF2/wrongTypes/badString.gltf",
     "/scenes/0/name: error: must be a string, not a number"},
    {"glTF-Validator/test/base/data/buffer/invalid_object.gltf",
     "/buffers/0: error: must be an object, not an array"},
    {"glTF-Validator/test/base/data/image/invalid_object.gltf",
     "/images/0: error: must be an object, not an array"},
    {"glTF-Validator/test/base/data/root/invalid_array_elements.gltf",
     "/samplers/0: error: must be an object, not a string"},
    {"glTF-Validator/test/base/data/root/invalid_collection_type.gltf",
     "/samplers: error: must be an array, not an object"},
    // ---- what must be there ----
    {"glTF-Validator/test/base/data/accessor/empty_object.gltf",
     "/accessors/0: error: property \"componentType\" is missing"},
    {"glTF-Validator/test/base/data/asset/empty_array.gltf",
     "/asset: error: property \"version\" is missing"},
    {"glTF-Validator/test/base/data/buffer/empty_object.gltf",
     "/buffers/0: error: property \"byteLength\" is missing"},
    {"glTF-Validator/test/base/data/camera/empty_objects.gltf",
     "/cameras/0: error: property \"type\" is missing"},
    {"glTF-Validator/test/base/data/glb/empty_json_object.glb",
     "error: property \"asset\" is missing"},
    {"glTF-Validator/test/base/data/mesh/empty_object.gltf",
     "/meshes/0: error: property \"primitives\" is missing"},
    {"glTF-Validator/test/base/data/root/empty_object.gltf",
     "error: property \"asset\" is missing"},
    {"glTF-Validator/test/base/data/skin/empty_object.gltf",
     "/skins/0: error: property \"joints\" is missing"},
    {"glTF-Validator/test/base/data/node/skin_with_no_mesh.gltf",
     "/nodes/0: error: property \"skin\" needs a mesh"},
    {"glTF-Validator/test/base/data/node/weights_with_no_mesh.gltf",
     "/nodes/0: error: property \"weights\" needs a mesh"},
    {"glTF-Validator/test/base/data/root/undefined_used_extensions.gltf",
     "/extensionsRequired/0: error: the file requires the extension KHR_extension, which is unknown"},
    {"glTF-Validator/test/ext/KHR_lights_punctual/data/node/empty_object.gltf",
     "/nodes/0/extensions/KHR_lights_punctual: error: property \"light\" is missing"},
    {"glTF-Validator/test/ext/KHR_lights_punctual/data/node/unresolved_light_empty_root_ext.gltf",
     "/extensions/KHR_lights_punctual: error: property \"lights\" is missing"},
    {"glTF-Validator/test/ext/KHR_materials_variants/data/variant/empty_object.gltf",
     "/extensions/KHR_materials_variants: error: property \"variants\" is missing"},
    // ---- references to nothing ----
    {"glTF-Validator/test/base/data/accessor/unresolved_bufferviews.gltf",
     "/accessors/0/bufferView: error: index 0 is out of range: /bufferViews has 0 elements"},
    {"glTF-Validator/test/base/data/animation/unresolved_sampler_input.gltf",
     "/animations/0/samplers/0/input: error: index 1 is out of range: /accessors has 1 elements"},
    {"glTF-Validator/test/base/data/image/unresolved_buffer_view.gltf",
     "/images/0/bufferView: error: index 0 is out of range: /bufferViews has 0 elements"},
    {"glTF-Validator/test/base/data/material/unresolved_normal.gltf",
     "/materials/0/normalTexture/index: error: index 0 is out of range: /textures has 0 elements"},
    {"glTF-Validator/test/base/data/node/unresolved_child_node.gltf",
     "/nodes/0/children/0: error: index 1 is out of range: /nodes has 1 elements"},
    {"glTF-Validator/test/base/data/scene/unresolved_default_scene.gltf",
     "/scene: error: index 0 is out of range: /scenes has 0 elements"},
    {"glTF-Validator/test/base/data/texture/unresolved_sampler.gltf",
     "/textures/0/sampler: error: index 0 is out of range: /samplers has 0 elements"},
    {"glTF-Validator/test/base/data/texture/unresolved_source.gltf",
     "/textures/0/source: error: index 0 is out of range: /images has 0 elements"},
    {"glTF-Validator/test/ext/KHR_lights_punctual/data/node/unresolved_light_empty_root_array.gltf",
     "/nodes/0/extensions/KHR_lights_punctual/light: error: index 0 is out of range: /extensions/KHR_lights_punctual/lights has 0 elements"},
    {"glTF-Validator/test/ext/KHR_materials_variants/data/primitive/dependency.gltf",
     "/mappings/0/variants/0: error: index 0 is out of range: /extensions/KHR_materials_variants/variants has 0 elements"},
    {"tinygltf/models/BoundsChecking/invalid-buffer-index.gltf",
     "/bufferViews/1/buffer: error: index 1 is out of range: /buffers has 1 elements"},
    {"tinygltf/models/BoundsChecking/invalid-primitive-indices.gltf",
     "/meshes/0/primitives/0/indices: error: index 1 is out of range: /accessors has 1 elements"},
    // ---- bytes, numbers and the tree ----
    {"assimp/test/models/glTF2/IncorrectVertexArrays/Cube.gltf",
     "/bufferViews/2: error: ends at byte 936, but its buffer has 514 bytes"},
    {"assimp/test/models/glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf",
     "/meshes/0/primitives/0/indices: error: index 0 is 65535, but there are 24 vertices"},
    {"glTF-Validator/test/base/data/accessor/invalid_sparse_count_and_stride.gltf",
     "/accessors/0/sparse/count: error: 2 sparse values are more than the 1 elements of the accessor"},
    {"glTF-Validator/test/base/data/accessor/small_stride.gltf",
     "/accessors/0: error: the elements have 16 bytes, but the byteStride of their view is 4"},
    {"glTF-Validator/test/base/data/accessor_data/invalid_elements_float.gltf",
     "/accessors/0: error: element 0 is infinite"},
    {"glTF-Validator/test/base/data/buffer_view/invalid_length.gltf",
     "/bufferViews/0: error: ends at byte 5, but its buffer has 4 bytes"},
    {"glTF-Validator/test/base/data/mesh/indices_invalid_format.gltf",
     "/meshes/0/primitives/0/indices: error: indices must be a SCALAR accessor of unsigned integers"},
    {"glTF-Validator/test/base/data/node/node_parent_override.gltf",
     "/nodes/1/children/0: error: node 2 is already a child of node 0"},
};

TEST(Refusals, NameTheCause) {
    if (gltf_manifest(kData).empty()) GTEST_SKIP() << "the collection is not here";
    for (const Refusal& row : kTable) {
        const auto result = import_scene(kData + "/bad/" + row.file);
        ASSERT_FALSE(result) << row.file;
        EXPECT_THAT(result.error().text(), testing::HasSubstr(row.cause)) << row.file;
    }
}

TEST(Refusals, TheTableHasEveryFileThatMustBeRefused) {
    const auto rows = gltf_manifest(kData);
    if (rows.empty()) GTEST_SKIP() << "the collection is not here";
    size_t files = 0;
    for (const ManifestRow& row : rows) {
        if (!row.must_be_refused()) continue;
        ++files;
        EXPECT_TRUE(std::any_of(std::begin(kTable), std::end(kTable), [&](const Refusal& r) { return row.file == std::string("bad/") + r.file; })) << row.file << " is not in the table";
    }
    EXPECT_EQ(files, std::size(kTable)) << "the table has files that the collection has not";
}

}  // namespace
}  // namespace alidade::gltf_test
