// SPDX-License-Identifier: Apache-2.0
/// Textures of the scene language -> materials and signals.
#include "scene/queries.h"
#include "tests/importers/pov_builders.h"

#include <cmath>
#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;

TEST_F(PovBuilders, ATextureLiesInTheSpaceWhereItStands) {
    const Scene s = scene("sphere { 0, 1 translate x texture { pigment { rgb 1 } } translate y }");
    const Node& outer = s.nodes.at(s.roots.at(0).index);
    ASSERT_EQ(outer.children.size(), 1u);
    EXPECT_TRUE(outer.materials.at(0));
    expect_near(outer.to_parent.translation, {0, 1, 0});
    const Node& inner = s.nodes.at(outer.children[0].index);
    EXPECT_TRUE(inner.materials.empty());
    expect_near(inner.to_parent.translation, {1, 0, 0});
}

TEST_F(PovBuilders, WhatATextureLeavesOutComesFromTheDefaultsBeforeIt) {
    const std::string text = "#declare A = texture { pigment { rgb 1 } }\n#default { finish { ambient .7 } }\n#declare B = texture { pigment { rgb 1 } }\nsphere { 0, 1 texture { A } } sphere { 0, 2 texture { B } } sphere { 0, 3 }";
    const Scene s = scene(text);
    std::vector<double> ambients;
    for (const NodeId root : s.roots)
        if (const auto& m = s.nodes[root.index].materials; !m.empty()) ambients.push_back(std::get<PovFinish>(s.materials.at(m[0]->index).layers.at(0)).ambient.x);
    EXPECT_EQ(ambients, (std::vector<double>{0.1, 0.7, 0.7}));
}

TEST_F(PovBuilders, SettingsDependOnTheVersion) {
    EXPECT_TRUE(scene("sphere { 0, 1 }").settings.srgb_coded) << "an old scene is not corrected at all";
    EXPECT_TRUE(scene("#version 3.6; sphere { 0, 1 }").settings.filter_dims_by_colour);
    const RenderSettings now = scene("#version 3.7; global_settings { max_trace_level 9 adc_bailout .1 ambient_light rgb 2 }").settings;
    EXPECT_FALSE(now.srgb_coded || now.filter_dims_by_colour || now.default_light);
    EXPECT_EQ(now.assumed_gamma, 1);
    EXPECT_EQ(now.max_depth, 8);
    EXPECT_EQ(now.adc_bailout, 0.1);
    EXPECT_EQ(now.shadow_clearance, 0.001);
    EXPECT_EQ(now.ambient_light.y, 2);
    EXPECT_EQ(scene("#version 3.6; global_settings { assumed_gamma 2.2 }").settings.assumed_gamma, 2.2);
    const std::string twice = "#version 3.6; global_settings { assumed_gamma 2.2 } global_settings { assumed_gamma 1 }";
    EXPECT_EQ(scene(twice).settings.assumed_gamma, 2.2) << "the first holds";
    EXPECT_THAT(said(twice), HasSubstr("assumed_gamma was given before"));
}

TEST_F(PovBuilders, LevelsAndFogsOfOldScenes) {
    for (const char* text : {"max_trace_level 9", "#max_trace_level 3*3", "global_settings { max_trace_level 2 } max_trace_level 9", "max_trace_level 2 sphere { 0, 1 } global_settings { max_trace_level 9 }"})
        EXPECT_EQ(scene(text).settings.max_depth, 8) << text;
    EXPECT_EQ(said("max_intersections 64 sphere { 0, 1 }"), "");
    for (const char* fog : {"color red .5 12", "12 color rgb .5", "rgb .5 3 distance 12", "rgb .5 distance 3 12"}) {
        const Scene read = scene(std::string("fog { ") + fog + " }");
        ASSERT_EQ(read.atmosphere.fogs.size(), 1u) << fog;
        EXPECT_EQ(read.atmosphere.fogs[0].distance, 12) << fog;
        EXPECT_EQ(read.atmosphere.fogs[0].color.x, .5) << fog;
    }
}

