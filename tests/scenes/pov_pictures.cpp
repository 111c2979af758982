// SPDX-License-Identifier: Apache-2.0
#include "tests/scenes/pov_pictures.h"

#include "tests/core/draw.h"

#include <fmt/format.h>

namespace alidade::test {

namespace {

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.1,.2,.3> }\n";
const std::string kView = "camera { location <0,2,-6> look_at <0,.5,0> angle 50 }\n";
const std::string kSun = "light_source { <10,20,-15> rgb <1,.9,.8> }\n";

/// A camera of some kind in the middle of things.
std::string around(const std::string& camera) {
    std::string scene = kHead + "camera { " + camera + " location <.2,1,-1> look_at <0,.8,4> }\nlight_source { <1,6,-2> rgb 1 }\nplane { y, 0 pigment { rgb <.4,.6,.3> } }\n";
    for (int i = 0; i < 8; ++i) scene += fmt::format("sphere {{ <0,{},4>, .9 rotate y*{} pigment {{ rgb <{},{},1> }} }}\n", 0.5 * (i % 4), 45 * i, 0.1 * i, 1 - 0.1 * i);
    return scene;
}

/// A camera of the language 3.1, whose words act in their order.
std::string old_camera(const std::string& words) {
    return "#version 3.1; global_settings { assumed_gamma 1 } camera { " + words + " } background { rgb <.1,.2,.3> } sphere { 0, 1 pigment { checker rgb 1 rgb <1,0,0> scale .5 } finish { ambient 1 diffuse 0 } } "
           "plane { y, -1 pigment { checker rgb .2 rgb <0,0,1> } finish { ambient 1 diffuse 0 } }";
}

/// A camera at <0,2,-6> in fog, with a bare ground and something.
std::string in_fog(const std::string& things, const std::string& camera = "location <0,2,-6> look_at <0,.5,0> angle 50") {
    return kHead + "camera { " + camera + " } fog { distance 8 rgb <.8,.8,.9> } " + kSun + "plane { y, -1 pigment { checker rgb 1 rgb <1,0,0> scale .7 } hollow }\n" + things;
}

/// A wall in a fog with these words.
std::string unlit_wall(const std::string& words) {
    return kHead + "camera { location 0 look_at <0,.2,1> angle 60 } plane { -z, -20 hollow pigment { checker rgb 1 rgb <.2,.5,1> scale 3 } finish { ambient 1 diffuse 0 } } fog { distance 30 rgb <.4,.2,.1> " + words + " }";
}

/// Twelve things in three rows, seen from the front: `thing` with the I-th of the declared list T.
std::string twelve(const std::string& type, const std::string& list, const std::string& thing) {
    return kHead + "camera { orthographic location -10*z look_at 0 right 8*x up 6*y } light_source { <10,20,-30> rgb 1 }\n#declare T = array[12] { " + list + " }\n#for (I, 0, 11) " + thing +
           " { T[I] } finish { phong .3 } translate <mod(I,4)*2-3, 2-2*int(I/4), 0> } #end" + (type.empty() ? "" : "\n" + type);
}

}  // namespace

