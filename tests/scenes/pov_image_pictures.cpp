// SPDX-License-Identifier: Apache-2.0
/// Scenes that show the sample pictures: each word of POV-Ray's bitmaps at least once.
#include "tests/scenes/pov_pictures.h"

#include <fmt/format.h>

namespace alidade::test {

namespace {

const std::string kCorrected = "#version 3.7; global_settings { assumed_gamma 1 }\n";
const std::string kBack = "background { rgb <.1,.2,.3> } light_source { <10,20,-30> rgb 1 }\n";

/// Twelve things in three rows, seen from the front, each with one of a list of pigments, normals or textures.
std::string twelve_of(const std::string& head, const std::string& list, const std::string& thing, const std::string& finish = "ambient 1 diffuse 0") {
    return head + kBack + "camera { orthographic location -10*z look_at 0 right 8*x up 6*y }\n#declare T = array[12] { " + list + " }\n#for (I, 0, 11) " + thing +
           " { T[I] } " + (finish.empty() ? "" : "finish { " + finish + " } ") + "translate <mod(I,4)*2-3.003, 2.002-2*int(I/4), 0> } #end";
}

/// Files that say what their numbers are and that do not, and words that do.
std::string files(const std::string& head) {
    return twelve_of(head,
                  "pigment { image_map { png \"plain.png\" } }, pigment { image_map { png \"srgb.png\" } }, pigment { image_map { png \"gamma.png\" } }, pigment { image_map { png \"plain.png\" gamma 1.8 } }, "
                  "pigment { image_map { png \"gamma.png\" gamma srgb } }, pigment { image_map { png \"grey.png\" } }, pigment { image_map { png \"alpha.png\" } }, pigment { image_map { png \"palette.png\" } }, "
                  "pigment { image_map { png \"deep.png\" } }, pigment { image_map { png \"deep_grey.png\" } }, pigment { image_map { ppm \"plain.ppm\" } }, pigment { image_map { \"plain.ppm\" } }",
                  "box { -.8, .8 pigment");
}

std::string uv_scene() {
    const std::string map = "image_map { png \"plain.png\" }", finish = "finish { ambient .6 diffuse .5 }";
    return kCorrected + kBack + "camera { location <0,2,-9> look_at 0 right 4/3*x angle 50 }\n#default { " + finish + " }\n#declare M = pigment { " + map + " }; #declare T = texture { uv_mapping pigment { M } }\n" +
           "sphere { <-3,1.5,0>, 1 texture { uv_mapping pigment { M } } rotate y*10 } box { -.8, .8 uv_mapping pigment { M } rotate <20,30,0> translate <-1,1.5,0> }\n"
           "torus { .8, .3 pigment { uv_mapping " + map + " scale <.5,.25,1> } rotate -50*x translate <1,1.5,0> } cylinder { -.8*y, .8*y, .7 pigment { uv_mapping " + map + " } rotate 20*x translate <3,1.5,0> }\n"
           "mesh2 { vertex_vectors { 4, <-4,-2,0>, <-2,-2,0>, <-2,0,.5>, <-4,0,0> } uv_vectors { 5, <0,0>, <2,0>, <2,1>, <0,1>, <.5,.5> } face_indices { 2, <0,1,2>, <0,2,3> } uv_indices { 2, <0,1,2>, <0,4,3> } "
           "texture { uv_mapping pigment { checker pigment { rgb x } pigment { M } scale .5 } } }\n"
           "mesh { triangle { <-1.5,-2,0>, <.5,-2,0>, <-.5,0,0> uv_vectors <0,0>, <1,0>, <.5,1> texture { T } } smooth_triangle { <.5,-2,0>, <0,0,-1>, <1,0,0>, <.2,0,-1>, <-.5,0,0>, <0,.2,-1> "
           "uv_vectors <1,0>, <1,1>, <.5,1> } texture { uv_mapping average texture_map { [1 pigment { M }] [1 pigment { rgb z }] } } }\n"
           "sphere { 0, 1.5 scale .6 pigment { average pigment_map { [1 uv_mapping " + map + " scale .5] [1 rgb 1] } } translate <2.5,-1,0> scale 1.01 }";
}

/// Layers over others, which colour nothing in old versions, but for what pictures filter.
std::string old_layers() {
    const std::string textures[] = {
        "texture { A } texture { B }", "texture { A } texture { C }", "texture { C } texture { B }", "texture { B } texture { C }", "texture { A } texture { pigment { image_map { gif \"palette.gif\" filter all 1 } } }",
        "texture { A } texture { pigment { gradient x pigment_map { [.3 image_map { png \"plain.png\" filter all .5 }] [.7 image_map { png \"grey.png\" filter all .8 }] } } }",
        "texture { A } texture { pigment { image_map { png \"alpha.png\" filter all .3 } } }", "texture { A } texture { pigment { image_map { png \"plain.png\" transmit all .6 } } }", "texture { A } texture { B } texture { C }"};
    std::string out = "#version 3.1; global_settings { assumed_gamma 1 }\n" + kBack + "camera { orthographic location -10*z look_at 0 right 8*x up 6*y }\n#declare A = texture { pigment { rgb <1,.5,.2> } }\n"
                      "#declare B = texture { pigment { image_map { png \"plain.png\" filter all .5 } } }\n#declare C = texture { pigment { rgbf <.2,.8,.5,.5> } }\n";
    int i = 0;
    for (const std::string& texture : textures) out += fmt::format("box {{ -.8, .8 {} translate <{}, {}, 0> }}\n", texture, i % 3 * 2 - 2.003, 2.002 - 2 * (i / 3)), ++i;
    return out;
}

/// The textures at the corners of a triangle are mixed over it.
std::string corner_scene() {
    return kCorrected + kBack + "camera { orthographic location -10*z look_at 0 right 8*x up 6*y }\n#declare R = texture { pigment { rgb x } finish { phong .5 } } #declare G = texture { pigment { checker rgb y rgb 1 scale .3 } "
           "normal { bumps .5 } } #declare B = texture { pigment { rgbt <0,0,1,.5> } finish { ambient .5 } }\nplane { z, 2 pigment { checker rgb .8 rgb .3 } }\n"
           "mesh2 { vertex_vectors { 4, <-3,-2,0>, <0,-2,0>, <0,2,0>, <-3,2,0> } texture_list { 3, texture { R } texture { G } texture { B } } face_indices { 2, <0,1,2>, 0, 1, 2, <0,2,3>, 2 } }\n"
           "mesh { triangle { <.5,-2,0>, <3,-2,0>, <3,2,0> texture_list { R G B } } smooth_triangle { <.5,-2,0>, -z, <3,2,0>, -z, <.5,2,0>, -z texture { R } } texture { G } }";
}

}  // namespace

std::vector<PovPicture> image_pictures() {
    const std::string plain = "image_map { png \"plain.png\" ", back = "plane { z, 3 pigment { checker rgb 1 rgb <1,.5,0> scale .7 } finish { ambient 1 diffuse 0 } }\n";
    return {
        {"ImageMaps", twelve_of(kCorrected,
                             "pigment { " + plain + "} }, pigment { " + plain + "interpolate 2 } rotate 20*z }, pigment { " + plain + "interpolate 3 } scale .7 }, pigment { " + plain + "interpolate 4 } translate .3*x }, pigment { " + plain + "once } }, pigment { " + plain +
                                 "once interpolate 2 } scale 1.3 translate -.5 }, pigment { " + plain + "map_type 1 } }, pigment { " + plain + "map_type 1 interpolate 2 } rotate 40*x }, pigment { " + plain + "map_type 2 once } rotate 40*x }, pigment { " + plain +
                                 "map_type 2 interpolate 2 } rotate 30 }, pigment { " + plain + "map_type 5 } scale .5 rotate 70*x }, pigment { " + plain + "} turbulence .3 warp { repeat x*.5 flip x } }",
                             "box { -.8, .8 pigment")},
        {"ClearImages", twelve_of(kCorrected + back,
                               "pigment { " + plain + "filter all .4 } }, pigment { " + plain + "transmit all .6 } }, pigment { " + plain + "filter all .3 transmit all .2 interpolate 2 } }, pigment { image_map { png \"alpha.png\" } }, pigment { image_map { png "
                               "\"alpha.png\" interpolate 2 } }, pigment { image_map { png \"alpha.png\" filter all .2 } }, pigment { image_map { png \"alpha.png\" premultiplied on } }, pigment { image_map { png \"palette.png\" } }, pigment { image_map { png \"palette.png\" "
                               "filter 0, .7 transmit 2, .5 } }, pigment { image_map { png \"palette.png\" transmit 1, .4 transmit all .1 interpolate 2 } }, pigment { " + plain + "once transmit all .3 } }, pigment { average pigment_map { [1 image_map { png \"alpha.png\" }] [1 rgb 1] } }",
                               "box { -.8, .8 pigment")},
        {"ImageFiles", files(kCorrected)},
        {"ImageFilesOfGamma", files("#version 3.7; global_settings { assumed_gamma 2.2 }\n")},
        {"ImageFilesOfSrgb", files("#version 3.7; global_settings { assumed_gamma srgb }\n")},
        {"ImageFilesBeforeTheirGamma", files("#version 3.7;\n") + " global_settings { assumed_gamma 2.2 }"},
        {"ImageFilesBeforeVersionAndGamma", files("") + " #version 3.7; global_settings { assumed_gamma 1.8 }"},
        {"ImageOnAPlaneAtZero", kCorrected + kBack + "camera { location <0,2,-3> look_at 0 } plane { y, 0 pigment { image_map { png \"plain.png\" } } finish { ambient 1 diffuse 0 } } "
                                "box { <.2,.1,.2>, <.8,.6,.8> pigment { image_map { png \"plain.png\" once } } finish { ambient 1 diffuse 0 } }"},
        {"CornersBelowTheBailout", kCorrected + "global_settings { adc_bailout .1475 }\n" + kBack + "camera { orthographic location -10*z look_at 0 right 8*x up 6*y }\n#declare R = texture { pigment { rgb x } finish { phong .5 } } "
                                   "#declare G = texture { pigment { rgb y } } #declare B = texture { pigment { rgb z } finish { ambient .5 } }\nmesh { triangle { <-3,-2,-1>, <3,-2,-1>, <0,2.5,-1> texture_list { R G B } } }"},
        {"ImageFilesOfOldScenes", files("#version 3.6; global_settings { assumed_gamma 1.8 }\n")},
        {"ImageFilesUncorrected", twelve_of("", "pigment { image_map { png \"plain.png\" } }, pigment { image_map { png \"srgb.png\" } }, pigment { image_map { png \"gamma.png\" } }, pigment { image_map { png \"grey.png\" } }, pigment { image_map { png \"alpha.png\" } }, pigment { image_map { png "
                                         "\"palette.png\" } }, pigment { image_map { png \"deep.png\" } }, pigment { image_map { png \"deep_grey.png\" } }, pigment { image_map { ppm \"plain.ppm\" } }, pigment { image_pattern { png \"plain.png\" } }, pigment { image_pattern { png \"srgb.png\" } }, "
                                         "pigment { image_map { \"plain\" } }", "box { -.8, .8 pigment")},
        {"ImagePatterns", twelve_of(kCorrected,
                                 "pigment { image_pattern { png \"plain.png\" } }, pigment { image_pattern { png \"plain.png\" } color_map { [.3 rgb x] [.7 rgb <0,1,1>] } }, pigment { image_pattern { png \"alpha.png\" use_alpha } color_map { [0 rgb y] [1 rgb 1] } }, pigment { image_pattern { png "
                                 "\"alpha.png\" interpolate 2 } }, pigment { image_pattern { png \"grey.png\" } pigment_map { [.4 checker scale .2] [.6 rgb 1] } }, pigment { image_pattern { png \"deep_grey.png\" interpolate 3 } sine_wave }, pigment { image_pattern { png \"palette.png\" } }, pigment { "
                                 "image_pattern { png \"srgb.png\" once } color_map { [0 rgb x] [1 rgb y] } }, pigment { image_pattern { png \"plain.png\" map_type 1 } rotate 30 }, pigment { image_pattern { png \"gamma.png\" gamma 1.5 } }, pigment { image_pattern { png \"deep.png\" use_color } }, "
                                 "pigment { pigment_pattern { image_map { png \"plain.png\" } } color_map { [0 rgb 1] [1 rgb z] } }",
                                 "box { -.8, .8 pigment")},
        {"ImageNormals", twelve_of(kCorrected,
                                "normal { bump_map { png \"smooth.png\" bump_size 3 } }, normal { bump_map { png \"smooth.png\" interpolate 2 } bump_size 5 }, normal { bump_map { png \"smooth.png\" interpolate 2 bump_size 4 } scale .5 rotate 40*z }, normal { bump_map { png \"grey.png\" bump_size .7 } }, normal { "
                                "bump_map { png \"plain.png\" use_color bump_size .8 } rotate 50*y }, normal { bump_map { png \"smooth.png\" map_type 1 bump_size 4 } }, normal { bump_map { png \"palette.png\" use_index bump_size 20 } scale .7 }, normal { image_pattern { png \"smooth.png\" interpolate 2 } 1 }, normal { "
                                "image_pattern { png \"plain.png\" } normal_map { [.4 bumps 1 scale .1] [.6 ripples 1 frequency 10] } }, normal { uv_mapping bump_map { png \"smooth.png\" bump_size 4 } scale .5 }, normal { average normal_map { [1 bump_map { png \"smooth.png\" bump_size 4 }] [1 bumps .5 scale .2] } }, "
                                "normal { image_pattern { png \"deep_grey.png\" interpolate 2 } slope_map { [0 <0,1>] [1 <1,0>] } }",
                                "sphere { 0, .9 pigment { rgb <1,.9,.8> } normal", "ambient .1 diffuse .8 phong .4")},
        {"ImageTextures", twelve_of(kCorrected + "#declare A = texture { pigment { rgb x } finish { ambient 1 } } #declare B = texture { pigment { checker rgb 1 rgb y scale .2 } finish { phong 1 } }\n",
                                 "texture { image_pattern { png \"plain.png\" } texture_map { [.3 A] [.7 B] } }, texture { image_pattern { png \"alpha.png\" use_alpha } texture_map { [0 A] [1 B] } scale .5 }, texture { uv_mapping image_pattern { png \"plain.png\" interpolate 2 } texture_map { [.3 A] [.7 B] } }, "
                                 "texture { material_map { png \"palette.png\" texture { A } texture { B } } }, texture { material_map { png \"palette.png\" map_type 1 texture { A } texture { B } texture { pigment { rgb z } } } scale .5 }, texture { material_map { png \"plain.png\" texture { A } texture { B } texture { pigment { rgb z } } } }, texture { B }, texture { A }, texture { B }, texture { A }, texture { pigment { image_map { png \"alpha.png\" } } scale .5 }, texture { uv_mapping pigment { image_map { png \"plain.png\" } } rotate 20*z }",
                                 "sphere { 0, .9 texture", "")},
        {"ImageNumbers", twelve_of(kCorrected + "#declare A = texture { pigment { rgb x } } #declare B = texture { pigment { checker rgb 1 rgb y scale .2 } } #declare C = texture { pigment { rgb z } }\n",
                                "texture { material_map { gif \"palette.gif\" texture { A } texture { B } texture { C } } }, texture { material_map { gif \"palette.gif\" map_type 2 texture { A } texture { B } texture { C } } }, texture { material_map { pgm \"grey.pgm\" texture { A } texture { B } texture { C } } }, "
                                "texture { material_map { png \"plain.png\" map_type 1 texture { A } texture { B } texture { C } } }, texture { material_map { gif \"palette.gif\" once texture { A } texture { B } } }, texture { pigment { image_map { gif \"palette.gif\" } } }, "
                                "texture { pigment { image_map { gif \"palette.gif\" filter 0, .7 transmit 2, .5 } } }, texture { pigment { image_map { gif \"palette.gif\" interpolate 2 transmit 1, .2 } } }, texture { pigment { image_pattern { gif \"palette.gif\" use_alpha use_index } } }, "
                                "texture { pigment { image_pattern { png \"plain.png\" use_index use_alpha } } }, texture { pigment { image_pattern { pgm \"grey.pgm\" use_alpha interpolate 2 } } }, texture { pigment { image_pattern { pgm \"grey.pgm\" } } normal { bump_map { png \"plain.png\" use_index once bump_size 2 } } finish { ambient .2 diffuse .6 } }",
                                "box { -.8, .8 texture", "")},
        {"ClearColors", twelve_of(kCorrected + back,
                               "pigment { image_map { gif \"palette.gif\" filter all .5 filter 0, 0 } }, pigment { image_map { gif \"palette.gif\" filter 0, 0 filter all .5 } }, pigment { image_map { gif \"palette.gif\" filter 1, .8 filter all 0 } }, pigment { image_map { gif \"palette.gif\" transmit 0, 0 transmit "
                               "1, 0 transmit 2, 0 transmit 3, 0 } }, pigment { image_map { png \"palette.png\" transmit all 0 } }, pigment { image_map { png \"palette.png\" transmit all .6 transmit 1, 0 } }, pigment { image_map { png \"palette.png\" transmit 1, 0 transmit all .6 } }, pigment { image_map { png "
                               "\"palette.png\" filter all .9 filter 2, 0 interpolate 2 } }, pigment { image_map { png \"alpha.png\" transmit all 0 } }, pigment { image_map { png \"alpha.png\" filter all .4 filter all 0 } }, pigment { " + plain + "transmit all .6 transmit all 0 } }, pigment { image_map { png "
                               "\"palette.png\" filter all .4 transmit all .2 filter 1, .1 transmit 1, 0 } }",
                               "box { -.8, .8 pigment")},
        {"PremultipliedImages", twelve_of(kCorrected + back,
                                       "pigment { image_map { png \"alpha.png\" premultiplied on interpolate 2 } }, pigment { image_map { png \"alpha.png\" premultiplied on interpolate 3 } }, pigment { image_map { png \"alpha.png\" gamma 1 premultiplied on interpolate 4 } }, "
                                       "pigment { image_map { png \"alpha.png\" premultiplied on transmit all .3 } }, pigment { image_map { png \"alpha.png\" premultiplied on interpolate 2 filter all .3 transmit all .2 } }, pigment { image_map { png \"alpha.png\" premultiplied on transmit all .9 } }, "
                                       "pigment { image_map { png \"palette.png\" premultiplied on interpolate 2 } }, pigment { image_map { png \"palette.png\" premultiplied on transmit 1, .4 } }, pigment { " + plain + "premultiplied on transmit all .4 } }, "
                                       "pigment { image_pattern { png \"alpha.png\" premultiplied on interpolate 2 } }, pigment { image_pattern { png \"alpha.png\" premultiplied on use_alpha } }, pigment { image_map { png \"alpha.png\" premultiplied off interpolate 2 } }",
                                       "box { -.8, .8 pigment")},
        {"ImageLayersOfVersion31", old_layers()},
        {"EnergyWhereAPictureHasEnded", kCorrected + kBack + "camera { location <-1,3,-6.6> look_at <0,0.6,0> angle 50 } #declare F = finish { ambient 0 reflection .4 conserve_energy } #declare P = pigment { image_map { png \"plain.png\" once } scale .7 translate -.35 }\n"
                                        "sphere { <-1.5,.8,0>, .7 pigment { P } finish { F } } sphere { <0,.8,0>, .7 texture { pigment { rgb y } } texture { pigment { P } finish { F } } } sphere { <1.5,.8,0>, .7 pigment { checker pigment { P } pigment { rgb 1 } scale .4 } finish { F } }\n"
                                        "plane { y, -.3 texture { checker texture { pigment { P } finish { F } } texture { pigment { rgb .5 } } } } sphere { <-.8,0,-2>, .4 pigment { average pigment_map { [1 P] [1 rgb x] } } finish { F } }\n"
                                        "sphere { <.8,0,-2>, .4 pigment { gradient x pigment_map { [.3 P] [.8 rgb x] } } finish { F } } sphere { <0,0,-2.4>, .4 pigment { P } finish { F reflection { .1, .8 fresnel } } interior { ior 1.4 } }"},
        {"UvMapping", uv_scene()},
        {"CornerTextures", corner_scene()},
    };
}

}  // namespace alidade::test
