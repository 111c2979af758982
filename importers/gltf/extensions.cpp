// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/extensions.h"

namespace alidade::gltf {

namespace {

constexpr const char* kConvertTextures = "convert the textures to PNG or WebP, for example with `gltf-transform`";

constexpr Extension kExtensions[] = {
    {"KHR_draco_mesh_compression", Support::full, "meshes compressed by Draco"},
    {"KHR_lights_punctual", Support::full, "point, spot and directional lights"},
    {"KHR_materials_clearcoat", Support::full, "a clear layer over the material; the scale of its normal map is left out"},
    {"KHR_materials_emissive_strength", Support::full, "emission beyond 1"},
    {"KHR_materials_ior", Support::full, "index of refraction"},
    {"KHR_materials_specular", Support::full, "strength and colour of the dielectric reflection"},
    {"KHR_materials_transmission", Support::full, "clear and coloured glass"},
    {"KHR_materials_unlit", Support::full, "constant colour without lighting"},
    {"KHR_mesh_quantization", Support::full, "integer vertex attributes"},
    {"KHR_meshopt_compression", Support::full, "as EXT_meshopt_compression; colour filters and version 1 of the attribute code only with a fallback"},
    {"KHR_node_visibility", Support::full, "hidden nodes"},
    {"KHR_texture_transform", Support::full, "offset, rotation and scale of texture coordinates"},
    {"EXT_mesh_gpu_instancing", Support::full, "many copies of a mesh"},
    {"EXT_meshopt_compression", Support::full, "buffer views compressed by meshoptimizer, all modes and filters"},
    {"EXT_texture_webp", Support::full, "WebP textures"},

    {"EXT_mesh_features", Support::harmless, "feature identifiers"},
    {"EXT_mesh_manifold", Support::harmless, "a manifold version of the mesh"},
    {"EXT_structural_metadata", Support::harmless, "structured metadata"},
    {"FB_ngon_encoding", Support::harmless, "polygons before triangulation"},
    {"GODOT_single_root", Support::harmless, "a hint for an editor"},
    {"KHR_node_hoverability", Support::harmless, "interaction"},
    {"KHR_node_selectability", Support::harmless, "interaction"},
    {"KHR_xmp_json_ld", Support::harmless, "authorship"},

    {"EXT_texture_avif", Support::needed, "the fallback texture is read", kConvertTextures},
    {"KHR_animation_pointer", Support::ignored, "only nodes and morph weights are animated"},
    {"KHR_materials_anisotropy", Support::ignored, "highlights are round"},
    {"KHR_materials_diffuse_transmission", Support::ignored, "thin surfaces are opaque"},
    {"KHR_materials_dispersion", Support::ignored, "all colours refract alike"},
    {"KHR_materials_iridescence", Support::ignored, "thin films have no colours"},
    {"KHR_materials_pbrSpecularGlossiness", Support::ignored, "the metal-rough fallback is used"},
    {"KHR_materials_sheen", Support::ignored, "cloth has no sheen"},
    {"KHR_materials_variants", Support::ignored, "the default materials are used"},
    {"KHR_materials_volume", Support::ignored, "glass does not absorb"},
    {"KHR_technique_webgl", Support::ignored, "shaders are not run"},
    {"KHR_techniques_webgl", Support::ignored, "shaders are not run"},
    {"KHR_texture_basisu", Support::needed, "the fallback texture is read", kConvertTextures},
    {"MSFT_texture_dds", Support::needed, "the fallback texture is read", kConvertTextures},
};

}  // namespace

std::span<const Extension> extensions() { return kExtensions; }

const Extension* find_extension(std::string_view name) {
    for (const Extension& e : kExtensions)
        if (name == e.name) return &e;
    return nullptr;
}

}  // namespace alidade::gltf
