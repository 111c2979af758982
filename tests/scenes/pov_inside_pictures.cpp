// SPDX-License-Identifier: Apache-2.0
/// What counts as inside: of surfaces that enclose nothing, and where a camera stands.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

constexpr const char* kHead = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.7,.8,1> } light_source { <-7,8,-6> 1 }\n";
constexpr const char* kFloor = "plane { y, -1.6 pigment { checker rgb 1 rgb <1,.2,.2> scale .5 } }\n";
constexpr const char* kGlass = " pigment { rgbt <.5,.9,.4,.95> } interior { ior 1.4 } ";

std::string seen(const std::string& objects, const char* camera = "camera { location <0,3,-4> look_at 0 }") { return std::string(kHead) + camera + "\n" + kFloor + objects; }

std::string sheets() {
    const std::string triangle = "triangle { <-1,-.2,-1>, <1,.3,-.6>, <0,.5,.8> }", white = " pigment { rgb .9 } ";
    return "difference { sphere { 0, .9 } " + triangle + white + "translate -2*x }\n"
           "difference { sphere { 0, .9 } mesh { " + triangle + " triangle { -1, x, y } }" + white + "}\n"
           "difference { sphere { 0, .9 } polygon { 4 <-1,-1>, <1,-1>, <0,1>, <-1,-1> rotate x*70 }" + white + "translate 2*x }\n"
           "difference { sphere { 0, .9 } union { sphere { x*.5, .5 } " + triangle + " }" + white + "translate <-2,0,2> }\n"
           "intersection { sphere { 0, .9 } object { " + triangle + " inverse }" + white + "translate 2*z }\n"
           "merge { sphere { 0, .9 } " + triangle + white + "translate <2,0,2> }\n";
}

}  // namespace

std::vector<PovPicture> inside_pictures() {
    const std::string glass = kGlass;
    return {
        {"SheetsTakenAway", seen(sheets())},
        {"ClippedGlassFromBehind", seen("plane { -y, 0 clipped_by { sphere { 0, 1.2 } }" + glass + "translate -1.5*x } quadric { 1, 0, 0, -1 clipped_by { plane { y, 0 } }" + glass + "translate 1.5*x }")},
        {"CameraInGlass", seen("sphere { <0,3,-4>, 2 pigment { rgbt <.8,.9,1,.9> } interior { ior 1.2 fade_distance 3 fade_power 1 } } box { <-1,-1,-1>, <1,0,1>" + glass + "rotate y*30 }")},
        {"CameraInGlassInWater", seen("sphere { <0,3,-4>, .5" + glass + "} box { <-5,-1.5,-6>, <5,4,-2> pigment { rgbt <.6,.8,1,.9> } interior { ior 1.33 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }")},
        {"OrthographicInGlass", seen("box { <-5,-1.5,-6>, <.2,4,-2> pigment { rgbt <.6,.8,1,.9> } interior { ior 1.33 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }", "camera { orthographic location <0,3,-4> look_at 0 }")},
        {"FresnelMirrorsInWater", seen("sphere { 0, 9 pigment { rgbt 1 } interior { ior 1.15 } } background { rgb <1,.8,.6> } box { -1, 1 pigment { rgb .2 } finish { reflection { 1 fresnel } } rotate y*20 } "
                                       "sphere { <1.8,.2,0>, .7 texture { pigment { rgb .2 } finish { reflection { 1 fresnel } } } texture { pigment { checker rgb x rgbt 1 scale .3 } } } plane { y, -1.5 pigment { rgb <.3,.4,.2> } finish { reflection { .2, .9 fresnel } } }")},
        {"CameraInAUnionOfGlass", seen("union { sphere { <0,3.1,-4.2>, 1 } box { <-1,2.2,-5>, <1,4,-3.3> } pigment { rgbt <.5,.9,.4,.95> } interior { ior 1.4 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }")},
        {"CameraInASolidOfGlasses", seen("intersection { sphere { <0,3,-4>, 2 pigment { rgbt .9 } interior { ior 1.2 } } box { <-1,2,-5>, <2,4,-3> pigment { rgbt .9 } interior { ior 1.6 } } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }")},
        {"CameraInAMovedInverseOfAnInverse", seen("#declare X = cylinder { <-1,3,-4>, <1,4,-3>, .7" + glass + "} object { object { X inverse } inverse } object { mesh { triangle { <-3,0,-6>, <3,0,-6>, <0,6,-6> } triangle { <-3,0,-2>, <3,0,-2>, <0,6,-2> } } inverse" + glass + "}")},
        {"FogAroundClippedSheets", seen("fog { distance 6 rgb <.5,.4,.3> } disc { <1,0,1>, <.8,-.6,.8>, .9 pigment { rgb y } clipped_by { plane { y, 1 } } } merge { box { -.8, .6 inverse } sphere { x, .9 } pigment { rgb <.6,.6,1> } }")},
    };
}

}  // namespace alidade::test