TEST_F(PovBuilders, AFogThatSpeaksOfTurbulenceHasIt) {
    const auto has = [&](const std::string& words) { return scene("fog { distance 9 " + words + " }").atmosphere.fogs.at(0).turbulence.has_value(); };
    for (const char* words : {"turbulence 0", "turbulence .2", "octaves 6", "omega .5", "lambda 2"}) EXPECT_TRUE(has(words)) << words;
    for (const char* words : {"", "turb_depth 1", "up x fog_type 2"}) EXPECT_FALSE(has(words)) << words;
    EXPECT_TRUE(scene("#declare F = fog { distance 9 octaves 3 } fog { F rgb x }").atmosphere.fogs.at(0).turbulence.has_value());
}

/// For each layer of the last material that has several, from the bottom up: is it marked as uncoloured?
std::string marks(const Scene& scene) {
    std::string out;
    for (const Material& m : scene.materials) {
        if (m.layers.size() < 2) continue;
        out.clear();
        for (const auto& layer : m.layers) out += std::get<PovFinish>(layer).uncolored ? '1' : '0';
    }
    return out;
}

/// By what POV-Ray lets through `plane { z, 0 A B }` and the like: up to version 3.1 a layer that is put over another colours nothing. It matters where it is put there, in an object, in a
/// declaration of textures or of a material; maps and meshes take textures as they are.
TEST_F(PovBuilders, UpToVersion31LayersOverTheLowestColourNothing) {
    const std::string a = "texture { pigment { rgbf <.8,1,.6,.8> } } ", b = "texture { pigment { rgbf <1,.5,.7,.5> } } ", c = "texture { pigment { rgbft <.3,1,1,.5,.3> } } ";
    const std::string old = "\n#version 3.1; ", now = "\n#version 3.6; ", t = "#declare T = " + a + b, in_z = "plane { z, 0 ", m = "#declare M = material { " + a + b + "} ";
    const auto of = [&](const std::string& text) { return marks(scene(text)); };
    EXPECT_EQ(of(old + in_z + a + b + c + "}"), "011");
    EXPECT_EQ(of("#version 3.0; " + in_z + a + b + "}" + now), "01") << "whatever the version is at the end";
    for (const char* version : {"3.11", "3.4", "3.5", "3.7"}) EXPECT_EQ(of(fmt::format("#version {}; ", version) + in_z + a + b + "}"), "00") << version;
    EXPECT_EQ(of(old + t + now + in_z + "texture { T } }"), "01") << "declared";
    EXPECT_EQ(of(now + t + old + in_z + "texture { T } }"), "01") << "or used";
    EXPECT_EQ(of(now + t + old + "#declare U = texture { T }" + now + in_z + "texture { U } }"), "01") << "or declared again";
    EXPECT_EQ(of(old + t + now + in_z + "texture { T } " + c + "}"), "010");
    EXPECT_EQ(of(now + t + old + in_z + "texture { T } " + c + "}"), "011");
    EXPECT_EQ(of(now + t + old + in_z + c + "texture { T } }"), "011");
    EXPECT_EQ(of(now + in_z + a + b + old + c + "}"), "001");
    EXPECT_EQ(of(old + m + now + in_z + "material { M } }"), "01");
    EXPECT_EQ(of(now + m + old + in_z + "material { M } }"), "01");
    EXPECT_EQ(of(now + m + old + "#declare N = material { M } " + now + in_z + "material { N } }"), "01");
    const std::string mesh = "mesh { triangle { <-9,-9,0>, <9,-9,0>, <0,19,0> texture { T } } }";
    EXPECT_EQ(of(old + t + now + mesh), "01");
    EXPECT_EQ(of(now + t + old + mesh), "00");
    EXPECT_EQ(of(old + "#declare O = " + in_z + a + b + "} " + now + "object { O }"), "01");
    EXPECT_EQ(of(now + "#declare O = " + in_z + "} " + old + "object { O " + a + b + "}"), "01");
}

