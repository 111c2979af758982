// SPDX-License-Identifier: Apache-2.0
#include "tests/importers/gltf_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alidade::gltf_test {
namespace {

/// Two textures of two images, the second with its own sampler.
const std::string kTextures =
    R"("images":[{"uri":"data:;base64,AAEC"},{"uri":"data:;base64,AwQF"}],"samplers":[{"magFilter":9728,"wrapS":33071,"wrapT":33648}],
    "textures":[{"source":0},{"source":1,"sampler":0}],)";

Scene with_material(const std::string& material) { return scene_of(kTextures + R"("materials":[)" + material + "]"); }
const GltfPbr& pbr(const Scene& scene) { return std::get<GltfPbr>(scene.materials.at(0).layers.at(0)); }
template <class S> const S& signal(const Scene& scene, SignalId id) { return std::get<S>(scene.signals.at(id.index).what); }

/// The specification's defaults, section 5.19 ff.
TEST(Materials, Defaults) {
    const Scene scene = with_material("{}");
    EXPECT_EQ(signal<ConstantSignal>(scene, pbr(scene).base_color).value, Vec4(1, 1, 1, 1));
    EXPECT_FALSE(pbr(scene).metallic || pbr(scene).roughness || pbr(scene).normal || pbr(scene).emissive || pbr(scene).transmission ||
                 pbr(scene).specular || pbr(scene).clearcoat);
    EXPECT_EQ(pbr(scene).alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(pbr(scene).alpha_cutoff, 0.5);
    EXPECT_EQ(pbr(scene).ior, 1.5);
    EXPECT_FALSE(pbr(scene).double_sided || pbr(scene).unlit);
}

TEST(Materials, MetalAndRoughnessShareTheirTexture) {
    const Scene scene = with_material(R"({"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0},"roughnessFactor":0.5}})");
    const auto& product = signal<ProductSignal>(scene, *pbr(scene).roughness);
    const auto& green = signal<ChannelSignal>(scene, product.a);
    EXPECT_EQ(green.channel, 1);
    EXPECT_EQ(signal<ConstantSignal>(scene, product.b).value.x, 0.5);
    const auto& blue = signal<ChannelSignal>(scene, *pbr(scene).metallic);   // its factor is 1: no product
    EXPECT_EQ(blue.channel, 2);
    EXPECT_EQ(blue.of, green.of);
    EXPECT_FALSE(signal<ImageSignal>(scene, blue.of).srgb);
}

TEST(Materials, ColorsAreDecodedAndDataAreNot) {
    const Scene scene = with_material(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":1,"texCoord":2},"baseColorFactor":[1,0.5,1,1]},
        "emissiveTexture":{"index":1,"texCoord":2},"emissiveFactor":[1,1,1],"normalTexture":{"index":1,"texCoord":2,"scale":0.3},"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true})");
    const auto& product = signal<ProductSignal>(scene, pbr(scene).base_color);
    const auto& image = signal<ImageSignal>(scene, product.a);
    EXPECT_EQ(image.image, ImageId{1});
    EXPECT_EQ(image.uv_set, 2u);
    EXPECT_TRUE(image.srgb);
    EXPECT_EQ(image.filter, Filter::nearest);
    EXPECT_EQ(image.wrap_u, Wrap::clamp);
    EXPECT_EQ(image.wrap_v, Wrap::mirror);
    EXPECT_EQ(signal<ConstantSignal>(scene, product.b).value, Vec4(1, 0.5, 1, 1));
    EXPECT_EQ(*pbr(scene).emissive, product.a) << "the same texture used in the same way is one signal";
    EXPECT_FALSE(signal<ImageSignal>(scene, *pbr(scene).normal).srgb);
    EXPECT_EQ(pbr(scene).normal_scale, 0.3);
    EXPECT_EQ(pbr(scene).alpha_mode, AlphaMode::mask);
    EXPECT_EQ(pbr(scene).alpha_cutoff, 0.25);
    EXPECT_TRUE(pbr(scene).double_sided);
}

Vec2 transformed(const std::string& transform, const Vec2& uv, uint32_t set = 0) {
    const Scene scene =
        with_material(R"({"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0,"extensions":{"KHR_texture_transform":)" + transform + "}}}");
    const auto& image = signal<ImageSignal>(scene, *pbr(scene).emissive);
    EXPECT_EQ(image.uv_set, set);
    const Vec3 out = image.uv_transform * Vec3(uv.x, uv.y, 1);
    return {out.x, out.y};
}

