// SPDX-License-Identifier: Apache-2.0
/// Functions as patterns, and pictures that are made of functions.
#include "tests/scenes/pov_pictures.h"

#include <fmt/format.h>

namespace alidade::test {

namespace {

const std::string kFunctionHead = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb .2 } camera { orthographic location <0,0,-5> look_at 0 right 8*x up 6*y } light_source { <10,20,-20> rgb 1 }\n"
                          "#declare F = function(a, b) { sin(a*5)*cos(b*4) } #declare Noise = function { pattern { bozo turbulence .3 } } #declare Tint = function { pigment { function { F(x, y) + x } color_map { [0 rgbt <1,.2,.1,.3>] [1 rgb <0,.3,1>] } } }\n"
                          "#declare Turn = function { transform { rotate 30*z scale <2,1,1> } } #declare Curve = function { spline { natural_spline -1, <0,1,0> 0, <1,0,2> .5, <0,0,1> 2, <1,1,1> } } #declare Map = color_map { [0 rgb <1,.2,.1>] [.4 rgb <1,1,.3>] [1 rgb <0,.3,1>] }\n";

/// Balls in two rows, of what stands behind `sphere { ... }`.
std::string function_balls(const std::vector<std::string>& looks) {
    std::string out = kFunctionHead;
    for (size_t i = 0; i < looks.size(); ++i) out += fmt::format("sphere {{ 0, .9 {} translate <{},{},0> }}\n", looks[i], 2 * int(i % 4) - 3, i < 4 ? 1.2 : -1.2);
    return out;
}

}  // namespace

