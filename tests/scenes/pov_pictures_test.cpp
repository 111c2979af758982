// SPDX-License-Identifier: Apache-2.0
/// Small scenes rendered by POV-Ray and by Alidade: the 8-bit codes must be the same, but for the few pixels where an edge goes through a centre.
#include "core/image.h"
#include "importers/importer.h"
#include "tests/povray/povray.h"
#include "tracer/render.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

constexpr int kWidth = 64, kHeight = 48;

struct PovPicture {
    const char* name;
    std::string scene;
    const char* words = "-A";                          ///< POV-Ray's antialiasing
    std::optional<Supersampling> supersampling = {};   ///< and ours
};

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.1,.2,.3> }\n";
const std::string kView = "camera { location <0,2,-6> look_at <0,.5,0> angle 50 }\n";
const std::string kSun = "light_source { <10,20,-15> rgb <1,.9,.8> }\n";

/// A camera of some kind in the middle of things.
std::string around(const std::string& camera) {
    std::string scene = kHead + "camera { " + camera + " location <.2,1,-1> look_at <0,.8,4> }\nlight_source { <1,6,-2> rgb 1 }\nplane { y, 0 pigment { rgb <.4,.6,.3> } }\n";
    for (int i = 0; i < 8; ++i) scene += fmt::format("sphere {{ <0,{},4>, .9 rotate y*{} pigment {{ rgb <{},{},1> }} }}\n", 0.5 * (i % 4), 45 * i, 0.1 * i, 1 - 0.1 * i);
    return scene;
}

/// Things on a plane in the light of `light`.
std::string lit_by(const std::string& light) {
    return kHead + "camera { location <0,6,-8> look_at <0,0,0> angle 40 } plane { y, 0 pigment { rgb 1 } } sphere { <0,1.5,0>, .7 pigment { rgb <1,.6,.2> } finish { phong 1 } } "
                   "box { <-2,0,-1>, <-1,1.5,0> pigment { rgb <.3,.6,1> } } " + light;
}

std::string area_light(const std::string& words) { return lit_by("light_source { <3,8,-4> rgb 1.5 area_light <3,0,0>, <0,.5,3>, " + words + " }"); }

/// Edges of all kinds: of objects, of patterns, and those that are too faint for a threshold of 0.3.
const std::string kEdges = kHead + kView + kSun + "sphere { <0,.5,0>, 1 pigment { checker rgb 1 rgb <1,.2,0> scale .3 } finish { phong 3 phong_size 90 } } plane { y, -.5 pigment { checker rgb .3 rgb .8 scale .7 } } "
                           "box { -.2, .2 rotate 40 translate <-1.5,0,-1> pigment { rgbt <1,0,0,.3> } }";