/// The examples of KHR_texture_transform: the corners of the texture coordinates land on those of the lower left quadrant (v points down), turned by
/// a quarter; and a v axis that points up.
TEST(Materials, TextureTransform) {
    const auto near = [](const Vec2& a, double x, double y) { return std::abs(a.x - x) < 1e-9 && std::abs(a.y - y) < 1e-9; };
    const std::string quadrant = R"({"offset":[0,1],"rotation":1.57079632679489661923,"scale":[0.5,0.5]})";
    EXPECT_TRUE(near(transformed(quadrant, Vec2(0, 0)), 0, 1));
    EXPECT_TRUE(near(transformed(quadrant, Vec2(1, 0)), 0, 0.5));
    EXPECT_TRUE(near(transformed(quadrant, Vec2(0, 1)), 0.5, 1));
    EXPECT_TRUE(near(transformed(quadrant, Vec2(1, 1)), 0.5, 0.5));
    EXPECT_TRUE(near(transformed(R"({"offset":[0,1],"scale":[1,-1]})", Vec2(0.25, 0.25)), 0.25, 0.75));
    EXPECT_TRUE(near(transformed(R"({"scale":[2,3],"texCoord":1})", Vec2(0.25, 0.25), 1), 0.5, 0.75));
    EXPECT_TRUE(near(transformed(R"({"scale":[2,3],"rotation":0.5})", Vec2(1, 0)), 2 * std::cos(0.5), -2 * std::sin(0.5)))
        << "scaled first, then turned";
}

TEST(Materials, Extensions) {
    const Scene scene = with_material(
        R"({"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3000000000},"KHR_materials_ior":{"ior":1.33},
        "KHR_materials_transmission":{"transmissionFactor":0.75,"transmissionTexture":{"index":0}},"KHR_materials_unlit":{},
        "KHR_materials_specular":{"specularFactor":0.5,"specularTexture":{"index":0},"specularColorFactor":[2,1,0]},
        "KHR_materials_clearcoat":{"clearcoatFactor":1,"clearcoatRoughnessFactor":0.25,"clearcoatNormalTexture":{"index":1}}}})");
    const GltfPbr& p = pbr(scene);
    EXPECT_EQ(p.emissive_strength, 3e9) << "beyond the range of int";
    EXPECT_EQ(p.ior, 1.33);
    EXPECT_TRUE(p.unlit);
    EXPECT_EQ(signal<ChannelSignal>(scene, signal<ProductSignal>(scene, *p.transmission).a).channel, 0);
    EXPECT_EQ(signal<ChannelSignal>(scene, signal<ProductSignal>(scene, *p.specular).a).channel, 3);
    EXPECT_EQ(signal<ConstantSignal>(scene, *p.specular_color).value, Vec4(2, 1, 0, 1));
    EXPECT_EQ(signal<ConstantSignal>(scene, *p.clearcoat).value.x, 1);
    EXPECT_EQ(signal<ConstantSignal>(scene, *p.clearcoat_roughness).value.x, 0.25);
    EXPECT_EQ(signal<ImageSignal>(scene, *p.clearcoat_normal).image, ImageId{1});
}

/// A texture whose image is WebP alone is read; one without any image is left out and its factor stays.
TEST(Materials, TexturesWithoutASource) {
    const Scene webp = scene_of(R"("images":[{"uri":"data:;base64,AAEC"}],"textures":[{"extensions":{"EXT_texture_webp":{"source":0}}}],
        "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])");
    EXPECT_EQ(signal<ImageSignal>(webp, pbr(webp).base_color).image, ImageId{0});
    const auto none = import_text(
        with_asset(R"("textures":[{}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[1,0,0,1]}}])"));
    ASSERT_TRUE(none);
    EXPECT_THAT(none->diagnostics.text(), testing::HasSubstr("/textures/0: warning: the texture has no image that can be read"));
    EXPECT_EQ(signal<ConstantSignal>(none->scene, pbr(none->scene).base_color).value, Vec4(1, 0, 0, 1));
}

}  // namespace
}  // namespace alidade::gltf_test