std::vector<PovPicture> patterned_pictures() {
    const std::string head = kHead + "camera { location -10*z+y*3 look_at 0 right 8/6*x up y angle 45 } light_source { <10,20,-30> rgb 1 }\n";
    const std::string textures = "#declare A = texture { pigment { rgb <1,.5,.2> } finish { phong 1 } }\n#declare B = texture { pigment { granite scale .3 } normal { bumps 1 scale .1 } finish { specular .4 } }\n"
                                 "#declare G = texture { pigment { rgbt <1,1,1,.8> } finish { reflection .1 } }\n"
                                 "#declare L = texture { pigment { rgb z } normal { bumps .4 scale .3 } finish { reflection .3 } } texture { pigment { checker rgbt <1,0,0,.7> rgbt <0,1,0,.3> scale .3 } normal { waves "
                                 ".5 scale .2 } finish { phong .5 reflection .2 } scale 1.5 }\n";
    return {
        {"Pigments", twelve("", "pigment { bozo scale .3 }, pigment { marble turbulence 1 scale .5 }, pigment { granite color_map { [0 rgb x] [1 rgb y] } }, pigment { wood turbulence .1 scale .2 }, pigment { agate scale .3 "
                                "}, pigment { checker rgb 1, rgb <1,0,0> scale .25 }, pigment { brick scale .1 }, pigment { hexagon rotate x*90 scale .2 }, pigment { gradient <1,1,0> triangle_wave color_map { [0 .5 color "
                                "rgb 0 color rgb <1,1,0>] [.5 1 color rgb 1 color rgb z] } }, pigment { crackle scale .3 }, pigment { radial frequency 6 }, pigment { leopard scale .1 pigment_map { [0 bozo scale .1] [.5 rgb "
                                "1] } warp { turbulence .3 } }", "box { -.9, .9 pigment")},
        {"MorePigments", twelve("", "pigment { spiral1 3 scale .4 }, pigment { spiral2 5 turbulence .2 scale .3 poly_wave 2 }, pigment { mandel 20 translate x*.3 }, pigment { julia <.35,.28>, 30 exterior 2, 3 interior 1, 4 }, "
                                    "pigment { magnet 2 mandel 12 scale .4 }, pigment { quilted control0 .3 control1 .2 scale .4 }, pigment { square scale .3 }, pigment { cubic rotate 20 }, pigment { cells scale .3 noise_generator 1 }, "
                                    "pigment { average pigment_map { [1 bozo scale .2] [2 rgb x] [1 checker scale .3] } }, pigment { wrinkles noise_generator 3 scale .2 sine_wave frequency 2 phase .3 }, pigment { onion warp { "
                                    "black_hole <.3,.2,-.9>, .6 strength .7 falloff 1.5 } warp { repeat x*.5 flip x } scale .6 }", "box { -.9, .9 pigment")},
        {"FrequencyOfBlocks", twelve("", "pigment { checker frequency 2 phase .3 scale .4 }, pigment { brick frequency 2 phase .3 sine_wave scale .1 }, pigment { hexagon frequency 1.3 cubic_wave scale .4 }, pigment { square frequency 3 scale .3 }, "
                                         "pigment { triangular frequency .3 phase .1 scale .3 }, pigment { cubic frequency .3 scallop_wave rotate 20 }, pigment { quilted frequency 3 scale .4 }, pigment { quilted frequency -1.5 phase .2 triangle_wave scale .4 }, "
                                         "pigment { checker phase .4 scale .4 }, pigment { quilted phase .4 scale .4 }, pigment { brick frequency -1.5 scallop_wave scale .1 }, pigment { hexagon rgb x rgb y rgb z frequency 2 scale .4 }", "box { -.9, .9 pigment")},
        {"SlopeMapsOfReliefs", kHead + kView + kSun + "#declare S = slope_map { [0 <0,1>] [.5 <1,0>] [1 <0,-1>] } sphere { -1.2*x, 1 pigment { rgb 1 } normal { bumps 1 slope_map { S } scale .3 } } sphere { 1.2*x, 1 pigment { rgb 1 } normal { quilted 1 slope_map { S } scale .3 } } plane { y, -1 pigment { rgb 1 } normal { ripples 1 slope_map { S } } }"},
        {"Normals", twelve("sky_sphere { pigment { gradient y color_map { [0 rgb <.6,.7,1>] [1 rgb <.1,.2,.8>] } } pigment { bozo turbulence .6 color_map { [.4 rgbt 1] [.8 rgbt <1,1,1,.2>] } scale .3 } rotate x*20 }",
                           "normal { bumps .6 scale .2 }, normal { dents 1 scale .3 }, normal { wrinkles .8 scale .5 }, normal { ripples .7 frequency 4 }, normal { quilted 1 scale .5 }, normal { granite .3 scale 2 }, normal { "
                           "facets coords .4 size .3 }, normal { gradient x .8 slope_map { [0 <0,1>] [.5 <1,0>] [1 <0,-1>] } scale .3 }, normal { checker normal { bumps 1 scale .1 } normal { ripples 1 frequency 20 } scale .5 "
                           "}, normal { bozo normal_map { [.3 bumps 1 scale .1] [.6 dents 2 scale .2] } scale .5 }, normal { average normal_map { [1 bumps 1 scale .1] [2 waves 1 scale .1] } }, normal { crackle -.5 scale "
                           "<.5,1,.3> no_bump_scale bump_size 1.5 accuracy .01 }", "sphere { 0, .9 pigment { rgb <1,.8,.6> } finish { reflection .2 } rotate y*20 normal")},
        {"TextureMaps", head + textures + "plane { y, -4 texture { checker texture { A } texture { B } scale 2 rotate y*20 } } sphere { <-3,1,0>, 1.2 texture { gradient y texture_map { [.2 A] [.8 B scale .3] } scale .5 } } "
                        "sphere { <0,1,0>, 1.2 texture { bozo texture_map { [.3 A] [.5 G] [.7 L] } scale .4 turbulence .4 } } sphere { <3,1,0>, 1.2 texture { L } } sphere { <-2,-2,0>, 1.2 texture { average texture_map "
                        "{ [1 A] [2 B] [.5 L] } rotate 30 scale <1,.5,2> } } box { <1,-3,-1>, <3,-1,1> texture { brick texture { A } texture { B } scale .2 } rotate y*30 }"},
        {"PigmentPatterns", head + textures + "#declare P = pigment { bozo pigment_map { [.4 wrinkles scale .5] [.6 leopard scale .2] } turbulence .3 } sphere { <-3,0,0>, 2 pigment { P } normal { pigment_pattern { P } 5 } } sphere { <3,0,0>, 2 pigment { "
                            "pigment_pattern { P scale .5 } color_map { [0 rgb x] [1 rgb <1.5,1,0>] } rotate 20 frequency 2 } } box { -1, 1 texture { pigment_pattern { P } texture_map { [.4 pigment { rgb 1 }] [.6 A] } } } box { "
                            "-1, 1 translate 3*y pigment { rgb .9 } normal { brick normal { pigment_pattern { checker rgb 1 rgb <1,.5,0> scale .1 } .5 } normal { bumps } scale .2 } }"},
        {"Materials", head + textures + "#declare M = material { texture { checker texture { A } texture { L rotate 30 } } interior { ior 1.2 } rotate 20*z scale .5 } sphere { <-3,0,0>, 2 material { M } } sphere { <3,0,0>, 1 material { M translate "
                      "<.3,.2,0> } scale 2 } box { -1, 1 material { M scale .5 } rotate <20,30,0> } sphere { <0,-3,0>, 1 material { texture { pigment { checker rgb 1 rgb 0 } } texture { G } scale .4 } }"},
        {"Fog", head + "fog { distance 60 color rgbft <.7,.7,.7,.3,.2> } fog { fog_type 2 distance 20 color rgb <.9,.8,.7> fog_offset -3 fog_alt 1 turbulence .5 } plane { y, -4 pigment { checker rgb 1 rgb .3 } finish { reflection .3 } } "
                       "sphere { 0, 2 pigment { rgb x } } sphere { <3,0,4>, 2 pigment { rgb y } }"},
        {"OldSky", "#version 3.6; global_settings { assumed_gamma 1 } background { rgb <.2,.4,.6> } camera { location 0 look_at <.3,.4,1> }\nsky_sphere { pigment { gradient y color_map { [0 rgbft <.5,.6,.7,.2,.3>] [1 rgb 1] } } "
                   "pigment { granite color_map { [0 rgbft <.9,.8,.3,.4,.1>] [1 rgbt <1,.2,.2,.5>] } } scale .7 }"},
        {"DefaultPigment", head + "#default { pigment { checker rgb 1, rgb z scale .5 } normal { bumps .5 scale .3 } } sphere { 0, 2 } sphere { x*3, 1 pigment { rgb x } } box { <-4,-1,-1>, <-2,1,1> texture { pigment { rotate y*30 } } }"},
    };
}