std::vector<PovPicture> light_pictures() {
    const std::string usual = kHead + "camera { location <0,6,-8> look_at <0,0,0> angle 40 } plane { y, 0 pigment { rgb .6 } } sphere { <0,1,0>, .8 pigment { rgb 1 } finish { phong 1 } } ";
    return {
        {"AreaLight", area_light("3, 3")},
        {"AreaLightAdaptive", area_light("7, 6 adaptive 0")},
        {"AreaLightTransformed", lit_by("union { light_source { 0 rgb 1 area_light <3,0,0>, <0,0,3>, 4, 4 adaptive 1 rotate x*30 scale <1,2,1> } rotate z*20 scale 1.3 translate <2,6,-4> }")},
        {"AreaLightCircular", area_light("6, 6 adaptive 1 circular")},
        {"AreaLightOriented", area_light("5, 5 circular orient")},
        {"AreaLightThroughGlass", area_light("5, 5 adaptive 1") + " sphere { <-1,2,-2>, .5 pigment { rgbf <1,.4,.2,.9> } }"},
        {"AreaSpotlight", lit_by("light_source { <3,8,-4> rgb 2 spotlight radius 15 falloff 25 point_at 0 area_light <3,0,0>, <0,0,3>, 9, 9 adaptive 0 }")},
        {"AreaParallel", lit_by("light_source { <3,8,-4> rgb 1 parallel point_at 0 area_light <3,0,0>, <0,0,3>, 6, 6 adaptive 1 }")},
        {"AreaFadingCylinder", lit_by("light_source { <3,8,-4> rgb 1 cylinder radius 3 falloff 4 point_at 0 area_light <1,0,0>, <0,0,1>, 5, 5 fade_distance 5 fade_power 1 }")},
        {"AreaLightDim", lit_by("global_settings { ambient_light 0 } light_source { <3,8,-4> rgb .1 area_light <3,0,0>, <0,0,3>, 9, 9 adaptive 0 }")},
        {"AreaIllumination", usual + "light_source { <3,3,-1> rgb 1 fade_distance 3 fade_power 2 area_light <6,0,0>, <0,0,3>, 5, 5 adaptive 1 area_illumination }"},
        {"AreaIlluminationOfASpotlight", usual + "light_source { <3,3,-1> rgb 1 spotlight radius 20 falloff 50 point_at 0 area_light <6,0,0>, <0,0,3>, 5, 5 area_illumination }"},
        {"CylinderLight", lit_by("light_source { <3,8,-4> rgb 1 cylinder radius 1 falloff 2.5 tightness 1.5 point_at 0 }")},
        {"CylinderLightTransformed", lit_by("light_source { <3,8,-4> rgb 1 cylinder radius 1 falloff 2 point_at 0 scale 1.3 rotate y*20 }")},
        {"CylinderLightFading", lit_by("light_source { <3,8,-4> rgb 1 cylinder radius 3 falloff 4 point_at 0 fade_distance 6 fade_power 2 }")},
        {"LightGroup", usual + "light_source { <-5,9,-5> rgb .5 } light_group { light_source { <3,8,-4> rgb 1 } sphere { <0,2.5,-1>, .5 pigment { rgb <1,.5,.2> } } box { <1.5,0,-1>, <2.5,1,0> pigment { rgb 1 } } translate x*.2 }"},
        {"LightGroupWithGlobalLights", usual + "light_source { <-5,9,-5> rgb .5 } light_group { light_source { <3,8,-4> rgb 1 } sphere { <0,2.5,-1>, .5 pigment { rgb <1,.5,.2> } } global_lights on } light_group { light_source { <0,9,0> rgb <.5,.5,0> } "
                                       "box { <1.5,0,-1>, <2.5,1,0> pigment { rgb 1 } } }"},
        {"LightGroupInALightGroup", usual + "light_source { <-5,9,-5> rgb .5 } light_group { light_source { <3,8,-4> rgb 1 } light_group { light_source { <0,9,0> rgb <.5,.5,0> } sphere { <0,2.5,-1>, .5 pigment { rgb <1,.5,.2> } } "
                                    "global_lights on } box { <1.5,0,-1>, <2.5,1,0> pigment { rgb 1 } } }"},
        {"ParallelFromTheMiddle", lit_by("light_source { <0,.7,-4> rgb 1 parallel spotlight radius 10 falloff 15 tightness 2 point_at <0,0,-3> fade_distance 3 fade_power 1 }")},
    };
}

std::vector<PovPicture> sampled_pictures() {
    std::vector<PovPicture> out;
    out.push_back({"GridAntialias", kEdges, "+A0.3 +AM1 +R3 -J", Supersampling{}});
    out.push_back({"GridAntialiasOfFaintEdges", kEdges, "+A0.05 +AM1 +R2 -J", Supersampling{.threshold = 0.05, .depth = 2}});
    out.push_back({"CornerAntialias", kEdges, "+A0.3 +AM2 +R3 -J", Supersampling{.method = 2}});
    out.push_back({"CornerAntialiasOfFaintEdges", kEdges, "+A0.05 +AM2 +R4 -J", Supersampling{.method = 2, .threshold = 0.05, .depth = 4}});
    out.push_back({"AntialiasOfCodedColours", "camera { location <0,2,-6> look_at <0,.5,0> angle 50 }\n" + kSun + "sphere { <0,.5,0>, 1 pigment { checker rgb 1 rgb <1,.2,0> scale .3 } } plane { y, -.5 pigment { checker rgb .3 rgb .8 scale .7 } }",
                   "+A0.3 +AM1 +R3 -J", Supersampling{}});
    return out;
}