std::vector<PovPicture> function_pictures() {
    return {
        {"FunctionsOfPigments", function_balls({"pigment { function { x*y*3 } color_map { Map } }", "pigment { function { F(x, y)*2 } frequency 2 phase .1 sine_wave turbulence .2 scale .7 }", "pigment { function { Noise(x*3, y*3, z*3) + Tint(x, y, z).red } color_map { Map } }",
                                       "pigment { function { max(x, y, -z)*2 - 1 } triangle_wave warp { repeat x/2 flip x } rotate 30*z color_map { Map } }", "pigment { function { Turn(x, y, z).x + Curve(y).z } pigment_map { [.2 rgb x] [.7 granite scale .2] } }",
                                       "pigment { pigment_pattern { function { abs(x) + y } scale .5 } color_map { Map } }", "pigment { average pigment_map { [1 function { x*3 }] [2 Noise_ ] } }", "pigment { function { Tint(x, y, z).gray*(z < -.5) + Tint(y, x, z).transmit } noise_generator 1 }"})
                                    .insert(kFunctionHead.size(), "#declare Noise_ = pigment { function { Noise(x, y, z) } scale .2 }\n")},
        {"FunctionsOfNormals", function_balls({"pigment { rgb 1 } normal { function { F(x, y) } .5 }", "pigment { rgb 1 } normal { function { sin(20*x)/2 } bump_size 1 slope_map { [0 <0,1>] [.5 <1,1>] [1 <0,-1>] } scale .8 }", "pigment { rgb 1 } normal { function { Noise(x, y, z) } -.6 scale .2 accuracy .1 }",
                                      "pigment { rgb 1 } normal { function { abs(y)*2 } normal_map { [0 bumps scale .1] [1 function { x*8 } 1.5] } }"})},
        {"FunctionsOfTextures", function_balls({"texture { function { sum(i, 1, 4, sin(i*x*2))/4 + prod(j, 1, 2, y*j) } texture_map { [0 pigment { rgb x }] [1 pigment { checker rgb 1 rgb 0 scale .2 }] } }",
                                       "uv_mapping pigment { function { x*4 + y } color_map { Map } }", "texture { function { floor(3*x)/3 + (y >= 0)*.5 } texture_map { [.5 pigment { rgb y } finish { phong 1 }] [.5 pigment { rgb 1 } normal { function { F(x, y) } 1 } ] } rotate 40*z }",
                                       "pigment { cylindrical color_map { [0 rgb 1] [1 rgb 0] } } texture { pigment { function { select(x, -1, 0, y)*2 } color_map { [0 rgbt 1] [1 rgbt <1,0,0,.2>] } } }"})},
        {"FunctionsAfterPatterns", function_balls({"pigment { W function { x*2 } }", "pigment { C function { x*3 } }", "pigment { S wood }", "pigment { function { y*2 } } pigment { bozo }", "pigment { function { sqrt(x) } color_map { Map } }", "pigment { function { x/(y - y) } color_map { Map } }", "pigment { W pigment_pattern { gradient x } }",
                                          "pigment { function { -3.7*x } frequency -2 phase 3 color_map { Map } }"})
                                       .insert(kFunctionHead.size(), "#declare W = pigment { wood scale .3 color_map { [0 rgb x] [1 rgb y] } } #declare C = pigment { checker scale .4 } #declare S = pigment { function { x } frequency 2 color_map { [0 rgb 0] [1 rgb z] } }\n")},
        {"PicturesOfFunctions", function_balls({"pigment { image_map { function 8,6 { x*y } interpolate 2 } scale .7 }", "pigment { image_map { function 30,30 { pigment { agate scale .2 color_map { Map } } } map_type 1 } rotate 50*y }", "pigment { image_pattern { function 9,5 { F(x, y)/2 + .5 } } color_map { Map } }",
                                                "pigment { rgb 1 } normal { bump_map { function 12,12 { sin(9*x)*sin(9*y)/2 + .5 } interpolate 2 bump_size 3 } scale .6 }", "texture { material_map { function 6,6 { x*2/255 } texture { pigment { rgb x } } texture { pigment { rgb y } } texture { pigment { rgb z } } } }",
                                                "pigment { image_map { function 9,9 { pigment { gradient x color_map { [0 rgbt <1,0,0,.8>] [1 rgb 1] } } } once transmit all .2 } }"})},
        {"NormalsOfNoNumber", function_balls({"pigment { rgb 1 } normal { function { sqrt(x) } .5 }", "pigment { rgb x } finish { ambient .5 reflection .5 phong 1 } normal { function { 0/(y*(y > 0)) } 0 }", "pigment { rgbt <1,.2,.3,.5> } normal { function { ln(x - x) } bump_size 0 }",
                                              "pigment { rgb 1 } normal { function { sqrt(y) } slope_map { [0 <0,1>] [1 <1,0>] } }", "pigment { rgb 1 } normal { average normal_map { [1 function { asin(2*x) } .3] [1 bumps] } }", "texture { pigment { rgb 1 } normal { function { sqrt(x) } .2 } } texture { pigment { rgbt <0,1,0,.4> } }",
                                              "texture { gradient x texture_map { [.3 pigment { rgb x }] [.6 pigment { rgb 1 } normal { function { acos(y*9) } .3 }] } scale 2 }", "pigment { rgb 1 } normal { function { sqrt(x) } normal_map { [0 bumps 0] [1 bumps 1] } }"})},
        {"BehindNormalsOfNoNumber", "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 12 } background { rgb <.2,.4,.6> } camera { location <0,1,-6> look_at 0 angle 50 } light_source { <-3,5,-8> 1 } plane { y, -1 pigment { checker rgb 1 rgb .4 } finish { reflection .3 } } "
                                    "sphere { <-1.2,0,1>, .8 pigment { rgb <1,.6,.2> } normal { function { select(x + 1.1, 0/(y - y), y) } .5 } } sphere { <.9,-.1,-1>, .8 pigment { rgbt <.8,1,.9,.8> } interior { ior 1.2 } finish { reflection { .2 } } } "
                                    "box { <-3,-1,2.5>, <3,1.5,2.6> pigment { rgb .3 } finish { reflection <.5,0,0> } } disc { <-1.2,.5,-1.5>, z, .6 pigment { rgbf <1,.5,.5,.7> } }"},
        {"FunctionsAround", "#include \"functions.inc\"\n" + kFunctionHead + "sky_sphere { pigment { function { y*2 + F(x, z)*.2 } color_map { Map } } } sphere { 0, 1.5 pigment { rgb 0 } finish { reflection 1 } normal { function { sin(9*y) } .2 } } plane { y, -2 pigment { function { f_noise3d(x, y, z) + f_r(x, y, z) } color_map { Map } } }\n"},
    };
}

}  // namespace alidade::test
