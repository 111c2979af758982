// SPDX-License-Identifier: Apache-2.0
/// What textures begin with: the default texture where they stand, that where they were declared, or what was there before.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

constexpr const char* kDefaultHead = "#version 3.7; global_settings { assumed_gamma 1 } camera { location <1,2,-5> look_at 0 angle 45 } background { rgb <.3,.3,.7> } light_source { <3,5,-5> 1 }\n";
constexpr const char* kDeclared = "#declare P = pigment { wood color_map { [0 rgb <1,.4,.2>] [1 rgb <.2,.6,.1>] } scale .4 } #declare F = finish { phong 1 } #declare N = normal { bumps 1 scale .2 }\n";
constexpr const char* kDefault = "#default { texture { pigment { dents frequency 1.45 } finish { ambient .5 diffuse .3 brilliance 2 } normal { dents 1 turbulence .5 } } }\n";

std::string after_default(const std::string& objects) { return std::string(kDefaultHead) + kDeclared + kDefault + objects; }

/// Six spheres in a row of three and one of two and one.
std::string spheres(const std::vector<std::string>& textures) {
    std::string out;
    for (size_t i = 0; i < textures.size(); ++i)
        out += "sphere { <" + std::to_string(int(i % 3) - 1) + "," + std::to_string(i / 3) + "-.5,0>*1.1, .5 " + textures[i] + " }\n";
    return out;
}

}  // namespace

