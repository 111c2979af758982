// SPDX-License-Identifier: Apache-2.0
/// Faces that show what they lay open.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

const std::string kRed = " pigment { rgb <1,.2,.1> } finish { phong .7 } ";
const std::string kGreen = " pigment { checker rgb <.1,.8,.2> rgb <.7,1,.7> scale .3 } ";
const std::string kBlue = " pigment { gradient x color_map { [0 rgb <0,.1,.6>] [1 rgb <.6,.8,1>] } scale .5 rotate z*30 } normal { bumps .4 scale .1 } ";
const std::string kNear = " box { <-9,-9,-9>, <9,9,0.05> } ", kFar = " plane { -z, -.05 } ";

std::string seen(const std::string& objects, const std::string& ahead = "") {
    return "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.3,.5,.7> } camera { location <1,2,-6> look_at <0,0,0> angle 50 } light_source { <10,20,-35> rgb <1,.9,.8> }\n" + ahead + objects;
}

}  // namespace

std::vector<PovPicture> cutaway_pictures() {
    const std::string grey = "#default { texture { pigment { rgb <.6,.6,.3> } } }\n";
    const std::string balls = "union { sphere { -x, 1.5" + kRed + "} sphere { x, 1.5" + kGreen + "} }";
    return {
        {"Cutaway", seen("difference { sphere { 0, 2" + kRed + "}" + kNear + "cutaway_textures }")},
        {"CutawayOfAUnion", seen("difference { " + balls + kNear + "cutaway_textures rotate y*20 }")},
        {"CutawayByAPlane", seen("intersection { " + balls + kFar + "sphere { 0, 1.6" + kBlue + "} cutaway_textures }")},
        {"CutawayOfADifference", seen("difference { difference { sphere { 0, 2" + kBlue + "} sphere { x*.5, .8" + kRed + "} } union { box { <-9,-9,-9>, <.2,9,.05> } box { <0,-9,-9>, <9,9,.1>" + kGreen + "} } cutaway_textures }")},
        {"CutawayWithAnUnmadePart", seen("intersection { sphere { -x*.7, 1.7" + kRed + "} sphere { x*.7, 1.7 } union { sphere { -y, 1.4 } box { -1.5, 1.5" + kBlue + "} }" + kFar + "cutaway_textures }", grey)},
        {"CutawayInACutaway", seen("difference { difference { sphere { 0, 2" + kRed + "} plane { z, .05 } } box { <-9,-9,-9>, <0,9,.6> } cutaway_textures }")},
        {"CutawaysThreeDeep", seen("difference { difference { difference { sphere { 0, 2" + kRed + "} plane { z, -.5 } } plane { <1,0,1>, -.2 } } cylinder { -9*y, 9*y, .6" + kGreen + "} cutaway_textures }")},
        {"CutawayOfTheInnerOfTwo", seen("union { difference { difference { sphere { 0, 2" + kRed + "} plane { <1,-1,1>, -.2 } cutaway_textures } cylinder { -9*z, -.9*z, .6" + kGreen + "} } box { 1, 2 } }")},
        {"CutawayByADifference", seen("difference { sphere { 0, 2" + kBlue + "} difference { plane { z, .3 } plane { x, -.2 } } cutaway_textures }")},
        {"CutawayByAnInverse", seen("intersection { sphere { 0, 2" + kGreen + "} union { box { <-9,-9,-9>, <9,0,0.05> } box { <0,-9,-9>, <9,9,0.6> } inverse } box { <-3,-3,-3>, <3,1.2,3> inverse } sphere { x, 1" + kRed + "inverse } cutaway_textures }")},
        {"CutawayOfADeclaredSolid", seen("#declare D = difference { sphere { 0, 1.4" + kRed + "}" + kNear + "} object { D cutaway_textures translate -1.5*x } object { D translate 1.5*x }", grey)},
        {"CutawayInAUnion", seen("union { difference { sphere { -x, 1.2" + kBlue + "}" + kNear + "cutaway_textures } box { 1, 2 } }")},
        {"CutawayCoveredFromOutside", seen("union { difference { sphere { -x, 1.2" + kBlue + "}" + kNear + "cutaway_textures } box { 1, 2 }" + kGreen + "}")},
        {"CutawayThroughGlass", seen("difference { union { sphere { -x, 1.5 pigment { rgbt <.8,.3,.2,.6> } } sphere { x, 1.5 pigment { rgbf <.2,1,.4,.7> } } }" + kNear + "cutaway_textures } plane { z, 4 hollow" + kGreen + "}")},
        {"CutawayOfAnUnmadeSolid", seen("difference { sphere { 0, 2 } box { <-9,-9,-9>, <0,9,.05> } box { <-.2,-9,-9>, <9,9,.3>" + kGreen + "} cutaway_textures } plane { z, 4 hollow pigment { rgbt <1,.5,.5,.3> } }", grey)},
        {"CutawayOfOnePart", seen("intersection { sphere { 0, 2" + kRed + "} cutaway_textures } sphere { x*2, 1" + kBlue + "}")},
        {"CutawayOfNothing", seen("difference { sphere { 0, 2 }" + kNear + "cutaway_textures }", grey)},
    };
}

}  // namespace alidade::test