std::vector<PovPicture> pictures() {
    const std::string usual = kHead + kView + kSun, sphere = "sphere { <0,.5,0>, 2 ";
    return {
        {"Solids", usual + "box { -1, 1 scale .6 rotate y*30 translate <2,.6,0> pigment { rgb 1 } } torus { 1.2 .15 translate <0,.15,-1.5> pigment { rgb .9 } } cone { <1,0,-2.5>, .4 <1,1,-2.5>, .1 open pigment { rgb "
                           "<.9,.9,.1> } } cylinder { <-1,0,-2.5>, <-1.5,.8,-2.2>, .2 pigment { rgb .5 } } disc { <0,2,0>, <0,1,-1>, .6, .3 pigment { rgb <.3,.3,1> } } plane { <0,2,0>, -1 pigment { rgb .4 } }"},
        {"Finish", usual + sphere + "texture { pigment { rgb <1,.2,.1> } finish { ambient .2 diffuse .5 brilliance 2.5 phong .8 phong_size 30 metallic .5 } } }"},
        {"Specular", usual + sphere + "pigment { rgb <.2,1,.1> } finish { specular .8 roughness .02 metallic emission .1 } }"},
        {"Albedo", usual + sphere + "pigment { rgb <.4,.6,.8> } finish { diffuse albedo .6 brilliance 3 specular albedo .2 roughness .1 } }"},
        {"Reflections", usual + "plane { y, -1 pigment { rgb .6 } finish { reflection .3 } } " + sphere + "scale .5 pigment { rgb <.9,.7,.2> } finish { reflection { .1, .8 falloff 3 metallic .7 } } }"},
        {"TraceLevels", kHead + "global_settings { max_trace_level 3 }" + kView + kSun + "#default { pigment { rgb <.3,.5,.4> } finish { reflection .9 } } plane { y, -1 } sphere { <-1.2,.5,0>, 1.1 } sphere { <1.2,.5,0>, 1.1 }"},
        {"Glass", usual + "plane { y, -2 pigment { rgb <.7,.8,.3> } } " + sphere + "pigment { rgbft <.8,.9,1,.6,.2> } interior { ior 1.5 } finish { conserve_energy reflection { .0, 1 fresnel } specular .5 } }"},
        {"FadedGlass", usual + sphere + "pigment { rgbt <1,1,1,.9> } interior { ior 1.2 fade_distance 1 fade_power 2 fade_color <.8,.2,.1> } }"},
        {"Caustics", usual + "plane { y, -2 pigment { rgb .6 } } sphere { <0,1,0>, 1 texture { pigment { rgbf <1,.6,.3,.8> } } texture { pigment { rgbt <.9,.9,1,.6> } } interior { ior 1.3 caustics .4 } }"},
        {"ColouredShadows", usual + "plane { y, -2 pigment { rgb 1 } } sphere { <0,1,0>, 1 pigment { rgbf <1,.3,.2,.8> } } sphere { <2,1,0>, .6 pigment { rgb 1 } no_shadow }"},
        {"Layers", usual + sphere + "texture { pigment { rgb <.2,.3,1> } finish { reflection .2 phong .6 } } texture { pigment { rgbft <1,.6,.2,.4,.3> } finish { ambient .3 specular .5 } } }"},
        {"OldVersion", "camera { location <0,2,-6> look_at <0,.5,0> angle 50 right -1.2*x }\n" + kSun + "background { rgb .4 } " + sphere + "pigment { rgbft <.5,.8,.9,.5,.1> } }"},
        {"Gamma22", "#version 3.6; global_settings { assumed_gamma 2.2 ambient_light <2,1,.5> }" + kView + kSun + sphere + "pigment { rgb <.5,.7,.6> } }"},
        {"Spotlights", kHead + kView + "light_source { <5,8,-6> rgb 1.2 spotlight radius 12 falloff 22 tightness 3 point_at 0 fade_distance 8 fade_power 2 } light_source { <-5,4,-6> rgb <.2,.3,.6> parallel point_at "
                             "0 } light_source { <0,9,0> rgb .2 shadowless } plane { y, -1 pigment { rgb .7 } finish { phong .5 } } sphere { 0, .8 pigment { rgb 1 } finish { phong 1 } }"},
        {"Orthographic", kHead + "camera { orthographic location <1,3,-6> look_at 0 angle 40 rotate y*10 sky <1,3,0> }" + kSun + "box { -1, 1 pigment { rgb <.9,.5,.3> } }"},
        {"Fisheye", around("fisheye angle 220 right x up y")},
        {"UltraWide", around("ultra_wide_angle angle 160 right 1.5*x up y")},
        {"Omnimax", around("omnimax right x up y")},
        {"OmnimaxWide", around("omnimax right 1.6*x up y")},
        {"Panoramic", around("panoramic angle 150")},
        {"Cylinder1", around("cylinder 1 angle 200")},
        {"Cylinder2", around("cylinder 2 angle 120")},
        {"Cylinder3", around("cylinder 3 angle 200 up 2*y")},
        {"Cylinder4", around("cylinder 4 angle 120 right 2*x")},
        {"SphericalWithBothAngles", around("spherical angle 200 60")},
        {"Spherical", around("spherical")},
        {"SphericalPart", around("spherical angle 200")},
        {"References", usual + "#declare S = sphere { 0, .5 }\n#declare T = texture { pigment { rgb <0,1,0> } finish { phong .5 } }\nunion { object { S translate x } object { S translate -x texture { T } } sphere { z, .6 "
                             "scale <1,2,1> rotate z*30 } pigment { rgb <1,.5,0> } finish { phong 1 } translate y*.3 } object { S scale 2 translate y*2 } #default { texture { pigment { rgb 1 } } } object { S translate <0,-.5,-2> }"},
        {"Meshes", usual + "#declare R = texture { pigment { rgb <1,0,0> } }\nmesh { triangle { <-2,-1,0>, <0,-1,0>, <-1,1,0> texture { R } } smooth_triangle { <0,-1,0>, <-1,0,-2>, <2,-1,0>, <1,0,-1>, <1,1,0>, <0,1,-1> } pigment { rgb <.6,.2,.6> } } "
                         "mesh2 { vertex_vectors { 4, <-2,1,0>, <-1,1,0>, <-1,2,0>, <-2,2,0> } normal_vectors { 4, <-1,-1,-3>, <0,0,-2>, <.1,0,-.1>, <0,.5,-.5> } texture_list { 2, texture { pigment { rgb <1,1,0> } }, texture { "
                         "pigment { rgb <0,1,1> } finish { phong 1 } } } face_indices { 2, <0,1,2>, 0, <0,2,3>, 1 } }"},
        {"Visibility", usual + "plane { y, -1 pigment { rgb .5 } finish { reflection .5 } } union { sphere { <-1,.5,0>, .7 } sphere { <1,.5,0>, .7 no_reflection } pigment { rgb <1,.5,.2> } no_image } box { <-.3,-.5,-.3>, .3 no_reflection pigment { rgb 1 } }"},
        {"OpaqueFresnel", usual + "plane { y, -1 pigment { rgb <.8,.7,.5> } finish { reflection { .05, .4 fresnel } } interior { ior 1.4 } } sphere { y*.5, .8 pigment { rgb <.2,.5,1> } finish { reflection { .9 fresnel } } interior { ior 1.6 } }"},
        {"DoubleIlluminate", usual + "disc { 0, z, 2 pigment { rgb 1 } rotate y*70 double_illuminate } disc { <2,0,0>, z, 1 pigment { rgb <1,1,0> } finish { diffuse .6, .3 } rotate y*60 }"},
    };
}

