// SPDX-License-Identifier: Apache-2.0
/// MTL statements, and the surfaces that come of them.
#include "importers/mesh/mtl_material.h"
#include "tests/importers/obj_files.h"

#include "core/image.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;

/// A scene with one triangle of the material "m", whose statements are given.
class MtlFiles : public ObjFiles {
  protected:
    ImportResult import_mtl(const std::string& statements, const ImportOptions& options = {}) const {
        write("a.mtl", "newmtl other\nKd 1 0 0\nnewmtl m\n" + statements);
        return import_text("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n", options);
    }
    /// The surface, of a library that must load; what it says is kept in scene_ and said_.
    GltfPbr surface(const std::string& statements) {
        ImportResult result = import_mtl(statements);
        if (!result) {
            ADD_FAILURE() << statements << said(result);
            return {};
        }
        said_ = said(result);
        scene_ = std::move(result->scene);
        EXPECT_FALSE(validate(scene_).has_errors()) << validate(scene_).text();
        EXPECT_EQ(scene_.materials.size(), 1u) << "only used materials are made";
        return std::get<GltfPbr>(scene_.materials[0].layers[0]);
    }
    Vec4 constant(std::optional<SignalId> id) const {
        const auto* c = id ? std::get_if<ConstantSignal>(&scene_.signals[id->index].what) : nullptr;
        return c ? c->value : Vec4(-1);
    }
    template <class S> const S* signal(std::optional<SignalId> id) const { return id ? std::get_if<S>(&scene_.signals[id->index].what) : nullptr; }
    void write_png(const std::string& name, float r, float g, float b) const {
        Picture picture(4, 4, {"R", "G", "B"});
        for (size_t i = 0; i < picture.values.size(); i += 3) picture.values[i] = r, picture.values[i + 1] = g, picture.values[i + 2] = b;
        ASSERT_TRUE(write_picture(path(name), picture));
    }

    Scene scene_;
    std::string said_;
};

