// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/materials.h"

#include "importers/gltf/textures.h"
#include "importers/gltf/values.h"

#include <fmt/format.h>

namespace alidade::gltf {

namespace {

enum ColorChannel { kRed = 0, kGreen = 1, kBlue = 2, kAlpha = 3 };

Vec4 opaque(const Vec3& color) { return {color.x, color.y, color.z, 1}; }

class MaterialConverter {
  public:
    MaterialConverter(const Model& model, Scene& scene, Reporter& report) : signals_(model, scene, report), report_(report) {}

    Material convert(const tinygltf::Material& from, const std::string& at) {
        GltfPbr pbr;
        convert_metal_rough(from.pbrMetallicRoughness, child(at, "pbrMetallicRoughness"), pbr);
        convert_surface(from, at, pbr);
        if (const auto* e = extension_of(from, "KHR_materials_emissive_strength")) pbr.emissive_strength = number_in(*e, "emissiveStrength", 1);
        if (const auto* e = extension_of(from, "KHR_materials_ior")) convert_ior(*e, extension_at(at, "KHR_materials_ior"), pbr);
        if (const auto* e = extension_of(from, "KHR_materials_transmission"))
            convert_transmission(*e, extension_at(at, "KHR_materials_transmission"), pbr);
        if (const auto* e = extension_of(from, "KHR_materials_specular")) convert_specular(*e, extension_at(at, "KHR_materials_specular"), pbr);
        if (const auto* e = extension_of(from, "KHR_materials_clearcoat")) convert_clearcoat(*e, extension_at(at, "KHR_materials_clearcoat"), pbr);
        pbr.unlit = extension_of(from, "KHR_materials_unlit") != nullptr;
        Material material;
        material.name = from.name;
        material.from = report_.at(at);
        material.layers.emplace_back(pbr);
        return material;
    }

  private:
    static std::string extension_at(const std::string& at, const char* name) { return child(child(at, "extensions"), name); }

    void convert_metal_rough(const tinygltf::PbrMetallicRoughness& from, const std::string& at, GltfPbr& pbr) {
        const auto& c = from.baseColorFactor;
        pbr.base_color = signals_.textured(texture_use(from.baseColorTexture, child(at, "baseColorTexture")), true, Vec4(c[0], c[1], c[2], c[3]), at);
        const TextureUse both = texture_use(from.metallicRoughnessTexture, child(at, "metallicRoughnessTexture"));
        pbr.roughness = signals_.channel(both, kGreen, from.roughnessFactor, 1, at);
        pbr.metallic = signals_.channel(both, kBlue, from.metallicFactor, 1, at);
    }

    void convert_surface(const tinygltf::Material& from, const std::string& at, GltfPbr& pbr) {
        const TextureUse normal = texture_use(from.normalTexture, child(at, "normalTexture"));
        pbr.normal = signals_.texture(normal, false);
        pbr.normal_scale = normal.scale;
        pbr.occlusion = signals_.channel(texture_use(from.occlusionTexture, child(at, "occlusionTexture")), kRed, 1, 1, at);
        const Vec3 emissive(from.emissiveFactor[0], from.emissiveFactor[1], from.emissiveFactor[2]);
        if (!is_black(emissive))
            pbr.emissive = signals_.textured(texture_use(from.emissiveTexture, child(at, "emissiveTexture")), true, opaque(emissive), at);
        pbr.alpha_mode = from.alphaMode == "MASK" ? AlphaMode::mask : from.alphaMode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
        pbr.alpha_cutoff = from.alphaCutoff;
        pbr.double_sided = from.doubleSided;
    }

    /// 0 means an infinite index, whose reflectance at normal incidence is 1 as that of 0 is; between 0 and 1 the extension allows nothing.
    void convert_ior(const tinygltf::Value& from, const std::string& at, GltfPbr& pbr) {
        pbr.ior = number_in(from, "ior", 1.5);
        if (pbr.ior == 0 || pbr.ior >= 1) return;
        report_.warning(child(at, "ior"), fmt::format("{} should be 0 or at least 1: 1 is used", pbr.ior));
        pbr.ior = 1;
    }

    void convert_transmission(const tinygltf::Value& from, const std::string& at, GltfPbr& pbr) {
        const double factor = number_in(from, "transmissionFactor", 0);
        if (factor > 0) pbr.transmission = signals_.channel(texture_use(from, "transmissionTexture", at), kRed, factor, 0, at);
    }

    void convert_specular(const tinygltf::Value& from, const std::string& at, GltfPbr& pbr) {
        pbr.specular = signals_.channel(texture_use(from, "specularTexture", at), kAlpha, number_in(from, "specularFactor", 1), 1, at);
        const TextureUse color = texture_use(from, "specularColorTexture", at);
        const Vec3 factor = vec3_in(from, "specularColorFactor", Vec3(1, 1, 1));
        if (color.present() || factor != Vec3(1, 1, 1)) pbr.specular_color = signals_.textured(color, true, opaque(factor), at);
    }

    void convert_clearcoat(const tinygltf::Value& from, const std::string& at, GltfPbr& pbr) {
        const double factor = number_in(from, "clearcoatFactor", 0);
        if (factor == 0) return;
        pbr.clearcoat = signals_.channel(texture_use(from, "clearcoatTexture", at), kRed, factor, 0, at);
        const double roughness = number_in(from, "clearcoatRoughnessFactor", 0);
        if (roughness > 0) pbr.clearcoat_roughness = signals_.channel(texture_use(from, "clearcoatRoughnessTexture", at), kGreen, roughness, 0, at);
        const TextureUse normal = texture_use(from, "clearcoatNormalTexture", at);
        pbr.clearcoat_normal = signals_.texture(normal, false);
        if (normal.scale != 1) report_.not_understood(child(normal.at, "scale"), "the scale of clearcoat normals is ignored");
    }

    SignalBuilder signals_;
    Reporter& report_;
};

}  // namespace

void convert_materials(const Model& model, Scene& scene, Reporter& report) {
    MaterialConverter converter(model, scene, report);
    for (size_t i = 0; i < model.materials.size(); ++i) scene.materials.push_back(converter.convert(model.materials[i], child("/materials", i)));
}

}  // namespace alidade::gltf
