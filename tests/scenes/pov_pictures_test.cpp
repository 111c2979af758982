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

std::vector<PovPicture> pictures() {
    const std::string usual = kHead + kView + kSun, sphere = "sphere { <0,.5,0>, 2 ";
    return {
        {"Solids", usual + "box { -1, 1 scale .6 rotate y*30 translate <2,.6,0> pigment { rgb 1 } } torus { 1.2 .15 translate <0,.15,-1.5> pigment { rgb .9 } } cone { <1,0,-2.5>, .4 <1,1,-2.5>, .1 open pigment { rgb "
                           "<.9,.9,.1> } } cylinder { <-1,0,-2.5>, <-1.5,.8,-2.2>, .2 pigment { rgb .5 } } disc { <0,2,0>, <0,1,-1>, .6, .3 pigment { rgb <.3,.3,1> } } plane { <0,2,0>, -1 pigment { rgb .4 } }"},
        {"Quadrics", usual + "quadric { <4,1,4>, <0,0,0>, <0,0,0>, -1 translate <-2,.5,0> pigment { rgb <1,.6,.2> } } quadric { <1,-.5,1>, <0,.4,0>, <.1,0,0>, .4 scale .6 rotate z*40 translate <.2,.9,3> pigment { rgb <.3,.8,.4> } } "
                             "quadric { <6,0,6>, <1,0,0>, <0,1,0>, -1.5 translate <2,0,0> pigment { rgb <.4,.4,1> } } quadric { <1,0,1>, <0,0,0>, <0,0,0>, -1 scale .15 rotate z*85 translate y*2.6 pigment { rgb .8 } }"},
        {"QuarticCubic", usual + "quartic { <1,0,0,0,2,0,0,2,0,-1.45, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1.05, 0,0,0,0, 1,0,-1.45,0,.275625> scale 1.2 rotate x*-50 translate <-.5,.7,0> pigment { rgb <.9,.8,.3> } finish { phong .6 } } "
                                 "cubic { <1,0,0,0,0,0,0,-3,0,0, 0,0,0,-1,0,0,0,0,0,0> scale .8 rotate x*20 translate <0,-1.8,1> pigment { rgb <.3,.6,.9> } }"},
        {"Poly6", usual + "poly { 6, <1,0,0,0,3,0,0,6.75,0,-3,0,0,0,0,0,0,0,0,0,0,3,0,-1,13.5,0,-6,0,0,0,0,15.1875,0,-13.5,0,3,0,0,0,0,0,0,"
                          "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,6.75,0,-3,0,-0.1125,0,0,15.1875,0,-13.5,0,3,0,0,0,0,0,0,11.390625,0,-15.1875,0,6.75,0,-1> scale 1.4 rotate y*-25 translate y*.5 pigment { rgb <1,.3,.35> } finish { specular .5 } }"},
        {"Polygon", usual + "polygon { 15, <0,0>, <3,0>, <3,3>, <0,3>, <0,0>, <.5,.5>, <2.5,.5>, <1,2.5>, <.5,.5>, <2,2>, <2.8,2>, <2.8,2.8>, <2.5,2.2>, <2,2.8>, <2,2> translate <-1.5,-1,0> rotate <20,35,10> pigment { rgb <.9,.7,.2> } }"},
        {"Texts", usual + "text { ttf \"timrom.ttf\" \"AVog&\" .4, 0 scale 1.2 translate <-2,1.2,0> pigment { rgb <1,.7,.2> } finish { phong .7 } } text { ttf \"cyrvetic.ttf\" \"Ray8\" 1, <.05,.03,0> rotate y*25 translate <-2,-.1,0> pigment { rgb <.3,.8,.4> } } "
                          "text { ttf \"crystal.ttf\" \"a%B\" .02, .1*x rotate x*30 translate <-.5,-1.5,0> pigment { rgb .9 } } text { internal 4 \"P\" .3, 0 translate <1.2,-.6,0> pigment { rgb <.6,.6,1> } }"},
        {"Finish", usual + sphere + "texture { pigment { rgb <1,.2,.1> } finish { ambient .2 diffuse .5 brilliance 2.5 phong .8 phong_size 30 metallic .5 } } }"},
        {"Specular", usual + sphere + "pigment { rgb <.2,1,.1> } finish { specular .8 roughness .02 metallic emission .1 } }"},
        {"Albedo", usual + sphere + "pigment { rgb <.4,.6,.8> } finish { diffuse albedo .6 brilliance 3 specular albedo .2 roughness .1 } }"},
        {"Reflections", usual + "plane { y, -1 pigment { rgb .6 } finish { reflection .3 } } " + sphere + "scale .5 pigment { rgb <.9,.7,.2> } finish { reflection { .1, .8 falloff 3 metallic .7 } } }"},
        {"TraceLevels", kHead + "global_settings { max_trace_level 3 }" + kView + kSun + "#default { pigment { rgb <.3,.5,.4> } finish { reflection .9 } } plane { y, -1 } sphere { <-1.2,.5,0>, 1.1 } sphere { <1.2,.5,0>, 1.1 }"},
        {"Glass", usual + "plane { y, -2 pigment { rgb <.7,.8,.3> } } " + sphere + "pigment { rgbft <.8,.9,1,.6,.2> } interior { ior 1.5 } finish { conserve_energy reflection { .0, 1 fresnel } specular .5 } }"},
        {"FadedGlass", usual + sphere + "pigment { rgbt <1,1,1,.9> } interior { ior 1.2 fade_distance 1 fade_power 2 fade_color <.8,.2,.1> } }"},
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

std::optional<Picture> ours(const std::string& path, const std::string& out, std::string& why) {
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
    ASSERT_EQ(std::system(fmt::format("cd '{}' && povray +Iscene.pov +Oref.png +W{} +H{} -A -D +WT1 > said.txt 2>&1", folder / "", kWidth, kHeight).c_str()), 0);
    const auto theirs = read_picture(folder / "ref.png", Encoding::linear);
    ASSERT_TRUE(theirs);
    std::string said;
    const auto own = ours(folder / "scene.pov", folder / "own.png", said);
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

INSTANTIATE_TEST_SUITE_P(All, PovPictures, testing::ValuesIn(pictures()), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace alidade
