// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/materials.h"

namespace alidade::gltf_export {

namespace {

enum Channel { kAll = -1, kRed = 0, kGreen = 1, kBlue = 2, kAlpha = 3 };

class MaterialWriter {
  public:
    MaterialWriter(const Scene& scene, Document& document, TextureWriter& textures, Losses& losses)
        : scene_(scene), document_(document), textures_(textures), losses_(losses) {}

    Json write(const Material& material) {
        const PlainSurface s = plain_surface(scene_, material, losses_);
        Json json = Json::object();
        set(json, "name", material.name, std::string());
        Json metal_rough = Json::object();
        put_base_color(s, metal_rough);
        put_metal_rough(s, metal_rough);
        if (!metal_rough.empty()) json["pbrMetallicRoughness"] = std::move(metal_rough);
        put_surface(s, json);
        put_alpha(s, json);
        if (s.unlit) document_.use(json, "KHR_materials_unlit") = Json::object();
        set_extension(json, "KHR_materials_ior", "ior", s.ior == 0 ? 0 : std::max(s.ior, 1.0), 1.5);
        put_transmission(s, json);
        put_specular(s, json);
        put_clearcoat(s, json);
        return json;
    }

  private:
    void set_extension(Json& json, const char* extension, const char* key, double value, double usual) {
        if (value != usual) document_.use(json, extension)[key] = value;
    }

    /// Between 0 and 1, as the format wants it.
    double unit(double x) {
        losses_.add("factors of materials outside of 0 to 1", !(x >= 0 && x <= 1), "0 or 1");
        return std::clamp(x, 0.0, 1.0);
    }

    /// The texture of `texel`, if it reads the channel that the format reads.
    void put_texture(Json& object, const char* key, const std::optional<Texel>& texel, int channel) {
        if (!texel || !texel->picture) return;
        if (texel->channel != channel) return losses_.add("textures in other channels than glTF's", 1, "their factors");
        if (!textures_.put(object, key, *texel->picture)) losses_.add("textures", 1, "their factors");
    }

    void put_base_color(const PlainSurface& s, Json& json) {
        const Vec4& f = s.base_color.factor;
        set(json, "baseColorFactor", Vec4(unit(f.x), unit(f.y), unit(f.z), unit(f.w)), Vec4(1));
        put_texture(json, "baseColorTexture", s.base_color, kAll);
    }

    static bool same_picture(const ImageSignal& a, const ImageSignal& b) {
        return a.image == b.image && a.uv_set == b.uv_set && a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v && a.filter == b.filter && a.uv_transform == b.uv_transform;
    }

    /// One texture holds both: roughness in green, metalness in blue. So one picture must serve both, or the other's factor must be 0.
    void put_metal_rough(const PlainSurface& s, Json& json) {
        const double metallic = unit(s.metallic.factor.x), roughness = unit(s.roughness.factor.x);
        set(json, "metallicFactor", metallic, 1.0);
        set(json, "roughnessFactor", roughness, 1.0);
        const std::optional<ImageSignal>&m = s.metallic.picture, &r = s.roughness.picture;
        if (!m && !r) return;
        const bool metallic_fits = m ? s.metallic.channel == kBlue : metallic == 0;
        const bool roughness_fits = r ? s.roughness.channel == kGreen : roughness == 0;
        if (!metallic_fits || !roughness_fits || (m && r && !same_picture(*m, *r)))
            return losses_.add("textures of roughness or metalness that are not the green and blue of one picture", 1, "their factors");
        if (!textures_.put(json, "metallicRoughnessTexture", m ? *m : *r)) losses_.add("textures", 1, "their factors");
    }

    void put_surface(const PlainSurface& s, Json& json) {
        put_texture(json, "normalTexture", s.normal, kAll);
        if (json.contains("normalTexture")) set(json["normalTexture"], "scale", s.normal_scale, 1.0);
        put_texture(json, "occlusionTexture", s.occlusion, kRed);
        if (!s.emissive) return;
        Vec3 factor(s.emissive->factor);
        double strength = s.emissive_strength;
        losses_.add("negative emission", std::min({factor.x, factor.y, factor.z}) < 0, "0");
        factor = glm::max(factor, Vec3(0));
        if (const double most = max_component(factor); most > 1) factor /= most, strength *= most;
        set(json, "emissiveFactor", factor, Vec3(0));
        put_texture(json, "emissiveTexture", s.emissive, kAll);
        set_extension(json, "KHR_materials_emissive_strength", "emissiveStrength", strength, 1);
    }

    static void put_alpha(const PlainSurface& s, Json& json) {
        if (s.alpha_mode == AlphaMode::blend) json["alphaMode"] = "BLEND";
        if (s.alpha_mode == AlphaMode::mask) {
            json["alphaMode"] = "MASK";
            set(json, "alphaCutoff", s.alpha_cutoff, 0.5);
        }
        set(json, "doubleSided", s.double_sided, false);
    }

    void put_transmission(const PlainSurface& s, Json& json) {
        if (!s.transmission) return;
        Json& out = document_.use(json, "KHR_materials_transmission");
        out["transmissionFactor"] = unit(s.transmission->factor.x);
        put_texture(out, "transmissionTexture", s.transmission, kRed);
    }

    void put_specular(const PlainSurface& s, Json& json) {
        if (!s.specular && !s.specular_color) return;
        Json& out = document_.use(json, "KHR_materials_specular") = Json::object();
        if (s.specular) {
            set(out, "specularFactor", unit(s.specular->factor.w), 1.0);
            put_texture(out, "specularTexture", s.specular, kAlpha);
        }
        if (!s.specular_color) return;
        set(out, "specularColorFactor", Vec3(s.specular_color->factor), Vec3(1));
        put_texture(out, "specularColorTexture", s.specular_color, kAll);
    }

    void put_clearcoat(const PlainSurface& s, Json& json) {
        if (!s.clearcoat) return;
        Json& out = document_.use(json, "KHR_materials_clearcoat");
        out["clearcoatFactor"] = unit(s.clearcoat->factor.x);
        put_texture(out, "clearcoatTexture", s.clearcoat, kRed);
        if (s.clearcoat_roughness) {
            out["clearcoatRoughnessFactor"] = unit(s.clearcoat_roughness->factor.x);
            put_texture(out, "clearcoatRoughnessTexture", s.clearcoat_roughness, kGreen);
        }
        put_texture(out, "clearcoatNormalTexture", s.clearcoat_normal, kAll);
    }

    const Scene& scene_;
    Document& document_;
    TextureWriter& textures_;
    Losses& losses_;
};

}  // namespace

void write_materials(const Scene& scene, Document& document, TextureWriter& textures, Losses& losses) {
    MaterialWriter writer(scene, document, textures, losses);
    for (const Material& material : scene.materials) document.add("materials", writer.write(material));
}

}  // namespace alidade::gltf_export
