// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tests/scene/sample_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace alidade {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

std::vector<std::string> names(const Scene& scene) {
    std::vector<std::string> out;
    for (const RequiredBy& r : requirements(scene)) out.push_back(name(r.what));
    return out;
}

TEST(Requirements, OfTheSampleScene) {
    EXPECT_THAT(names(test::sample_scene()),
                ElementsAre("textures", "normal maps", "vertex colors", "media", "fog", "point lights", "environment", "csg", "clipping", "instances",
                            "analytic shapes", "unbounded shapes", "meshes", "animation", "skins", "morphs", "patterns", "functions"));
    EXPECT_TRUE(requirements(Scene()).empty());
}

TEST(Requirements, EachHasItsOwnName) {
    std::set<std::string> all;
    for (int i = 0; i <= int(Requirement::functions); ++i) all.insert(name(Requirement(i)));
    EXPECT_EQ(all.size(), size_t(Requirement::functions) + 1);
}

TEST(Requirements, CountsAndNamesTheFirstPlace) {
    Scene s = test::sample_scene();
    s.nodes[4].what = ShapeId{3};
    s.nodes[4].skin = SkinId{0};
    s.nodes[4].from = {0, 0, 0, "/nodes/4"};
    for (const RequiredBy& r : requirements(s)) {
        if (r.what != Requirement::skins) continue;
        EXPECT_EQ(r.count, 2u);
        EXPECT_EQ(r.first.pointer, "/nodes/1");
    }
}

/// What no root reaches, or what is hidden, is not required.
TEST(Requirements, OnlyWhatIsReached) {
    Scene s = test::sample_scene();
    s.nodes[1].flags.visible = false;
    std::get<PatternSignal>(s.signals[4].what).map[1].signal = SignalId{1};
    EXPECT_THAT(names(s), Not(Contains("meshes")));
    EXPECT_THAT(names(s), Not(Contains("skins")));
    EXPECT_THAT(names(s), Not(Contains("animation")));
    EXPECT_THAT(names(s), Contains("textures")) << "a map of the other material reads the image too";
    s.roots.clear();
    EXPECT_THAT(names(s), ElementsAre("textures", "media", "fog", "environment", "patterns")) << "of the sky and the air";
}

TEST(Requirements, OcclusionIsNotRead) {
    Scene s = test::scene_of({test::node_with(ShapeId{0})});
    s.images = {{"ao", "ao.png", {}, {}}};
    s.signals.resize(2);
    s.signals[1].what = ImageSignal();
    GltfPbr g;
    g.occlusion = SignalId{1};
    s.materials.resize(1);
    s.materials[0].layers = {g};
    s.nodes[0].materials = {MaterialId{0}};
    EXPECT_THAT(names(s), ElementsAre("analytic shapes"));
    std::get<GltfPbr>(s.materials[0].layers[0]).emissive = SignalId{1};
    EXPECT_THAT(names(s), ElementsAre("textures", "emission", "analytic shapes"));
}

struct Use {
    const char* required;
    void (*ask)(Scene&);
};

using test::gltf;
using test::pov;

/// Each changes the sample scene, which does not require it before.
const Use kUses[] = {
    {"alpha mask", [](Scene& s) { gltf(s).alpha_mode = AlphaMode::mask; }},
    {"alpha blend", [](Scene& s) { gltf(s).alpha_mode = AlphaMode::blend; }},
    {"emission", [](Scene& s) { gltf(s).emissive = SignalId{0}; }},
    {"emission", [](Scene& s) { pov(s).emission = Color(1); }},
    {"mirror", [](Scene& s) { pov(s).reflection_max = Color(1); }},
    {"mirror", [](Scene& s) { gltf(s).roughness = SignalId{uint32_t(s.signals.size())}; s.signals.push_back({ConstantSignal{Vec4(0)}, {}}); }},
    {"transmission", [](Scene& s) { gltf(s).transmission = SignalId{0}; }},
    {"transmission", [](Scene& s) { pov(s).pigment = SignalId{uint32_t(s.signals.size())}; s.signals.push_back({ConstantSignal{Vec4(1), 0.5, 0}, {}}); }},
    {"transmission", [](Scene& s) { pov(s).pigment = SignalId{uint32_t(s.signals.size())}; s.signals.push_back({ImageSignal(), {}}); }},
    {"absorption", [](Scene& s) { s.interiors[0].fade_distance = 2; }},
    {"absorption", [](Scene& s) { s.interiors[0].attenuation_distance = 1; }},
    {"spot lights", [](Scene& s) { s.lights[0].kind = SpotLight(); }},
    {"directional lights", [](Scene& s) { s.lights[0].kind = DirectionalLight(); }},
    {"area lights", [](Scene& s) { s.lights[0].kind = AreaLight(); }},
    {"mirrored instances", [](Scene& s) { s.nodes[0].to_parent = Transform::scale({-1, 1, 1}); }},
    {"depth of field", [](Scene& s) { s.cameras[0].aperture = 1; }},
    {"orthographic", [](Scene& s) { s.cameras[0].projection = Projection::orthographic; }},
};

TEST(Requirements, EachUseIsFound) {
    for (const Use& use : kUses) {
        Scene s = test::sample_scene();
        EXPECT_THAT(names(s), Not(Contains(use.required)));
        use.ask(s);
        EXPECT_THAT(names(s), Contains(use.required));
    }
}

TEST(Requirements, ConstantZeroIsNoUse) {
    Scene s = test::sample_scene();
    s.signals.push_back({ConstantSignal{Vec4(0, 0, 0, 1)}, {}});
    gltf(s).transmission = gltf(s).emissive = SignalId{uint32_t(s.signals.size() - 1)};
    EXPECT_THAT(names(s), Not(Contains("transmission")));
    EXPECT_THAT(names(s), Not(Contains("emission")));
}

/// Mirrored twice is not mirrored; a node reached on both kinds of path is.
TEST(Requirements, MirroringIsCountedAlongThePath) {
    std::vector<Node> nodes(3);
    nodes[0].children = {NodeId{1}};
    nodes[1].children = {NodeId{2}};
    nodes[2].what = ShapeId{0};
    nodes[0].to_parent = nodes[1].to_parent = Transform::scale({1, -1, 1});
    Scene s = test::scene_of(nodes);
    EXPECT_THAT(names(s), ElementsAre("analytic shapes"));
    s.roots = {NodeId{0}, NodeId{1}};
    EXPECT_THAT(names(s), ElementsAre("instances", "mirrored instances", "analytic shapes"));
}

}  // namespace
}  // namespace alidade