class Folder {
  public:
    Folder() : path_(std::filesystem::temp_directory_path() / fmt::format("alidade_pov_pictures_{}", std::random_device{}())) { std::filesystem::create_directories(path_); }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string operator/(const char* name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

std::optional<Picture> ours(const std::string& path, const std::string& out, const std::optional<Supersampling>& supersampling, std::string& why) {
    ImportOptions options;
    options.frame.image_width = kWidth, options.frame.image_height = kHeight;
    auto imported = import_scene(path, options);
    if (!imported) return why = imported.error().text(), std::nullopt;
    why = imported->diagnostics.text();
    Diagnostics said;
    const auto compiled = compile(std::move(imported->scene), {}, said);
    why += said.text();
    if (!compiled) return std::nullopt;
    RenderOptions render_options;
    render_options.width = kWidth, render_options.height = kHeight, render_options.threads = 1;
    render_options.supersampling = supersampling;
    auto film = render(*compiled, render_options);
    if (!film || !write_picture(out, film->picture)) return std::nullopt;
    auto read = read_picture(out, Encoding::linear);
    return read ? std::optional(std::move(*read)) : std::nullopt;
}

int code(const Picture& p, int x, int y, int c) { return int(std::lround(p.at(x, y)[c] * 255)); }

class PovPictures : public testing::TestWithParam<PovPicture> {};

TEST_P(PovPictures, AreThoseOfPovRay) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const Folder folder;
    std::ofstream(folder / "scene.pov") << GetParam().scene << "\n";
    ASSERT_EQ(std::system(fmt::format("cd '{}' && povray +Iscene.pov +Oref.png +W{} +H{} {} -D +WT1 > said.txt 2>&1", folder / "", kWidth, kHeight, GetParam().words).c_str()), 0);
    const auto theirs = read_picture(folder / "ref.png", Encoding::linear);
    ASSERT_TRUE(theirs);
    std::string said;
    const auto own = ours(folder / "scene.pov", folder / "own.png", GetParam().supersampling, said);
    ASSERT_TRUE(own) << said;
    EXPECT_EQ(said, "") << "nothing in the scene is left out";
    int differ = 0, seen = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            int most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(code(*own, x, y, c) - code(*theirs, x, y, c)));
            differ += most > 1;
            seen += code(*theirs, x, y, 0) != code(*theirs, 0, 0, 0);
        }
    EXPECT_GT(seen, 100) << "the picture shows something";
    EXPECT_LE(differ, kWidth * kHeight / 200) << "pixels that differ by more than one step of 255";
}

INSTANTIATE_TEST_SUITE_P(Lights, PovPictures, testing::ValuesIn(light_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Antialiasing, PovPictures, testing::ValuesIn(sampled_pictures()), [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(All, PovPictures, testing::ValuesIn(pictures()), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace alidade