TEST_F(MtlFiles, PlainColors) {
    const GltfPbr pbr = surface("Ka 1 1 1\nKd 0.1 0.2 0.3\nNi 1.3\n");
    EXPECT_EQ(constant(pbr.base_color), Vec4(0.1, 0.2, 0.3, 1));
    EXPECT_EQ(constant(pbr.metallic), Vec4(0));
    EXPECT_FALSE(pbr.roughness) << "absent is 1";
    EXPECT_TRUE(pbr.double_sided);
    EXPECT_EQ(pbr.ior, 1.3);
    EXPECT_EQ(pbr.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(said_, "");
    EXPECT_EQ(constant(surface("Kd 0.5\n").base_color), Vec4(0.5, 0.5, 0.5, 1)) << "one number is all three";
    EXPECT_EQ(constant(surface("").base_color), Vec4(0.8, 0.8, 0.8, 1));
}

TEST_F(MtlFiles, HighlightsBecomeRoughness) {
    EXPECT_NEAR(constant(surface("Ks 1 1 1\nNs 0\n").roughness).x, 1, 1e-12);
    EXPECT_NEAR(constant(surface("Ks 1 1 1\nNs 30\n").roughness).x, 0.5, 1e-12) << "alpha = sqrt(2 / 32) = 1/4";
    EXPECT_NEAR(constant(surface("Ns 30\nPr 0.3\n").roughness).x, 0.3, 1e-12) << "Pr has the last word";
    EXPECT_EQ(constant(surface("Ks 0 0 0\n").specular), Vec4(0));
    EXPECT_EQ(constant(surface("Ks 1 1 1\nillum 1\n").specular), Vec4(0));
    EXPECT_FALSE(surface("Ks 1 1 1\nillum 2\n").specular);
    EXPECT_EQ(constant(surface("Pm 0.75\nPc 0.5\nPcr 0.25\n").metallic), Vec4(0.75));
    EXPECT_EQ(constant(surface("Pc 0.5\nPcr 0.25\n").clearcoat_roughness), Vec4(0.25));
}

TEST_F(MtlFiles, MirrorsReflectKs) {
    const GltfPbr metal = surface("Kd 0 0 0\nKs 0.9 0.8 0.1\nillum 3\n");
    EXPECT_EQ(constant(metal.base_color), Vec4(0.9, 0.8, 0.1, 1));
    EXPECT_EQ(constant(metal.metallic), Vec4(1));
    const GltfPbr varnish = surface("Kd 0.5 0 0\nKs 0.2 0.2 0.2\nillum 5\n");
    EXPECT_EQ(constant(varnish.metallic), Vec4(0));
    EXPECT_NEAR(constant(varnish.specular_color).x * 0.04, 0.2, 1e-12) << "0.04 is the reflectance head-on of an index of 1.5";
}

TEST_F(MtlFiles, OpacityAndRefraction) {
    const GltfPbr blended = surface("Kd 1 1 1\nd 0.25\n");
    EXPECT_EQ(constant(blended.base_color), Vec4(1, 1, 1, 0.25));
    EXPECT_EQ(blended.alpha_mode, AlphaMode::blend);
    EXPECT_EQ(constant(surface("Tr 0.25\n").base_color).w, 0.75);
    EXPECT_EQ(constant(surface("d 0.5\nTr 0.9\n").base_color).w, 0.5) << "d has the last word";
    const GltfPbr glass = surface("Kd 0 0 0\nKs 1 1 1\nNi 1.6\nillum 7\nTf 0.9 1 0.9\n");
    EXPECT_EQ(constant(glass.transmission), Vec4(1));
    EXPECT_EQ(constant(glass.base_color), Vec4(0.9, 1, 0.9, 1));
    EXPECT_EQ(glass.ior, 1.6);
    EXPECT_EQ(glass.alpha_mode, AlphaMode::opaque);
    EXPECT_NEAR(constant(surface("illum 6\nd 0.3\n").transmission).x, 0.7, 1e-12);
}

TEST_F(MtlFiles, PicturesWithOptions) {
    write_png("t.png", 1, 1, 1);
    const GltfPbr pbr = surface("map_Kd -o 0.1 0.2 0 -s 3 4 -clamp on -texres 512 -blendu off -mm 0 1 t.png\nmap_Pr -imfchan g t.png\nPr 0.5\nmap_Ke t.png\n");
    EXPECT_EQ(said_, "");
    ASSERT_EQ(scene_.images.size(), 1u) << "a picture used twice is one";
    EXPECT_EQ(scene_.images[0].path, path("t.png"));
    const auto* base = signal<ImageSignal>(pbr.base_color);
    ASSERT_TRUE(base);
    EXPECT_TRUE(base->srgb);
    EXPECT_EQ(base->wrap_u, Wrap::clamp);
    // The file's (u, v) = (0.5, 0.75) stands at (0.5, 0.25) in the scene; the file looks up (3 u + 0.1, 4 v + 0.2) = (1.6, 3.2): (1.6, -2.2).
    const Vec3 looked_up = base->uv_transform * Vec3(0.5, 0.25, 1);
    EXPECT_NEAR(looked_up.x, 1.6, 1e-12);
    EXPECT_NEAR(looked_up.y, -2.2, 1e-12);
    const auto* product = signal<ProductSignal>(pbr.roughness);
    ASSERT_TRUE(product);
    const auto* channel = signal<ChannelSignal>(product->a);
    ASSERT_TRUE(channel);
    EXPECT_EQ(channel->channel, 1);
    EXPECT_FALSE(signal<ImageSignal>(channel->of)->srgb);
    EXPECT_EQ(constant(product->b), Vec4(0.5));
    EXPECT_TRUE(signal<ImageSignal>(pbr.emissive)->srgb);
}

TEST_F(MtlFiles, KdTimesItsMap) {
    write_png("a b.png", 1, 1, 1);
    const auto pbr = surface("Kd 0.5 0.5 0.5\nd 0.5\nmap_Kd a b.png\n");
    const auto* product = signal<ProductSignal>(pbr.base_color);
    ASSERT_TRUE(product) << said_;
    EXPECT_TRUE(signal<ImageSignal>(product->a));
    EXPECT_EQ(constant(product->b), Vec4(0.5, 0.5, 0.5, 0.5));
}

TEST_F(MtlFiles, TheAlphaOfMapKdIsUsedIfMapDNamesIt) {
    write_png("t.png", 1, 1, 1);
    write_png("u.png", 1, 1, 1);
    EXPECT_EQ(surface("map_Kd t.png\nmap_d t.png\n").alpha_mode, AlphaMode::blend);
    EXPECT_EQ(surface("map_Kd t.png\nmap_d u.png\n").alpha_mode, AlphaMode::opaque);
    EXPECT_THAT(said_, HasSubstr("a.mtl:5:1: warning: a map_d that is not the alpha of map_Kd"));
}

TEST_F(MtlFiles, BumpMapsThatAreNormalMapsAreTaken) {
    write_png("normal.png", 0.21404f, 0.21404f, 1);   // (0.5, 0.5, 1) as stored
    write_png("height.png", 0.3f, 0.3f, 0.3f);
    const GltfPbr bumped = surface("map_Bump -bm 0.5 normal.png\n");
    EXPECT_EQ(bumped.normal_scale, 0.5);
    ASSERT_TRUE(signal<ImageSignal>(bumped.normal)) << said_;
    EXPECT_FALSE(signal<ImageSignal>(bumped.normal)->srgb);
    EXPECT_FALSE(surface("bump height.png\n").normal);
    EXPECT_THAT(said_, HasSubstr("\"height.png\" is no normal map"));
    EXPECT_TRUE(surface("norm height.png\n").normal) << "norm says what it is";
}

TEST_F(MtlFiles, PicturesOutsideTheFolderAreNotRead) {
    write_png("t.png", 1, 1, 1);
    const struct { const char* name; const char* why; } rows[] = {
        {"/etc/passwd", "absolute paths"}, {"../t.png", "\"..\" is not allowed"}, {"C:\\t.png", "absolute paths"}, {"x/../../t.png", "\"..\""}, {"none.png", "there is no picture"}};
    for (const auto& row : rows) {
        const GltfPbr pbr = surface(std::string("Kd 0.5 0.5 0.5\nmap_Kd ") + row.name + "\n");
        EXPECT_EQ(constant(pbr.base_color), Vec4(0.5, 0.5, 0.5, 1)) << row.name;
        EXPECT_THAT(said_, HasSubstr(row.why)) << row.name;
        EXPECT_TRUE(scene_.images.empty());
    }
    EXPECT_TRUE(signal<ImageSignal>(surface("map_Kd .\\t.png\n").base_color)) << "backslashes are slashes: " << said_;
}

TEST_F(MtlFiles, ErrorsStandAtTheirLineAndColumn) {
    const struct { const char* statements; const char* error; } rows[] = {
        {"Kd 1 x 1\n", "a.mtl:4:6: error: \"x\" is not a finite number"},
        {"Kd\n", "a.mtl:4:3: error: \"\" is not a finite number"},
        {"Ns nan\n", "a.mtl:4:4: error: \"nan\" is not a finite number"},
        {"illum two\n", "a.mtl:4:7: error: \"two\" is not an illumination model"},
        {"illum 11\n", "a.mtl:4:7: error: \"11\" is not an illumination model"},
        {"map_Kd -s 1\n", "a.mtl:4:1: error: the name of a picture is missing"},
        {"norm -bm x t.png\n", "a.mtl:4:10: error: \"x\" is not a finite number"},
    };
    for (const auto& row : rows) {
        const ImportResult result = import_mtl(row.statements);
        ASSERT_FALSE(result) << row.statements;
        EXPECT_THAT(said(result), testing::StartsWith(row.error)) << row.statements;
    }
}

TEST_F(MtlFiles, WhatHasNoCounterpartIsSaid) {
    surface("disp x.png\nPs 1\nfoo\nKd spectral x.rfl\n");
    EXPECT_THAT(said_, HasSubstr("a.mtl:4:1: warning: disp has no counterpart here: left out"));
    EXPECT_THAT(said_, HasSubstr("a.mtl:6:1: warning: unknown statement \"foo\""));
    EXPECT_THAT(said_, HasSubstr("spectral colours are not supported"));
    ImportOptions strict;
    strict.strict = true;
    EXPECT_FALSE(import_mtl("foo\n", strict));
}

TEST_F(MtlFiles, BinaryLibrariesAreRefused) {
    write("picture.mtl", std::string_view("\x89PNG\r\n\0\0", 8));
    EXPECT_THAT(said(import_text("mtllib picture.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), HasSubstr("picture.mtl: error: the file is binary, MTL is text (mtllib names it as a material library)"));
}

TEST_F(MtlFiles, LibraryNamesMayHoldBlanks) {
    write("with blank.mtl", "newmtl m\nKd 1 0 0\n");
    write("x.mtl", "newmtl n\nKd 0 1 0\n");
    const std::string triangles = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\nusemtl n\nf 3 2 1\n";
    for (const char* line : {"mtllib with blank.mtl\nmtllib x.mtl\n", "mtllib x.mtl with\\ blank.mtl\n", "mtllib  with\\ blank.mtl   x.mtl \n"}) {
        const ImportResult result = import_text(line + triangles);
        ASSERT_TRUE(result);
        EXPECT_EQ(said(result), "") << line;
        EXPECT_EQ(result->scene.materials.size(), 2u) << line;
    }
}

TEST_F(MtlFiles, WithoutMaterialTheSurfaceIsGrayOrTakesTheVertexColors) {
    const ImportResult gray = import_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_TRUE(gray);
    EXPECT_EQ(std::get<ConstantSignal>(gray->scene.signals[0].what).value, Vec4(0.8, 0.8, 0.8, 1));
    EXPECT_TRUE(std::get<GltfPbr>(gray->scene.materials[0].layers[0]).double_sided);
    const ImportResult colored = import_text("v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_TRUE(colored);
    EXPECT_EQ(std::get<ConstantSignal>(colored->scene.signals[0].what).value, Vec4(1));
}

}  // namespace
}  // namespace alidade