/// POV-Ray draws `pigment { rgb C scale 2 }` as C, and what moves a plain colour moves a pattern that takes its place.
TEST_F(PovBuilders, APlainColourKeepsItsModifiersForAPattern) {
    const auto pigment = [&](const std::string& text) {
        const Scene s = scene(text);
        const auto* finish = s.materials.empty() ? nullptr : std::get_if<PovFinish>(&s.materials.back().layers.front());
        return finish ? s.signals.at(finish->pigment.index) : Signal();
    };
    const Signal colour = pigment("sphere { 0, 1 pigment { rgb <1,.5,.2> scale 2 turbulence .4 frequency 2 } }");
    const auto* plain = std::get_if<ConstantSignal>(&colour.what);
    ASSERT_TRUE(plain);
    EXPECT_LT(length(Vec3(plain->value) - Vec3(1, 0.5, 0.2)), 1e-7);
    for (const char* text : {"sphere { 0, 1 texture { scale .5 pigment { gradient x } } }", "sphere { 0, 1 texture { pigment { rgb 1 scale .5 } pigment { gradient x } } }",
                             "#declare P = pigment { rgb 1 scale .5 } sphere { 0, 1 pigment { P gradient x } }", "#default { pigment { rgb 1 scale .5 } } sphere { 0, 1 pigment { gradient x } }",
                             "#declare T = texture { pigment { rgb 1 } scale .5 } sphere { 0, 1 texture { T pigment { gradient x } } }"}) {
        const Signal gradient = pigment(text);
        const auto* pattern = std::get_if<PatternSignal>(&gradient.what);
        ASSERT_TRUE(pattern) << text;
        ASSERT_EQ(pattern->warps.size(), 1u) << text;
        EXPECT_EQ(pattern->warps[0].transform.linear[0][0], 0.5) << text;
    }
}

/// POV-Ray takes them below version 3.0, and draws what it draws of the blocks.
TEST_F(PovBuilders, WordsOfOldTexturesStandForBlocks) {
    const std::string old = "#version 2.0\nsphere { <0 0 0> 1 texture { ";
    const auto same = [&](const std::string& words, const std::string& blocks) {
        const auto surfaces = [](Scene s) {
            for (Signal& each : s.signals) each.from = {};
            for (Material& each : s.materials) each.from = {};
            s.nodes.clear(), s.roots.clear(), s.files.clear();
            return dump(s);
        };
        EXPECT_EQ(surfaces(scene(old + words + " } }")), surfaces(scene(old + blocks + " } }"))) << words;
        EXPECT_EQ(said(old + words + " } }"), "") << words;
    };
    same("color red 1 phong 1 phong_size 20", "pigment { color red 1 } finish { phong 1 phong_size 20 }");
    same("checker color red 1 color green 1", "pigment { checker color red 1 color green 1 }");
    same("0.3 wood turbulence .5 color_map { [0 1 color red 1 color green 1] } scale <.3 .3 .3>", "finish { crand .3 } pigment { wood ramp_wave turbulence .5 color_map { [0 1 color red 1 color green 1] } } scale <.3 .3 .3>");
    same("color red 1 waves .4 frequency 3 phase .2 ambient .3", "pigment { color red 1 } normal { waves .4 frequency 3 phase .2 } finish { ambient .3 }");
    for (const char* crand : {"0.05 color red 1 ambient .3 scale 2", "color red 1 0.05 ambient .3 scale 2", "color red 1 ambient .3 0.05 scale 2", "color red 1 ambient .3 scale 2 0.05"})
        same(crand, "pigment { color red 1 } finish { ambient .3 crand .05 } scale 2");
    same("gradient <0 1 0> 0.05 color_map { [0 1 color red 1 color green 1] }", "pigment { gradient <0 1 0> } finish { crand .05 } pigment { color_map { [0 1 color red 1 color green 1] } }");
    same("onion 0.05 turbulence .5 0.1", "pigment { onion } finish { crand .05 } pigment { turbulence .5 } finish { crand .1 }");
    same("color red 1 bumps .3 0.1", "pigment { color red 1 } normal { bumps .3 } finish { crand .1 }");
    same("color red 1 color green 1", "pigment { color green 1 }");
    same("pigment { color red 1 } bumps .4", "pigment { color red 1 } normal { bumps .4 }");
    EXPECT_THAT(said("#version 3.0; sphere { 0, 1 texture { color red 1 phong 1 } }"), HasSubstr("error: a value means nothing here in texture"));
    EXPECT_THAT(said("#version 3.0; sphere { 0, 1 texture { phong 1 } }"), HasSubstr("error: phong cannot stand in texture"));
}

