// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/schema.h"

#include "core/vec.h"

namespace alidade::gltf {

namespace {

constexpr Field boolean(const char* name) { return {.name = name, .kind = Kind::boolean}; }
constexpr Field integer(const char* name, double min, double max = kInf) { return {.name = name, .kind = Kind::integer, .min = min, .max = max}; }
constexpr Field one_of(const char* name, std::span<const int> values) { return {.name = name, .kind = Kind::integer, .integers = values}; }
constexpr Field number(const char* name, double min = -kInf, double max = kInf) {
    return {.name = name, .kind = Kind::number, .min = min, .max = max};
}
constexpr Field positive(const char* name) { return {.name = name, .kind = Kind::number, .min = 0, .above_min = true}; }
constexpr Field factor(const char* name, double max = 1) { return {.name = name, .kind = Kind::number, .clamped = true, .min = 0, .max = max}; }
constexpr Field text(const char* name) { return {.name = name, .kind = Kind::text}; }
constexpr Field texts(const char* name) { return {.name = name, .kind = Kind::texts}; }
constexpr Field one_of(const char* name, std::span<const char* const> values) { return {.name = name, .kind = Kind::text, .texts = values}; }
constexpr Field index(const char* name, const char* target) { return {.name = name, .kind = Kind::index, .target = target}; }
constexpr Field indices(const char* name, const char* target, size_t fewest = 0) {
    return {.name = name, .kind = Kind::indices, .target = target, .fewest = fewest};
}
constexpr Field numbers(const char* name, size_t fewest, size_t most) {
    return {.name = name, .kind = Kind::numbers, .fewest = fewest, .most = most};
}
constexpr Field factors(const char* name, size_t count, double max = 1) {
    return {.name = name, .kind = Kind::numbers, .clamped = true, .min = 0, .max = max, .fewest = count, .most = count};
}
constexpr Field object(const char* name, std::span<const Field> fields) { return {.name = name, .kind = Kind::object, .fields = fields}; }
constexpr Field objects(const char* name, std::span<const Field> fields, size_t fewest = 0) {
    return {.name = name, .kind = Kind::objects, .fewest = fewest, .fields = fields};
}
constexpr double kMaxInt = 2147483647;   // tinygltf keeps these numbers in an int
constexpr size_t kAny = std::numeric_limits<size_t>::max();

constexpr const char* kLights = "/extensions/KHR_lights_punctual/lights";
constexpr const char* kVariants = "/extensions/KHR_materials_variants/variants";

// ---- asset, buffers, accessors ----

constexpr Field kAsset[] = {!text("version"), text("minVersion"), text("generator"), text("copyright")};

constexpr Field kMeshoptBuffer[] = {boolean("fallback")};
constexpr Field kBufferExtensions[] = {object("EXT_meshopt_compression", kMeshoptBuffer), object("KHR_meshopt_compression", kMeshoptBuffer)};
constexpr Field kBuffer[] = {!integer("byteLength", 1), text("uri"), text("name"), object("extensions", kBufferExtensions)};

constexpr const char* kMeshoptModes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr const char* kMeshoptFilters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};
constexpr Field kMeshopt[] = {!index("buffer", "/buffers"),
                              integer("byteOffset", 0),
                              !integer("byteLength", 1),
                              !integer("byteStride", 1, 256),
                              !integer("count", 1, kMaxInt),
                              !one_of("mode", kMeshoptModes),
                              one_of("filter", kMeshoptFilters)};
constexpr Field kBufferViewExtensions[] = {object("EXT_meshopt_compression", kMeshopt), object("KHR_meshopt_compression", kMeshopt)};

constexpr int kTargets[] = {34962, 34963};
constexpr Field kBufferView[] = {!index("buffer", "/buffers"), integer("byteOffset", 0), !integer("byteLength", 1), integer("byteStride", 4, 252),
                                 one_of("target", kTargets), text("name"), object("extensions", kBufferViewExtensions)};

constexpr int kComponentTypes[] = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr int kSparseIndexTypes[] = {5121, 5123, 5125};
constexpr const char* kAccessorTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
constexpr Field kSparseIndices[] = {!index("bufferView", "/bufferViews"), integer("byteOffset", 0, kMaxInt),
                                    !one_of("componentType", kSparseIndexTypes)};
constexpr Field kSparseValues[] = {!index("bufferView", "/bufferViews"), integer("byteOffset", 0, kMaxInt)};
constexpr Field kSparse[] = {!integer("count", 1, kMaxInt), !object("indices", kSparseIndices), !object("values", kSparseValues)};
constexpr Field kAccessor[] = {index("bufferView", "/bufferViews"),
                               integer("byteOffset", 0),
                               !one_of("componentType", kComponentTypes),
                               boolean("normalized"),
                               !integer("count", 1),
                               !one_of("type", kAccessorTypes),
                               numbers("max", 1, 16),
                               numbers("min", 1, 16),
                               object("sparse", kSparse),
                               text("name")};

// ---- images, textures ----

constexpr Field kImage[] = {text("uri"), text("mimeType"), index("bufferView", "/bufferViews"), text("name")};

constexpr int kMagFilters[] = {9728, 9729};
constexpr int kMinFilters[] = {9728, 9729, 9984, 9985, 9986, 9987};
constexpr int kWraps[] = {33071, 33648, 10497};
constexpr Field kSampler[] = {one_of("magFilter", kMagFilters), one_of("minFilter", kMinFilters), one_of("wrapS", kWraps), one_of("wrapT", kWraps),
                              text("name")};

constexpr Field kTextureWebp[] = {index("source", "/images")};
constexpr Field kTextureExtensions[] = {object("EXT_texture_webp", kTextureWebp)};
constexpr Field kTexture[] = {index("sampler", "/samplers"), index("source", "/images"), text("name"), object("extensions", kTextureExtensions)};

// ---- materials ----

constexpr Field kTextureTransform[] = {numbers("offset", 2, 2), number("rotation"), numbers("scale", 2, 2), integer("texCoord", 0, 255)};
constexpr Field kTextureInfoExtensions[] = {object("KHR_texture_transform", kTextureTransform)};
constexpr Field kTextureInfo[] = {!index("index", "/textures"), integer("texCoord", 0, 255), object("extensions", kTextureInfoExtensions)};
constexpr Field kNormalTexture[] = {!index("index", "/textures"), integer("texCoord", 0, 255), number("scale"),
                                    object("extensions", kTextureInfoExtensions)};
constexpr Field kOcclusionTexture[] = {!index("index", "/textures"), integer("texCoord", 0, 255), factor("strength"),
                                       object("extensions", kTextureInfoExtensions)};
constexpr Field kMetalRough[] = {factors("baseColorFactor", 4), object("baseColorTexture", kTextureInfo), factor("metallicFactor"),
                                 factor("roughnessFactor"), object("metallicRoughnessTexture", kTextureInfo)};

constexpr Field kClearcoat[] = {factor("clearcoatFactor"), object("clearcoatTexture", kTextureInfo), factor("clearcoatRoughnessFactor"),
                                object("clearcoatRoughnessTexture", kTextureInfo), object("clearcoatNormalTexture", kNormalTexture)};
constexpr Field kEmissiveStrength[] = {factor("emissiveStrength", kInf)};
constexpr Field kIor[] = {number("ior", 0)};
constexpr Field kSpecular[] = {factor("specularFactor"), object("specularTexture", kTextureInfo), factors("specularColorFactor", 3, kInf),
                               object("specularColorTexture", kTextureInfo)};
constexpr Field kTransmission[] = {factor("transmissionFactor"), object("transmissionTexture", kTextureInfo)};
constexpr Field kMaterialExtensions[] = {object("KHR_materials_clearcoat", kClearcoat),
                                         object("KHR_materials_emissive_strength", kEmissiveStrength),
                                         object("KHR_materials_ior", kIor),
                                         object("KHR_materials_specular", kSpecular),
                                         object("KHR_materials_transmission", kTransmission),
                                         object("KHR_materials_unlit", {})};
constexpr const char* kAlphaModes[] = {"OPAQUE", "MASK", "BLEND"};
constexpr Field kMaterial[] = {text("name"),
                               object("pbrMetallicRoughness", kMetalRough),
                               object("normalTexture", kNormalTexture),
                               object("occlusionTexture", kOcclusionTexture),
                               object("emissiveTexture", kTextureInfo),
                               factors("emissiveFactor", 3, kInf),
                               one_of("alphaMode", kAlphaModes),
                               factor("alphaCutoff", kInf),
                               boolean("doubleSided"),
                               object("extensions", kMaterialExtensions)};

// ---- meshes ----

constexpr int kModes[] = {0, 1, 2, 3, 4, 5, 6};
constexpr Field kMapping[] = {indices("variants", kVariants), !index("material", "/materials"), text("name")};
constexpr Field kPrimitiveVariants[] = {!objects("mappings", kMapping)};
constexpr Field kDraco[] = {!index("bufferView", "/bufferViews"), !Field{.name = "attributes", .kind = Kind::integer_map, .min = 0, .max = kMaxInt}};
constexpr Field kPrimitiveExtensions[] = {object("KHR_materials_variants", kPrimitiveVariants), object("KHR_draco_mesh_compression", kDraco)};
constexpr Field kPrimitive[] = {!Field{.name = "attributes", .kind = Kind::index_map, .target = "/accessors"},
                                index("indices", "/accessors"),
                                index("material", "/materials"),
                                one_of("mode", kModes),
                                Field{.name = "targets", .kind = Kind::index_maps, .target = "/accessors"},
                                object("extensions", kPrimitiveExtensions)};
constexpr Field kMesh[] = {!objects("primitives", kPrimitive, 1), numbers("weights", 0, kAny), text("name")};

// ---- nodes, skins, cameras, lights ----

constexpr Field kNodeLight[] = {!index("light", kLights)};
constexpr Field kNodeVisibility[] = {boolean("visible")};
constexpr Field kNodeInstancing[] = {!Field{.name = "attributes", .kind = Kind::index_map, .target = "/accessors"}};
constexpr Field kNodeExtensions[] = {object("KHR_lights_punctual", kNodeLight), object("KHR_node_visibility", kNodeVisibility),
                                     object("EXT_mesh_gpu_instancing", kNodeInstancing)};
constexpr Field kNode[] = {index("camera", "/cameras"),
                           indices("children", "/nodes"),
                           index("skin", "/skins"),
                           numbers("matrix", 16, 16),
                           index("mesh", "/meshes"),
                           numbers("rotation", 4, 4),
                           numbers("scale", 3, 3),
                           numbers("translation", 3, 3),
                           numbers("weights", 0, kAny),
                           text("name"),
                           object("extensions", kNodeExtensions)};
constexpr Field kScene[] = {indices("nodes", "/nodes"), text("name")};
constexpr Field kSkin[] = {index("inverseBindMatrices", "/accessors"), index("skeleton", "/nodes"), !indices("joints", "/nodes", 1), text("name")};

constexpr const char* kCameraTypes[] = {"perspective", "orthographic"};
constexpr Field kPerspective[] = {positive("aspectRatio"), !positive("yfov"), positive("zfar"), !positive("znear")};
constexpr Field kOrthographic[] = {!number("xmag"), !number("ymag"), !number("zfar"), !number("znear", 0)};
constexpr Field kCamera[] = {!one_of("type", kCameraTypes), object("perspective", kPerspective), object("orthographic", kOrthographic), text("name")};

constexpr Field kSpot[] = {factor("innerConeAngle", kPi / 2), factor("outerConeAngle", kPi / 2)};
constexpr Field kLight[] = {!text("type"),     factors("color", 3, kInf), factor("intensity", kInf),
                            positive("range"), object("spot", kSpot),     text("name")};

// ---- animations ----

constexpr const char* kPaths[] = {"translation", "rotation", "scale", "weights", "pointer"};
constexpr const char* kInterpolations[] = {"LINEAR", "STEP", "CUBICSPLINE"};
constexpr Field kChannelTarget[] = {index("node", "/nodes"), !one_of("path", kPaths)};
constexpr Field kChannel[] = {!integer("sampler", 0, kMaxInt), !object("target", kChannelTarget)};
constexpr Field kAnimationSampler[] = {!index("input", "/accessors"), !index("output", "/accessors"), one_of("interpolation", kInterpolations)};
constexpr Field kAnimation[] = {!objects("channels", kChannel), !objects("samplers", kAnimationSampler), text("name")};

// ---- root ----

constexpr Field kPunctualLights[] = {!objects("lights", kLight)};
constexpr Field kVariant[] = {!text("name")};
constexpr Field kMaterialVariants[] = {!objects("variants", kVariant)};
constexpr Field kRootExtensions[] = {object("KHR_lights_punctual", kPunctualLights), object("KHR_materials_variants", kMaterialVariants)};
constexpr Field kRoot[] = {!object("asset", kAsset),
                           texts("extensionsUsed"),
                           texts("extensionsRequired"),
                           object("extensions", kRootExtensions),
                           objects("buffers", kBuffer),
                           objects("bufferViews", kBufferView),
                           objects("accessors", kAccessor),
                           objects("images", kImage),
                           objects("samplers", kSampler),
                           objects("textures", kTexture),
                           objects("materials", kMaterial),
                           objects("meshes", kMesh),
                           objects("skins", kSkin),
                           objects("cameras", kCamera),
                           objects("nodes", kNode),
                           objects("scenes", kScene),
                           index("scene", "/scenes"),
                           objects("animations", kAnimation)};

}  // namespace

std::span<const Field> root_fields() { return kRoot; }

}  // namespace alidade::gltf
