// SPDX-License-Identifier: Apache-2.0
/// Pictures that come from POV-Ray's scenes stay pictures where they lie on texture coordinates.
#include "exporters/picture_patterns.h"

#include "exporters/exporter.h"
#include "importers/importer.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

PatternSignal image_map() {
    PatternSignal out;
    out.pattern = kImageMap, out.uv_mapped = true, out.picture = PatternPicture();
    out.picture->image = ImageId{0}, out.picture->code = PictureCode::srgb, out.picture->filter = PictureFilter::bilinear;
    return out;
}

Warp moved(const Transform& by) {
    Warp out;
    out.transform = by;
    return out;
}

/// POV-Ray moves the picture, v upwards; a texture's transform moves the coordinates, v downwards.
TEST(PicturePatterns, TransformsAreThoseOfTheCoordinates) {
    PatternSignal pattern = image_map();
    pattern.warps = {moved(Transform::scale({0.5, 0.25, 1})), moved(Transform::translate({0.1, 0.2, 0}))};
    const auto texture = as_texture(pattern, {});
    ASSERT_TRUE(texture);
    for (const Vec2& at : {Vec2(0, 0), Vec2(0.3, 0.8), Vec2(-1, 2)}) {
        const Vec3 got = texture->uv_transform * Vec3(at.x, at.y, 1);
        const double v = 1 - at.y;
        EXPECT_NEAR(got.x, (at.x - 0.1) / 0.5, 1e-14);
        EXPECT_NEAR(1 - got.y, (v - 0.2) / 0.25, 1e-14);
    }
    EXPECT_EQ(texture->filter, Filter::linear);
    EXPECT_TRUE(texture->srgb);
}

TEST(PicturePatterns, WhatIsNoTextureStaysAPattern) {
    const auto refused = [](const auto& change) {
        PatternSignal pattern = image_map();
        change(pattern);
        return !as_texture(pattern, {});
    };
    EXPECT_FALSE(refused([](PatternSignal&) {}));
    EXPECT_TRUE(refused([](PatternSignal& p) { p.uv_mapped = false; }));
    EXPECT_TRUE(refused([](PatternSignal& p) { p.turbulence.amount = Vec3(0.1); }));
    EXPECT_TRUE(refused([](PatternSignal& p) { p.picture->map = PictureMap::spherical; }));
    EXPECT_TRUE(refused([](PatternSignal& p) { p.picture->code = PictureCode::stored; }));
    EXPECT_TRUE(refused([](PatternSignal& p) { p.picture->clearings = {{std::nullopt, 0, 0.5}}; }));
    EXPECT_TRUE(refused([](PatternSignal& p) { p.warps = {moved(Transform()), Warp{WarpKind::turbulence, {}, {}}}; }));
}

const ImageSignal* picture_of(const Scene& scene, SignalId id) {
    const auto& what = scene.signals[id.index].what;
    if (const auto* product = std::get_if<ProductSignal>(&what)) {
        const ImageSignal* first = picture_of(scene, product->a);
        return first ? first : picture_of(scene, product->b);
    }
    return std::get_if<ImageSignal>(&what);
}

/// The textures that the materials of `scene` show, by their transforms: sorted.
std::vector<std::string> textures(const Scene& scene) {
    std::vector<std::string> out;
    for (const Material& material : scene.materials)
        for (const auto& layer : material.layers)
            if (const auto* pbr = std::get_if<GltfPbr>(&layer))
                if (const ImageSignal* picture = picture_of(scene, pbr->base_color)) {
                    const Mat3& m = picture->uv_transform;
                    out.push_back(fmt::format("{:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}", m[0][0], m[0][1], m[1][0], m[1][1], m[2][0], m[2][1]));
                }
    std::sort(out.begin(), out.end());
    return out;
}

TEST(PicturePatterns, AnImageMapOnAMeshSurvivesTheWayToGltf) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("alidade_picture_patterns_{}", std::random_device{}());
    std::filesystem::create_directories(folder);
    const std::string pov = (folder / "a.pov").string(), glb = (folder / "b.glb").string();
    const auto scene = import_scene(ASSETS "/scenes/materials.glb");
    ASSERT_TRUE(scene && export_scene(scene->scene, pov));
    const auto between = import_scene(pov);
    ASSERT_TRUE(between && export_scene(between->scene, glb));
    const auto again = import_scene(glb);
    ASSERT_TRUE(again);
    EXPECT_FALSE(textures(scene->scene).empty());
    EXPECT_EQ(textures(scene->scene), textures(again->scene));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace alidade