namespace {

std::string random_vector(Draw& draw) { return fmt::format("<{:.3f},{:.3f},{:.3f}>", draw(-1, 1), draw(-1, 1), draw(-1, 1)); }

/// Set operations on closed and open forms, with colours, transformations and clips anywhere. (Operations are not inverted: POV-Ray gives those wrong boxes.)
std::string random_solid(Draw& draw, int levels) {
    static constexpr const char* kShapes[] = {"sphere { 0, 1", "box { <-.9,-.7,-.6>, <.8,.9,.7>", "cylinder { -1.2*y, y, .6 ", "cone { -y, .9, y, .3 open", "torus { .9, .4", "cylinder { -1.5*y, 1.5*y, .5 open"};
    static constexpr const char* kOperations[] = {"union", "merge", "intersection", "difference"};
    std::string out;
    if (levels == 0) out = kShapes[draw.below(6)];
    else out = fmt::format("{} {{ {} {}", kOperations[draw.below(4)], random_solid(draw, levels - 1), random_solid(draw, levels - 1 - int(draw.below(2)) * (levels > 1)));
    if (levels == 0 && draw.below(8) == 0) out += " inverse";
    if (draw.below(3) == 0) out += fmt::format(" pigment {{ rgb <{:.2f},{:.2f},{:.2f}> }}", draw(0, 1), draw(0, 1), draw(0, 1));
    if (draw.below(8) == 0) out += " clipped_by { plane { " + random_vector(draw) + ", .3 } }";
    return out + " rotate " + random_vector(draw) + "*90 translate " + random_vector(draw) + "*.4 }\n";
}

std::string random_solids(uint64_t seed) {
    Draw draw(seed);
    std::string scene = kHead + kView + kSun + "#default { pigment { rgb <1,.6,.3> } } plane { y, -2 pigment { rgb <.6,.7,.4> } }\n";
    for (int i = 0; i < 4; ++i) scene += fmt::format("intersection {{ {} sphere {{ 0, 1.6 }} scale .8 translate <{},{},{}> }}\n", random_solid(draw, 3), i % 2 ? 1.3 : -1.3, i / 2 * 1.6 - .6, i / 2);
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

}  // namespace

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

std::vector<PovPicture> fog_pictures() {
    const std::string air = "pigment { rgbt 1 } finish { ambient 0 diffuse 0 } ";
    return {
        {"FogOutsideOfTheCamerasSphere", in_fog("sphere { <0,2,-6>, 3 " + air + "}")},
        {"FogInAHollowSphere", in_fog("sphere { <0,2,-6>, 3 " + air + "hollow }")},
        {"FogUnderAPlane", in_fog("plane { y, 30 pigment { rgb <.1,.2,.3> } finish { ambient 1 diffuse 0 reflection .3 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }")},
        {"FogUnderAHollowPlane", in_fog("plane { y, 30 hollow pigment { rgb <.1,.2,.3> } finish { ambient 1 diffuse 0 reflection .3 } }")},
        {"FogAndPartsOfAUnion", in_fog("union { sphere { <0,2,-6>, 2 } sphere { <0,2,-6>, 3 hollow } " + air + "}")},
        {"FogAndTheLastPartOfAUnion", in_fog("union { sphere { <0,2,-6>, 2 hollow } sphere { <1,1,2>, 1 } " + air + "}")},
        {"FogInAShell", in_fog("difference { sphere { <0,2,-6.7>, 2 } sphere { <0,2,-8>, 1 } " + air + "} difference { sphere { <0,0,0>, 1 } sphere { <.2,.2,-.4>, .8 } " + air + "}")},
        {"FogAndAnOrthographicCamera", in_fog("sphere { <0,2,-6>, 1 " + air + "}", "orthographic location <0,2,-6> look_at <0,.5,0> right 4*x up 3*y")},
        {"FogAndAnInverseSphere", in_fog("sphere { <0,2,-6>, 40 inverse pigment { rgb <.3,.2,.6> } } sphere { 0, 1 pigment { rgb 1 } }")},
        {"FogBehindHollowGlass", in_fog("sphere { 0, 1 pigment { rgbf <.9,1,.8,.8> } hollow interior { ior 1.4 } } sphere { <2,0,1>, 1 pigment { rgbf <.9,1,.8,.8> } interior { ior 1.4 } } merge { sphere { <-2,0,0>, .8 } sphere { <-2,1,0>, .6 } " + air + "}")},
        {"FogWithTurbulenceOfNothing", unlit_wall("turbulence 0")},
        {"FogWithOctavesAlone", unlit_wall("octaves 3 turb_depth .8")},
        {"FogWithADepthOfTurbulenceAlone", unlit_wall("turb_depth .8")},
        {"GroundFogWithOmegaAlone", unlit_wall("fog_type 2 fog_offset -3 fog_alt 2 omega .7")},
    };
}

std::vector<PovPicture> old_cameras() {
    return {
        {"OldCameraLooksFirst", old_camera("look_at <0,.3,1> location <1,1,-6>")},
        {"OldCameraAngleFirst", old_camera("location <0,1,-6> angle 40 right 2*x look_at <.5,0,0> up <0,2,0>")},
        {"OldCameraMoves", old_camera("location <0,1,-6> rotate y*20 right x look_at <.3,0,0> angle 50 rotate x*4 location <0,2,-6>")},
        {"OldCameraOrthographicFirst", old_camera("orthographic right 4*x up 3*y location <0,1,-6> look_at 0 angle 40 rotate y*20")},
        {"OldCameraOrthographicLast", old_camera("location <0,1,-6> right 2*x look_at 0 angle 40 translate -z rotate y*20 orthographic")},
        {"OldCameraOrthographicLastAndBlind", old_camera("location <0,.5,-2> direction <0,-.2,2> orthographic")},
        {"OldCameraFisheyeBehindItsAngle", old_camera("location <0,1,-3> look_at 0 angle 120 fisheye")},
        {"OldCameraDeclared", "#version 3.5; #declare C = camera { look_at <0,.3,1> angle 40 right 2*x location <1,1,-6> }" + old_camera("C location <0,2,-6>")},
    };
}

std::vector<PovPicture> other_pictures() {
    const std::string usual = kHead + kView + kSun, sphere = "sphere { <0,.5,0>, 2 ";
    const std::string old = "#version 3.0; global_settings { assumed_gamma 1 } background { rgb <.1,.2,.3> }" + kView + kSun, clear = "pigment { rgbf <.9,1,.8,.8> }";
    return {
        {"Solids", usual + "box { -1, 1 scale .6 rotate y*30 translate <2,.6,0> pigment { rgb 1 } } torus { 1.2 .15 translate <0,.15,-1.5> pigment { rgb .9 } } cone { <1,0,-2.5>, .4 <1,1,-2.5>, .1 open pigment { rgb "
                           "<.9,.9,.1> } } cylinder { <-1,0,-2.5>, <-1.5,.8,-2.2>, .2 pigment { rgb .5 } } disc { <0,2,0>, <0,1,-1>, .6, .3 pigment { rgb <.3,.3,1> } } plane { <0,2,0>, -1 pigment { rgb .4 } }"},
        {"Quadrics", usual + "quadric { <4,1,4>, <0,0,0>, <0,0,0>, -1 translate <-2,.5,0> pigment { rgb <1,.6,.2> } } quadric { <1,-.5,1>, <0,.4,0>, <.1,0,0>, .4 scale .6 rotate z*40 translate <.2,.9,3> pigment { rgb <.3,.8,.4> } } "
                             "quadric { <6,0,6>, <1,0,0>, <0,1,0>, -1.5 translate <2,0,0> pigment { rgb <.4,.4,1> } } quadric { <1,0,1>, <0,0,0>, <0,0,0>, -1 scale .15 rotate z*85 translate y*2.6 pigment { rgb .8 } }"},
        {"QuadricsBetweenPlanes", usual + "union { intersection { plane { y, 1 } quadric { <1,-1,1>, 0, 0, -.1 scale <.5,1,.5> } plane { -y, .8 } } intersection { plane { y, 0 inverse } quadric { <1,0,1>, 0, <0,-.5,0>, 0 } plane { y, .9 } translate "
                                          "<-2,.3,0> } difference { intersection { quadric { <1,0,0>, 0, 0, -.3 } quadric { <0,1,0>, 0, 0, -.3 } quadric { <0,0,1>, 0, 0, -.3 } } quadric { <1,1,0>, 0, 0, -.1 } rotate 30 translate <2,.8,0> } pigment { rgb <1,.7,.4> } "
                                          "rotate y*20 } intersection { plane { y, -1 } plane { -y, 1.5 } plane { -z, 1 } plane { <-1,0,1>, 2 } plane { <1,0,1>, 2 } pigment { rgb .5 } }"},
        {"LightsOnSurfaces", kHead + kView + "light_source { <-1,1,0> rgb .7 } light_source { <1.5,.7,-2> rgb .5 spotlight point_at 0 } light_source { <0,2,0> rgb <.4,.4,1> area_light x*.5, z*.5, 3, 3 } plane { y, -1 pigment { rgb 1 } } plane { y, 1 inverse "
                                     "pigment { rgb <1,.5,.5> } clipped_by { box { <-3,0,-1>, <-1,2,1> } } } sphere { <1.5,.7,-1>, 1 pigment { rgb <.5,1,.5> } } box { <-.5,2,-.5>, <.5,2.1,.5> pigment { rgb 1 } } sphere { <0,0,0>, .5 pigment { rgb 1 } }"},
        {"RoughGlass", usual + "plane { y, -2 pigment { checker rgb 1 rgb <.3,.5,.7> } } box { <-2,-1,-2>, <2,.5,2> pigment { rgbf .95 } normal { bumps .3 scale .2 } interior { ior 1.5 } rotate y*30 }"},
        {"QuarticCubic", usual + "quartic { <1,0,0,0,2,0,0,2,0,-1.45, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1.05, 0,0,0,0, 1,0,-1.45,0,.275625> scale 1.2 rotate x*-50 translate <-.5,.7,0> pigment { rgb <.9,.8,.3> } finish { phong .6 } } "
                                 "cubic { <1,0,0,0,0,0,0,-3,0,0, 0,0,0,-1,0,0,0,0,0,0> scale .8 rotate x*20 translate <0,-1.8,1> pigment { rgb <.3,.6,.9> } }"},
        {"Poly6", usual + "poly { 6, <1,0,0,0,3,0,0,6.75,0,-3,0,0,0,0,0,0,0,0,0,0,3,0,-1,13.5,0,-6,0,0,0,0,15.1875,0,-13.5,0,3,0,0,0,0,0,0,"
                          "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,6.75,0,-3,0,-0.1125,0,0,15.1875,0,-13.5,0,3,0,0,0,0,0,0,11.390625,0,-15.1875,0,6.75,0,-1> scale 1.4 rotate y*-25 translate y*.5 pigment { rgb <1,.3,.35> } finish { specular .5 } }"},
        {"Polygon", usual + "polygon { 15, <0,0>, <3,0>, <3,3>, <0,3>, <0,0>, <.5,.5>, <2.5,.5>, <1,2.5>, <.5,.5>, <2,2>, <2.8,2>, <2.8,2.8>, <2.5,2.2>, <2,2.8>, <2,2> translate <-1.5,-1,0> rotate <20,35,10> pigment { rgb <.9,.7,.2> } }"},
        {"PatternsAfterColours", usual + "#declare P = pigment { gradient y }\nsphere { <-2,0,0>, 1 pigment { rgb 1 } scale <1,.3,1> pigment { gradient y scale .5 rotate 40*z } scale <1,3,1> } sphere { <0,0,0>, 1 finish { phong .5 } scale <1,.4,1> "
                                         "pigment { gradient y warp { turbulence .3 } rotate 30 } scale <1,2,1> } sphere { <2,0,0>, 1 pigment { rgb 1 } scale <1,.4,1> pigment { P scale .5 } scale <1,2.5,1> }"},
        {"PolygonsOfEight", usual + "polygon { 5, <0,0,0>, <1,1,0>, <0,1,0>, <1,0,0>, <0,0,0> } polygon { 5, <0,0,0>, <-1,-1,-1>, <-1,0,-1>, <0,-1,0>, <0,0,0> pigment { rgb <.9,.7,.2> } }"},
        {"Texts", usual + "text { ttf \"timrom.ttf\" \"AVog&\" .4, 0 scale 1.2 translate <-2,1.2,0> pigment { rgb <1,.7,.2> } finish { phong .7 } } text { ttf \"cyrvetic.ttf\" \"Ray8\" 1, <.05,.03,0> rotate y*25 translate <-2,-.1,0> pigment { rgb <.3,.8,.4> } } "
                          "text { ttf \"crystal.ttf\" \"a%B\" .02, .1*x rotate x*30 translate <-.5,-1.5,0> pigment { rgb .9 } } text { internal 4 \"P\" .3, 0 translate <1.2,-.6,0> pigment { rgb <.6,.6,1> } }"},
        {"Finish", usual + sphere + "texture { pigment { rgb <1,.2,.1> } finish { ambient .2 diffuse .5 brilliance 2.5 phong .8 phong_size 30 metallic .5 } } }"},
        {"Specular", usual + sphere + "pigment { rgb <.2,1,.1> } finish { specular .8 roughness .02 metallic emission .1 } }"},
        {"Irid", kHead + kView + kSun + "global_settings { irid_wavelength <.75,.5,.45> } " + sphere + "pigment { rgb <.4,.6,.8> } finish { phong .5 reflection .3 irid { .4 thickness .7 } } } plane { y, -2 pigment { rgb 1 } finish { irid { .3 thickness .2 turbulence 1 } } }"},
        {"Albedo", usual + sphere + "pigment { rgb <.4,.6,.8> } finish { diffuse albedo .6 brilliance 3 specular albedo .2 roughness .1 } }"},
        {"Reflections", usual + "plane { y, -1 pigment { rgb .6 } finish { reflection .3 } } " + sphere + "scale .5 pigment { rgb <.9,.7,.2> } finish { reflection { .1, .8 falloff 3 metallic .7 } } }"},
        {"TraceLevels", kHead + "global_settings { max_trace_level 3 }" + kView + kSun + "#default { pigment { rgb <.3,.5,.4> } finish { reflection .9 } } plane { y, -1 } sphere { <-1.2,.5,0>, 1.1 } sphere { <1.2,.5,0>, 1.1 }"},
        {"Glass", usual + "plane { y, -2 pigment { rgb <.7,.8,.3> } } " + sphere + "pigment { rgbft <.8,.9,1,.6,.2> } interior { ior 1.5 } finish { conserve_energy reflection { .0, 1 fresnel } specular .5 } }"},
        {"TotalReflectionDimmedByRefraction", usual + "background { rgb .6 } box { -1, 1 pigment { rgbf 1 } finish { ambient 0 diffuse 0 refraction .8 ior 1.8 } rotate 30*y } plane { y, -1.5 pigment { checker rgb 1 rgb x } }"},
        {"RefractionOfAFinish", old + sphere + clear + "finish { ior 1.5 refraction .7 } } plane { y, -1 pigment { checker rgb 1 rgb x } }"},
        {"InteriorOfAFinishOverOne", old + sphere + clear + "finish { ior 1.5 caustics 9 } interior { ior 1.1 caustics .9 fade_distance 1 fade_power 1 } } plane { y, -1 pigment { checker rgb 1 rgb x } }"},
        {"FinishOfTheLayerOnTop", usual + sphere + "texture { " + clear + "finish { ior 1.5 caustics 20 refraction .2 } } texture { pigment { rgbf <1,.8,.9,.7> } finish { ior 1.2 } } } plane { y, -1 pigment { checker rgb 1 rgb x } }"},
        {"FinishOfAUnion", old + "union { sphere { <-.5,.5,0>, .8 interior { ior 1.8 } } sphere { <.6,.5,0>, .7 } texture { " + clear + "finish { ior 1.3 } } } plane { y, -1 pigment { checker rgb 1 rgb x } }"},
        {"FinishesOfParts", old + "union { sphere { <-.9,.5,0>, .8 " + clear + "finish { ior 1.2 refraction .6 } } difference { sphere { <.6,.5,0>, .7 " + clear + "finish { ior 1.5 caustics 9 } } sphere { <.6,.8,-1>, .6 " + clear + "} } } plane { y, -1 pigment { checker rgb 1 rgb x } }"},
        {"FinishesInAMap", old + sphere + "texture { checker texture { " + clear + "finish { ior 1.5 } } texture { " + clear + "} scale .5 } } plane { y, -1 pigment { checker rgb 1 rgb x } }"},
        {"FadedGlass", usual + sphere + "pigment { rgbt <1,1,1,.9> } interior { ior 1.2 fade_distance 1 fade_power 2 fade_color <.8,.2,.1> } }"},
        {"Caustics", usual + "plane { y, -2 pigment { rgb .6 } } sphere { <0,1,0>, 1 texture { pigment { rgbf <1,.6,.3,.8> } } texture { pigment { rgbt <.9,.9,1,.6> } } interior { ior 1.3 caustics .4 } }"},
        {"ColouredShadows", usual + "plane { y, -2 pigment { rgb 1 } } sphere { <0,1,0>, 1 pigment { rgbf <1,.3,.2,.8> } } sphere { <2,1,0>, .6 pigment { rgb 1 } no_shadow }"},
        {"Layers", usual + sphere + "texture { pigment { rgb <.2,.3,1> } finish { reflection .2 phong .6 } } texture { pigment { rgbft <1,.6,.2,.4,.3> } finish { ambient .3 specular .5 } } }"},
        {"LayersOfVersion31", "#version 3.1; #declare A = texture { pigment { rgbf <.8,1,.6,.8> } finish { phong .5 } } #declare B = texture { pigment { rgbf <.6,.5,.2,.7> } } #declare T = texture { pigment { rgbf <.9,.3,1,.8> } } texture { pigment { "
                              "rgbft <.2,.5,1,.5,.3> } } #declare M = material { texture { A } texture { B } } sphere { <-2,1,0>, 1 texture { A } texture { B } } #version 3.6; global_settings { assumed_gamma 1 } background { rgb <.5,.6,.7> }" + kView +
                              kSun + "sphere { <0,1,1>, 1 texture { T } } sphere { <2,1,0>, 1 material { M } } sphere { <-1,.5,-2>, .5 texture { A } texture { B } } box { -.4, .4 translate <1,.5,-2> texture { gradient y texture_map { [.5 T] [1 A] } } } "
                              "plane { y, -1 pigment { rgb 1 } }"},
        {"ModifiersOfPlainColours", usual + sphere + "scale .5 pigment { rgb <1,.6,.2> scale 2 turbulence .5 } } sphere { <2,1,0>, .8 finish { phong .5 } scale <.7,.9,.8> pigment { checker rgb 1 rgb y } rotate y*20 } plane { y, -1 texture { scale .7 pigment { "
                                            "wood color_map { [0 rgb .4] [1 rgb <1,.9,.5>] } } rotate x*20 normal { ripples .3 } } } #declare P = pigment { rgb 1 warp { turbulence .4 } scale .3 } sphere { <-2,1,0>, 1 pigment { P gradient x } } #declare Q = pigment "
                                            "{ marble scale .4 } sphere { <0,-.3,-2>, .5 pigment { Q onion color_map { [0 rgb x] [1 rgb y] } } }"},
        {"SrgbAmbientLight", "#version 3.7; global_settings { assumed_gamma 1.6 ambient_light srgb <.9,.5,.3> }" + kView + kSun + sphere + "pigment { rgb .5 } finish { ambient .9 diffuse .2 } }"},
        {"OldVersion", "camera { location <0,2,-6> look_at <0,.5,0> angle 50 right -1.2*x }\n" + kSun + "background { rgb .4 } " + sphere + "pigment { rgbft <.5,.8,.9,.5,.1> } }"},
        {"SrgbColoursOfGamma22", "#version 3.7; global_settings { assumed_gamma 2.2 }" + kView + kSun + "sphere { <-1,.5,0>, 1 pigment { srgb <.8,.3,.5> } } sphere { <1,.5,0>, 1 pigment { srgbft <.8,.6,.2,.3,.2> } finish { ambient srgb .3 } } plane { y, -1 pigment { checker srgb .5 srgb <.1,.02,.7> } }"},
        {"Gamma22", "#version 3.6; global_settings { assumed_gamma 2.2 ambient_light <2,1,.5> }" + kView + kSun + sphere + "pigment { rgb <.5,.7,.6> } }"},
        {"Spotlights", kHead + kView + "light_source { <5,8,-6> rgb 1.2 spotlight radius 12 falloff 22 tightness 3 point_at 0 fade_distance 8 fade_power 2 } light_source { <-5,4,-6> rgb <.2,.3,.6> parallel point_at "
                             "0 } light_source { <0,9,0> rgb .2 shadowless } plane { y, -1 pigment { rgb .7 } finish { phong .5 } } sphere { 0, .8 pigment { rgb 1 } finish { phong 1 } }"},
        {"Orthographic", kHead + "camera { orthographic location <1,3,-6> look_at 0 angle 40 rotate y*10 sky <1,3,0> }" + kSun + "box { -1, 1 pigment { rgb <.9,.5,.3> } }"},
        {"OrthographicWithoutAim", kHead + "camera { orthographic location <.5,.3,-4> direction 2*z rotate x*10 }" + kSun + "box { -1, 1 pigment { rgb <.9,.5,.3> } }"},
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
        {"NormalsThatAreOne", usual + "#declare N = <.6,.3,-.8>; union { mesh { smooth_triangle { <-2,-1,0>, N, <-.5,-1,0>, N, <-1,.5,0>, N+y*.9e-5 } smooth_triangle { <-2,.6,0>, N, <-.5,.6,0>, N, <-1,2,0>, N+y*4e-5 } } "
                                      "smooth_triangle { <0,-1,0>, N, <1.5,-1,0>, N, <1,.5,0>, N } mesh2 { vertex_vectors { 4, <0,.6,0>, <1,.6,0>, <1,2,0>, <0,2,.3> } normal_vectors { 2, N, <0,0,-2> } "
                                      "face_indices { 2, <0,1,2>, <0,2,3> } normal_indices { 2, <0,0,0>, <0,0,1> } } pigment { rgb 1 } }"},
        {"Visibility", usual + "plane { y, -1 pigment { rgb .5 } finish { reflection .5 } } union { sphere { <-1,.5,0>, .7 } sphere { <1,.5,0>, .7 no_reflection } pigment { rgb <1,.5,.2> } no_image } box { <-.3,-.5,-.3>, .3 no_reflection pigment { rgb 1 } }"},
        {"OpaqueFresnel", usual + "plane { y, -1 pigment { rgb <.8,.7,.5> } finish { reflection { .05, .4 fresnel } } interior { ior 1.4 } } sphere { y*.5, .8 pigment { rgb <.2,.5,1> } finish { reflection { .9 fresnel } } interior { ior 1.6 } }"},
        {"Difference", usual + "difference { sphere { 0, 1.5 pigment { rgb <1,.3,.2> } } box { <-2,0,-2>, <0,2,0> pigment { rgb <.3,1,.2> } } cylinder "
         "{ -2*z, 2*z, .5 pigment { rgb <.3,.3,1> } } rotate y*20 translate y*.5 }"},
        {"Intersection", usual + "intersection { sphere { 0, 1.2 } box { -1, 1 pigment { rgb <0,1,0> } } plane { <1,1,-1>, .6 pigment { rgb <1,1,0> } "
         "finish { phong 1 } } pigment { rgb <1,.5,.5> } rotate y*30 translate y*.5 }"},
        {"MergeOfGlass", usual + "plane { y, -1 pigment { rgb <.7,.8,.3> } } merge { sphere { <-.6,.5,0>, 1 } sphere { <.6,.5,0>, 1 } pigment { rgbf "
         "<.9,1,.9,.9> } finish { specular .5 reflection .1 } interior { ior 1.3 } }"},
        {"UnionOfGlass", usual + "plane { y, -1 pigment { rgb <.7,.8,.3> } } union { sphere { <-.6,.5,0>, 1 } sphere { <.6,.5,0>, 1 } pigment { rgbf "
         "<.9,1,.9,.9> } finish { specular .5 reflection .1 } interior { ior 1.3 } }"},
        {"DifferenceOfGlass", usual + "plane { y, -1 pigment { rgb <.7,.8,.3> } } difference { sphere { <0,.5,0>, 1.4 } sphere { <.4,.5,-.5>, .8 } pigment { "
         "rgbf <.9,1,.9,.9> } finish { specular .5 } interior { ior 1.5 fade_distance 1 fade_power 2 fade_color <.9,.3,.2> } }"},
        {"ClippedBy", usual + "sphere { 0, 1.5 pigment { rgb <1,.5,.2> } clipped_by { plane { <-1,1,-1>, .4 } } translate y*.5 } torus { 1.7 .2 "
         "pigment { rgb 1 } clipped_by { cylinder { <-3,0,-.6>, <3,0,-.6>, .9 open } } }"},
        {"Inverse", usual + "plane { y, -1 pigment { rgb <.7,.8,.3> } } intersection { box { -1.2, 1.2 } sphere { <.3,0,-1>, 1 inverse } union { "
         "sphere { <-.8,.8,-1>, .8 } sphere { <-.2,.8,-1>, .7 } inverse } pigment { rgb <.5,.7,1> } rotate y*25 translate y*.5 }"},
        {"InverseGlass", usual + "plane { y, -1 pigment { rgb <.7,.8,.3> } } sphere { <0,.5,0>, 1.4 inverse pigment { rgbf <.9,1,.9,.9> } finish { "
         "reflection {0,1 fresnel} specular .5 conserve_energy } interior { ior 1.5 } }"},
        {"NestedOperations", usual + "difference { merge { intersection { sphere { 0, 1.5 } box { -1.1, 1.1 } pigment { rgb <1,.2,.2> } } cylinder { -1.8*x, "
         "1.8*x, .4 pigment { rgb 1 } } } union { cylinder { -2*y, 2*y, .6 } cylinder { -2*z, 2*z, .6 } pigment { rgb <.2,.2,1> } "
         "} intersection { box { <0,0,-2>, 2 } plane { x, .8 } inverse inverse pigment { rgb <0,1,0> } } rotate <20,30,0> "
         "translate y*.5 }"},
        {"ShadowsOfSolids", usual + "plane { y, -1 pigment { rgb 1 } } difference { sphere { 0, 1.2 } cylinder { -2*y, 2*y, .6 } pigment { rgbf <1,.4,.3,.7> "
         "} translate y*.8 } difference { box { -.5, .5 } cylinder { -y, y, .3 } pigment { rgb 1 } translate <2,0,0> }"},
        {"SurfacesInSolids", usual + "intersection { sphere { 0, 1.5 } triangle { <-2,-1,0>, <2,-1,0>, <0,2,.5> pigment { rgb <1,1,0> } } pigment { rgb 1 } } "
         "difference { mesh { triangle { <-2,0,.5>, <2,0,.5>, <0,2,1> } } cylinder { -2*z, 2*z, .5 } pigment { rgb <1,0,1> } }"},
        {"OpenSolids", usual + "difference { box { -1, 1 } cylinder { -2*z, 2*z, .6 open } cone { -2*y, .8, 2*y, .2 open pigment { rgb <1,1,0> } } disc "
         "{ <.9,0,0>, <-1,0,0>, 2 pigment { rgb <0,1,1> } } pigment { rgb <1,.6,.3> } rotate <-20,30,0> translate y*.5 }"},
        {"ClipsAndTransforms", usual + "sphere { 0, 1 translate x clipped_by { plane { <1,0,.5>, 1 } } pigment { rgb <1,.6,.2> } translate <-2,.6,0> } sphere { 0, 1.2 bounded_by "
         "{ box { <-2,-2,-2>, <.3,2,2> } } scale <1,.8,1> clipped_by { bounded_by } pigment { rgb <.3,1,.5> } rotate y*70 translate <1.2,.8,0> } union { sphere { 0, .6 } box { "
         "<0,-.4,-.4>, <1,.4,.4> } clipped_by { plane { z, .1 inverse } plane { -y, .2 } } bounded_by { clipped_by } pigment { rgb <.5,.4,1> } translate <0,.5,-2.5> }"},
        {"RandomSolids1", random_solids(1)},
        {"RandomSolids2", random_solids(2)},
        {"RandomSolids3", random_solids(3)},
        {"RandomSolids4", random_solids(4)},
        {"TraceLevelThroughGlass", usual + "global_settings { max_trace_level 3 } box { <-2,-2,-1>, <0,2,1> pigment { rgbt <1,1,.8,1> } finish { reflection .3 } } "
         "sphere { x, .7 pigment { rgbf .8 } finish { reflection .2 } } plane { z, 4 pigment { checker rgb 1 rgb <1,0,0> } }"},
        {"AmountOfADeclaredNormal", usual + "#declare NN = normal { bumps .8 scale .2 } sphere { 0, 1.2 pigment { rgb 1 } normal { NN .1 } } sphere { 2*x, .7 pigment { rgb 1 } normal { NN, .3 } }"},
        {"ReflectionBeyondItsMost", usual + "plane { y, -1 pigment { rgb <.05,.1,.2> } normal { waves .5 } finish { reflection { .1, .6 falloff 4 } } } background { rgb <1,.7,.4> }"},
        {"DoubleIlluminate", usual + "disc { 0, z, 2 pigment { rgb 1 } rotate y*70 double_illuminate } disc { <2,0,0>, z, 1 pigment { rgb <1,1,0> } finish { diffuse .6, .3 } rotate y*60 }"},
    };
}

std::vector<PovPicture> pov_pictures() {
    std::vector<PovPicture> all;
    for (const auto& list : {patterned_pictures(), light_pictures(), sampled_pictures(), fog_pictures(), effect_pictures(), cutaway_pictures(), default_pictures(), inside_pictures(), flag_pictures(), function_pictures(), bound_pictures(), shadow_pictures(), old_cameras(), other_pictures(), image_pictures()}) all.insert(all.end(), list.begin(), list.end());
    return all;
}

std::string said_beyond_povray(const Diagnostics& said) {
    std::string text;
    for (const Diagnostic& d : said.list())
        if (d.message.find("has fewer than two parts") == std::string::npos && d.message.find("more than one camera") == std::string::npos) text += said.text(d);
    return text;
}

}  // namespace alidade::test