/// POV-Ray refuses srgb before assumed_gamma, and shows .5 as 128 of 255 wherever it stands behind it.
TEST_F(PovBuilders, SrgbStandsBehindAssumedGamma) {
    const auto ambient = [&](const char* gamma) { return scene(fmt::format("#version 3.7; global_settings {{ assumed_gamma {} ambient_light srgb .5 }} sphere {{ 0, 1 }}", gamma)).settings.ambient_light.x; };
    const double linear = std::pow((0.5 + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(ambient("1"), linear, 1e-6);
    EXPECT_NEAR(ambient("2.2"), std::pow(linear, 1 / 2.2), 1e-6);
    EXPECT_NEAR(ambient("srgb"), 0.5, 1e-6);
    EXPECT_THAT(said("#version 3.7; global_settings { ambient_light srgb .5 assumed_gamma 1 }"), HasSubstr("s.pov:1:52: error: a colour in sRGB stands before assumed_gamma"));
    EXPECT_THAT(said("sphere { 0, 1 pigment { srgb .5 } }"), HasSubstr("error: a colour in sRGB stands before assumed_gamma"));
}

TEST_F(PovBuilders, AnImageMapIsAPattern) {
    write("a.png", ""), write("a.tif", "");
    const Scene s = scene("#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 texture { uv_mapping pigment { image_map { png \"a.png\" map_type 2 interpolate 3 once filter 2, .5 transmit all .25 } scale 2 } } }\n"
                          "sphere { 0, 1 pigment { image_map { png \"a.png\" gamma srgb } } normal { bump_map { tiff \"a.tif\" bump_size 2 use_index } } }");
    EXPECT_EQ(s.images.size(), 2u) << "each file once";
    const auto& first = std::get<PovFinish>(s.materials.at(0).layers.at(0)), second = std::get<PovFinish>(s.materials.at(1).layers.at(0));
    const auto& map = std::get<PatternSignal>(s.signals.at(first.pigment.index).what);
    EXPECT_EQ(map.pattern, kImageMap);
    EXPECT_TRUE(map.uv_mapped);
    EXPECT_EQ(map.warps.size(), 1u);
    PatternPicture want;
    want.image = ImageId{0}, want.map = PictureMap::cylindrical, want.filter = PictureFilter::bicubic, want.once = true, want.code = PictureCode::told_or_srgb;
    want.clearings = {{2, 0.5, {}}, {{}, {}, 0.25}};
    EXPECT_EQ(*map.picture, want);
    EXPECT_EQ(std::get<PatternSignal>(s.signals.at(second.pigment.index).what).picture->code, PictureCode::srgb);
    const auto& relief = std::get<ReliefSignal>(s.signals.at(second.normal->index).what);
    EXPECT_EQ(relief.amount, 2);
    EXPECT_EQ(relief.pattern.picture->value, PictureValue::palette);
    EXPECT_EQ(relief.pattern.picture->code, PictureCode::stored);
}

TEST_F(PovBuilders, MeshesHaveTextureCoordinatesAndTexturesThatAreMixed) {
    const std::string corners = "mesh2 { vertex_vectors { 3, 0, x, y } uv_vectors { 2, <.25, .125>, <1, 0> } face_indices { 1, <0, 1, 2> } ";
    const auto mesh_in = [&](const std::string& text) { return std::get<Mesh>(scene(text).shapes.at(0).geometry); };
    const Mesh indexed = mesh_in(corners + "uv_indices { 1, <0, 1, 1> } }");
    EXPECT_EQ(indexed.uvs.at(0).values, (std::vector<Vec2f>{{0.25f, 0.875f}, {1, 1}})) << "v grows downwards here";
    EXPECT_EQ(indexed.uvs.at(0).corners, (std::vector<uint32_t>{0, 1, 1}));
    EXPECT_THAT(said(corners + "}"), HasSubstr("error: there are 2 uv_vectors for 3 vertices: uv_indices are missing"));
    EXPECT_THAT(said(corners + "uv_indices { 1, <0, 1, 2> } }"), HasSubstr("error: there is no vector 2: the mesh has 2"));
    const std::string textures = "#declare A = texture { pigment { rgb x } } #declare B = texture { pigment { rgb y } }\n";
    const Mesh mixed = mesh_in(textures + "mesh { triangle { 0, x, y } triangle { 0, x, y uv_vectors <1, 0>, <0, 1>, <1, 1> texture_list { A B A } } triangle { 0, x, z texture { B } } }");
    EXPECT_EQ(mixed.slots, (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(mixed.corner_slots, (std::vector<uint32_t>{0, 0, 0, 1, 2, 1, 2, 2, 2}));
    EXPECT_EQ(mixed.uvs.at(0).values.size(), 9u);
    EXPECT_THAT(said(textures + "mesh { triangle { 0, x, y texture_list { A B } } }"), HasSubstr("2:27: error: the texture_list of a triangle has three textures"));
}

TEST_F(PovBuilders, MapsOfColours) {
    const Scene s = scene("#declare M = color_map { [.5 rgb x] }\nsphere { 0, 1 pigment { bozo color_map { [0 .25 color rgb 0 color rgb 1] M } scale 2 translate x } }");
    const auto& pattern = std::get<PatternSignal>(s.signals.at(std::get<PovFinish>(s.materials.at(0).layers.at(0)).pigment.index).what);
    ASSERT_EQ(pattern.map.size(), 3u);
    EXPECT_EQ(pattern.map[1].value, .25);
    EXPECT_EQ(std::get<ConstantSignal>(s.signals.at(pattern.map[2].signal.index).what).value, Vec4(1, 0, 0, 1));
    ASSERT_EQ(pattern.warps.size(), 1u) << "one map for both transformations";
    expect_near(pattern.warps[0].transform.point(Vec3(0, 1, 0)), {1, 2, 0});
}

/// Each declaration has the one before it twice: as many paths as no machine has room for.
TEST_F(PovBuilders, MapsOfMapsAreStoredOnce) {
    std::string pigments = "#declare P0 = pigment { rgb 1 }\n", textures = "#declare T0 = texture { pigment { rgb 1 } }\n", normals = "#declare N0 = normal { bumps 1 }\n";
    for (int i = 1; i <= 60; ++i) {
        pigments += fmt::format("#declare P{0} = pigment {{ bozo pigment_map {{ [.5 P{1}] [.5 P{1}] }} }}\n", i, i - 1);
        textures += fmt::format("#declare T{0} = texture {{ bozo texture_map {{ [.5 T{1}] [.5 T{1}] }} }}\n", i, i - 1);
        normals += fmt::format("#declare N{0} = normal {{ bozo normal_map {{ [.5 N{1}] [.5 N{1}] }} }}\n", i, i - 1);
    }
    const Scene s = scene(pigments + textures + normals + "sphere { 0, 1 pigment { P60 } normal { N60 } } sphere { 0, 1 texture { T60 } }");
    EXPECT_LT(s.signals.size(), 1000u);
    EXPECT_LT(s.materials.size(), 200u);
}

}  // namespace
}  // namespace alidade