std::vector<PovPicture> default_pictures() {
    return {
        {"DefaultsOfDeclaredFinishes", after_default(spheres({"pigment { rgb 1 } finish { F }", "texture { pigment { P } finish { diffuse .2 } finish { F } }", "texture { F }", "pigment { rgb 1 } finish { phong 1 }", "pigment { rgb 1 } finish { F diffuse 1 }", "texture { finish { diffuse 1 } }"}))},
        {"DeclaredPartsAsTextures", after_default(spheres({"texture { P }", "texture { P F N }", "texture { N }", "texture { P scale 2 finish { F } }", "texture { pigment { P turbulence 1 } normal { N bump_size .3 } }", "texture { pigment { P } normal { N } }"}))},
        {"DefaultsOfPatterns", after_default(spheres({"pigment { wood }", "pigment { agate } pigment { marble }", "pigment { bozo scale .3 } translate y*.1 pigment { wood }", "pigment { wood color_map { [0 rgb 1] [1 rgb x] } } pigment { bozo }", "texture { pigment { gradient x } }", "pigment { mandel 12 exponent 3 scale .4 translate <1.1,.55,0> }"}))},
        {"PatternsAfterLists", std::string(kDefaultHead) + "#declare C = pigment { checker scale .4 } #declare G = pigment { dents frequency 1.45 scale .4 } #declare M = pigment { hexagon pigment { rgb x } pigment { rgb y } scale .4 }\n" + spheres({"pigment { C bozo }", "pigment { C wood color_map { [0 rgb x] [1 rgb y] } }", "pigment { G hexagon rgb x rgb y rgb z }", "pigment { M marble }", "pigment { G checker }", "pigment { G brick frequency 3 }"})},
        {"PatternsUnderColours", std::string(kDefaultHead) + "#declare G = pigment { gradient y frequency 2.45 turbulence .3 } #declare W = pigment { wood scale .3 color_map { [0 rgb x] [1 rgb y] } }\n" + spheres({"pigment { G rgb x } pigment { gradient x color_map { [0 rgb 1] [1 rgb z] } }", "pigment { wood scale .2 } pigment { rgb 1 } pigment { bozo }", "pigment { W rgb 1 } pigment { bozo }", "pigment { W rgb <1,.5,0> }", "pigment { G rgb x } pigment { checker scale .3 }", "pigment { rgb 1 } normal { spiral1 4 -.3 scale .5 }"})},
        {"WavesOfPatterns", std::string(kDefaultHead) + "#declare B = pigment { boxed scallop_wave color_map { [.1 rgb 1] [.9 rgb z] } } #declare Q = pigment { boxed frequency 2 color_map { [.1 rgb 1] [.9 rgb z] } } #declare W = pigment { wood sine_wave color_map { [.1 rgb 1] [.9 rgb x] } }\n" + spheres({"pigment { B spiral1 3 scale .4 }", "pigment { B wood scale .2 }", "pigment { B bozo scale .4 }", "pigment { W marble scale .4 }", "pigment { W bozo scale .4 }", "pigment { Q quilted scale .4 }"})},
        {"NoiseOfPatterns", std::string(kDefaultHead) + "global_settings { noise_generator 3 } #declare B = pigment { bozo noise_generator 1 scale .3 } #declare N = normal { bumps 1 noise_generator 2 scale .3 }\n" + spheres({"pigment { B granite }", "pigment { B marble turbulence .5 }", "pigment { granite scale .3 }", "pigment { rgb 1 } normal { N granite 1 }", "pigment { B rgb 1 } pigment { agate }", "texture { bozo texture_map { [.4 pigment { B }] [.6 pigment { wrinkles }] } scale .3 }"})},
        {"NormalsOfTexturesWithoutOne", std::string(kDefaultHead) + "#declare T = texture { pigment { rgb 1 } }\n#default { normal { wood 1 scale .2 } }\n" + spheres({"texture { T } normal { }", "texture { T normal { scale 2 } }", "texture { T }", "texture { T } normal { bumps 1 }", "texture { T rotate 30 } rotate x*40 normal { bumps }", "pigment { rgb 1 }"})},
        {"TexturesOfObjectsInObjects", std::string(kDefaultHead) + "#declare A = box { -.6, .6 texture { pigment { rgb x } } texture { pigment { rgbt <0,0,1,.5> } } rotate y*20 }\n#declare B = object { A rotate x*30 }\n#declare C = object { B scale .8 }\n"
                                         "object { B texture { pigment { gradient x color_map { [0 rgb y] [1 rgb 1] } scale .3 } } translate -1.3*x } object { C pigment { rgbt <0,1,0,.5> } } object { C finish { phong 1 } translate 1.3*x }\n"
                                         "object { C translate <-1.3,1.2,1> } object { object { A interior { ior 1.2 } } pigment { rgbt .8 } translate <1.3,1.2,1> }"},
        {"PigmentsWithoutDefaults", "#default { pigment { gradient x color_map { [0 rgb 0] [1 rgb <0,1,0>] } rotate z*30 scale .2 turbulence .3 frequency 2 } }\n" + std::string(kDefaultHead) + "sky_sphere { pigment { gradient y scale .3 } }\n" +
                                        spheres({"pigment { pigment_pattern { gradient y } color_map { [0 rgb x] [1 rgb 1] } }", "pigment { pigment_pattern { bozo scale .2 } }", "pigment { gradient y }", "pigment { gradient x pigment_map { [0 rgb x] [1 gradient y] } }",
                                                 "texture { pigment_pattern { gradient x } texture_map { [.3 pigment { rgb x }] [.7 pigment { gradient y }] } }"})},
        {"DefaultNormalOfACamera", "#version 3.7; global_settings { assumed_gamma 1 } #default { normal { bumps .6 scale .1 turbulence .4 } } camera { location -4*z look_at 0 angle 50 normal { waves .3 } } sphere { 0, 1 pigment { gradient x scale .3 } finish { ambient 1 diffuse 0 } }"},
        {"ReflectionsAgain", std::string(kDefaultHead) + "#default { finish { reflection { rgb .7, rgb .2 fresnel on } } } #default { pigment { rgb .2 } } #macro S(X,Y) sphere { <X,Y,0>, .45 interior { ior 1.4 } finish { #end #declare D = finish { reflection { .2, .8 } }\n"
                                        "S(-1.5,0) reflection { .3 } } } S(-.5,0) reflection { .5 falloff 2 } } } S(.5,0) reflection { .1, .6 } } } S(1.5,0) reflection .5 } } S(-1.5,1) reflection { .5 fresnel } } } S(-.5,1) reflection { .9 fresnel } reflection { .3 } } } "
                                        "S(.5,1) reflection { fresnel } } } S(1.5,1) D reflection { } } } S(-.5,2) reflection { metallic } } } S(.5,2) D reflection { .4 } reflection { exponent 2 } } }"},
        {"MissingNormals", after_default(spheres({"normal { checker normal { bumps 1 scale .1 } scale .3 }", "normal { hexagon normal { bumps 1 scale .1 } scale .3 }", "normal { brick normal { bumps 1 scale .1 } scale .1 }", "normal { cubic normal { bumps 1 scale .1 } normal { waves 1 } }"}))},
        {"MissingPartsOfPatterns", after_default(spheres({"pigment { checker pigment { rgb x } scale .3 }", "pigment { hexagon pigment { rgb x } pigment { rgb 1 } scale .3 }", "texture { brick texture { P } scale .1 }", "texture { cubic texture { P } texture { F } }", "pigment { hexagon rgb x scale .2 }", "texture { tiles { texture { P } tile2 texture { pigment { rgb z } } } scale .3 }"}))},
        {"MissingPartsWithoutDefault", std::string(kDefaultHead) + spheres({"pigment { checker pigment { rgb x } scale .3 }", "texture { hexagon texture { pigment { rgb x } } scale .3 }", "pigment { triangular pigment { rgb x } scale .3 }"})},
    };
}

}  // namespace alidade::test
