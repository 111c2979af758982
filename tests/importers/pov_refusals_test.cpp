// SPDX-License-Identifier: Apache-2.0
/// Values that POV-Ray refuses, refused at their place: nothing that is written is left out without a word.
#include "tests/importers/pov_builders.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Refusal {
    const char *scene, *message;
};

TEST_F(PovBuilders, ValuesThatMeanNothingAreErrors) {
    for (const Refusal& r : {Refusal{"sphere { 0, 1, 2 }", "1:16: error: a value means nothing here in sphere"}, {"sphere { 0, 1 inverse 1 }", "a value means nothing here in sphere"}, {"sphere { 0, 1 no_shadow off }", "a value means nothing here in sphere"},
                             {"box { 0, 1 rotate <1,2,3> 4 }", "a value means nothing here in box"}, {"sphere { 0, 1 pigment { rgb 1 .5 } }", "1:31: error: a value means nothing here in pigment"}, {"sphere { 0, 1 pigment { bozo rgb 1 } }", "a value means nothing here in pigment"},
                             {"sphere { 0, 1 pigment { leopard 3 } }", "a value means nothing here in pigment"}, {"sphere { 0, 1 pigment { checker rgb 1 rgb 0 rgb 1 } }", "a value means nothing here in pigment"},
                             {"#declare P = pigment { rgb 1 } sphere { 0, 1 pigment { P scale 2 rgb 0 } }", "a value means nothing here in pigment"}, {"sphere { 0, 1 pigment { bozo color_map { [0 rgb 1 2] } } }", "a value means nothing here"},
                             {"sphere { 0, 1 normal { bumps .5 3 } }", "a value means nothing here in normal"}, {"sphere { 0, 1 finish { ambient 1 2 } }", "a value means nothing here in finish"}, {"background { rgb 1 3 }", "a value means nothing here in background"},
                             {"#declare L = light_source { 0 rgb 1 } light_source { L .5 }", "a value means nothing here in light_source"}, {"sphere { 0, 1 function { x } }", "a value means nothing here in sphere"}, {"light_group { sphere { 0, 1 } rgb x }", "a value means nothing here in light_group"},
                             {"light_source { 0 rgb 1 2 }", "a value means nothing here in light_source"}, {"camera { location 0 5 }", "a value means nothing here in camera"}, {"global_settings { adc_bailout 0,01 }", "a value means nothing here in global_settings"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
    for (const char* fine : {"#declare P = pigment { bozo } sphere { 0, 1 pigment { P rgb 1 } }", "sphere { 0, 1 pigment { uv_mapping rgb 1 } }", "sphere { 0, 1 pigment { red 1 green 1 } hollow on }",
                             "sphere { 0, 1 pigment { rgb 1 quick_color rgb 0 } }", "#declare P = pigment { rgb 1 } sphere { 0, 1 pigment { P bozo } }", "fog { distance 5 rgb 1 3 }", "#declare L = light_source { 0 rgb 1 } light_source { L translate x }"})
        EXPECT_EQ(said(fine), "") << fine;
}

TEST_F(PovBuilders, UvMappingBeginsAndMapsHaveEntries) {
    for (const Refusal& r : {Refusal{"sphere { 0, 1 pigment { gradient x uv_mapping } }", "1:36: error: uv_mapping must stand before the colour or the pattern"}, {"sphere { 0, 1 normal { bumps uv_mapping } }", "1:30: error: uv_mapping must stand before the pattern"},
                             {"sphere { 0, 1 pigment { gradient x color_map { } } }", "1:36: error: this color_map has no entry"}, {"sphere { 0, 1 pigment { gradient x pigment_map { } } }", "1:36: error: this pigment_map has no entry"},
                             {"sphere { 0, 1 normal { gradient x normal_map { } } }", "1:35: error: this normal_map has no entry"}, {"sphere { 0, 1 texture { gradient x texture_map { } } }", "1:36: error: this texture_map has no entry"},
                             {"sphere { 0, 1 pigment { gradient x color_map { [0] } } }", "a colour is expected as the colour of a map"}, {"sphere { 0, 1 finish { ambient } }", "warning: no colour is given as the ambient colour: it is black"},
                             {"sphere { 0, 1 finish { ambient \"1\" } }", "error: a colour is expected as the ambient colour"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
}

TEST_F(PovBuilders, WhatOtherEditorsWriteIsNamed) {
    for (const Refusal& r : {Refusal{"sphere 0, 1 }", "1:8: error: { is expected behind sphere, not the number 0"}, {"camera location y", "{ is expected behind camera, not location"}, {"#debug \u201ctext\u201d", "U+201C means nothing here: strings stand in \" \""},
                             {"sphere { 0,\u00a01 }", "1:12: error: the character U+00A0 means nothing here: it looks like a blank"}, {"sphere { \u22121, 1 }", "U+2212 means nothing here: a minus sign is -"}, {"box { \u2013y, 1 }", "U+2013 means nothing here: a minus sign is -"},
                             {"sphere { 0, 1 } \u20ac", "the character U+20AC means nothing here"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
    using namespace std::string_literals;
    EXPECT_THAT(said("\xff\xfes\0p\0h\0e\0r\0e\0"s), HasSubstr("1:1: error: the file is UTF-16: save it as UTF-8"));
    write("part.inc", "\xfe\xff\0x"s);
    EXPECT_THAT(said("#include \"part.inc\""), HasSubstr("part.inc:1:1: error: the file is UTF-16"));
}

TEST_F(PovBuilders, ObjectsThatFollowAModifierAreErrors) {
    for (const Refusal& r : {Refusal{"sphere { 0, 1 pigment { rgb 1 } plane { y, 0 } }", "1:33: error: plane cannot stand here in sphere"}, {"sphere { 0, 1 light_source { y, 1 } }", "light_source cannot stand here in sphere"},
                             {"union { sphere { 0, 1 } pigment { rgb 1 } box { 0, 1 } }", "box cannot stand here in union"}, {"object { sphere { 0, 1 } box { 0, 1 } }", "box cannot stand here in object"},
                             {"mesh { triangle { 0, x, y } sphere { 0, 1 } }", "sphere cannot stand here in mesh"}, {"transform { translate x }", "1:1: error: an object or a directive is expected, not transform"},
                             {"color_map { [0 rgb 1] }", "an object or a directive is expected, not color_map"}, {"looks_like { sphere { 0, 1 } }", "an object or a directive is expected, not looks_like"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
    EXPECT_THAT(said("media { }"), HasSubstr("is not modelled yet"));
}

TEST_F(PovBuilders, WhatIsNoPatternIsAnError) {
    for (const Refusal& r : {Refusal{"sphere { 0, 1 texture { plane { y, 1 } } }", "plane cannot stand in this texture"}, {"sphere { 0, 1 pigment { sphere { 0, 1 } } }", "sphere cannot stand in this pigment"},
                             {"sphere { 0, 1 texture { pigment { rgb 1 } no_shadow } }", "no_shadow cannot stand in this texture"}, {"sphere { 0, 1 pigment { checker color_map { [0 rgb 1] } } }", "color_map cannot stand behind the pattern checker"},
                             {"sphere { 0, 1 pigment { brick pigment_map { [0 rgb 1] } } }", "pigment_map cannot stand behind the pattern brick"}, {"sphere { 0, 1 pigment { average color_map { [0 rgb 1] } } }", "color_map cannot stand behind the pattern average"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
}

/// Of POV-Ray's errors (probed); a function that it takes has its place in the scene.
TEST_F(PovBuilders, WhatIsNoFunctionOfAPatternIsAnErrorAtItsPlace) {
    const std::string declared = "#declare F = function(a, b) { a*b }\n#declare P = function { pigment { bozo } }\n";
    for (const Refusal& r : {Refusal{"pigment { F }", "3:25: error: a declared function cannot stand here by its name"}, {"pigment { function(a, b) { a } }", "3:25: error: the function of a pattern has no parameters of its own"},
                             {"pigment { function 8, 8 { x } }", "3:25: error: a function with a size is a picture"}, {"pigment { function { pattern { bozo } } }", "3:25: error: pattern cannot stand in the function of a pattern"},
                             {"pigment { function { pigment { bozo } } }", "3:25: error: pigment cannot stand in"}, {"pigment { function { internal(76) } }", "3:25: error: internal cannot stand in"},
                             {"normal { function { F(x) } .3 }", "3:35: error: the function takes 2 arguments, and 1 are given"}, {"pigment { function { P(x, y, z) } }", "3:36: error: this function gives a colour"},
                             {"pigment { function { x*y z } }", "3:40: error: z is not expected in a function"}, {"pigment { function { } }", "3:25: error: the function ends in the middle of its expression"},
                             {"texture { function { sin(x, y) } texture_map { [0 pigment { rgb 1 }] } }", "error: sin does not take 2 arguments"}, {"pigment { function { sum(i, 1, 3) } }", "error:"}, {"pigment { function { x } .3 }", "error: a value means nothing here in pigment"}})
        EXPECT_THAT(said(declared + "sphere { 0, 1 " + r.scene + " }"), HasSubstr(r.message)) << r.scene;
    EXPECT_THAT(said("#declare Q = function 8, 8 { x }"), HasSubstr("1:14: error: a function with a size is a picture: it has no name"));
    const Scene s = scene(declared + "sphere { 0, 1 pigment { function { F(x, 2) + F(y, 3) } frequency 2 } normal { function { P(x, y, z).gray } .3 } } sphere { 0, 1 pigment { function { F(z, z) } } }");
    EXPECT_EQ(s.functions.size(), 4u) << "F is there once";
    EXPECT_EQ(s.functions.at(1).steps.size(), 7u);
    EXPECT_EQ(said(declared + "sphere { 0, 1 texture { function { F(x, y) } texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } } }"), "");
}

/// What POV-Ray refuses where a function is declared, though nobody calls it, and what it takes (probed).
TEST_F(PovBuilders, FunctionsAreLookedAtWhereTheyAreDeclared) {
    for (const char* body : {"x;", "x y", "x+", "", "(x", "sin(x, y)", "atan2(x)", "<x,y>", "x/0", "x/-0", "(x)/0", "x*1/0", "(1+1)/0", "sin(1)/0", "x/0/2", "x/A"})
        EXPECT_THAT(said(fmt::format("#declare A = 0; #declare F = function {{ {} }}", body)), testing::ContainsRegex("1:[0-9]+: error: ")) << body;
    for (const char* body : {"1/0", "pi/0", "2*3/0", "x + 1/0", "x*(1/0)", "x/(0)", "x/(-0)", "x/(1*0)", "x/(1 - 1)", "x/sin(0)", "x/(y - y)", "x/1e-20", "0/x", "x/2*0", "mod(x, 0)", "sqrt(-1)"})
        EXPECT_EQ(said(fmt::format("#declare A = 0; #declare F = function {{ {} }}", body)), "") << body;
    EXPECT_EQ(said("#include \"functions.inc\""), "");
}

TEST_F(PovBuilders, KindsOfInterpolationOfPicturesThatAreShown) {
    for (const char* kind : {"5", "-1"}) {
        EXPECT_THAT(said(fmt::format("sphere {{ 0, 1 pigment {{ image_map {{ function 4,4 {{ x }} interpolate {} }} }} }}", kind)), HasSubstr("error: there is no such kind of interpolation")) << kind;
        EXPECT_EQ(said(fmt::format("sphere {{ 0, 1 pigment {{ image_pattern {{ function 4,4 {{ x }} interpolate {} }} }} }}", kind)), "") << kind;
    }
}

/// Pictures of functions have neither a palette nor an alpha that is not told (probed).
TEST_F(PovBuilders, WhatCannotStandBehindTheFunctionOfAPicture) {
    for (const char* look : {"pigment { image_map { function 4,4 { x } filter 0, .3 } }", "pigment { image_map { function 4,4 { x } transmit 0 .3 } }", "pigment { image_map { function 4,4 { x } use_alpha } }", "normal { bump_map { function 4,4 { x } use_alpha } }",
                             "normal { bump_map { function 4,4 { x } filter all .2 } }", "texture { material_map { function 4,4 { x } use_alpha texture { } } }", "pigment { image_map { function 4,4 { x } gamma 2 } }"})
        EXPECT_THAT(said(fmt::format("sphere {{ 0, 1 {} }}", look)), testing::ContainsRegex("1:[0-9]+: error: ")) << look;
    for (const char* fine : {"pigment { image_map { function 4,4 { x } filter all .1 transmit all .2 } }", "pigment { image_map { function 4,4 { x } use_index } }", "pigment { image_pattern { function 4,4 { x } use_alpha } }", "normal { bump_map { function 4,4 { x } use_index } }"})
        EXPECT_EQ(said(fmt::format("sphere {{ 0, 1 {} }}", fine)), "") << fine;
}

/// A function of a number makes one channel, which is a third of three that are the same.
TEST_F(PovBuilders, ThePictureOfANumberIsGrey) {
    constexpr size_t kBits = 24, kColourType = 25;       // in a PNG file
    for (const auto& [function, type] : {std::pair("function 9,5 { x*y }", 0), {"function 9,5 { pattern { bozo } }", 0}, {"function 9,5 { pigment { bozo } }", 6}}) {
        const Scene s = scene(fmt::format("sphere {{ 0, 1 pigment {{ image_map {{ {} }} }} }}", function));
        ASSERT_GT(s.images.at(0).bytes.size(), kColourType);
        EXPECT_EQ(int(s.images[0].bytes[kBits]), 16) << function;
        EXPECT_EQ(int(s.images[0].bytes[kColourType]), type) << function;
    }
}

/// One warning for each call of what is not modelled, and it says what functions.inc calls it.
TEST_F(PovBuilders, FunctionsThatAreNotModelledAreNamedOnce) {
    const std::string text = said("#declare S = function { internal(63) }\nsphere { 0, 1 pigment { function { S(x, y, z) } } }");
    EXPECT_THAT(text, HasSubstr("warning: f_spikes_2d, which is internal(63), is not modelled yet"));
    EXPECT_EQ(text.find("warning"), text.rfind("warning")) << text;
}

TEST_F(PovBuilders, IndicesOfAMesh2FitItsTriangles) {
    const std::string mesh = "mesh2 { vertex_vectors { 4, 0, x, y, x+y } ", faces = "face_indices { 2, <0,1,2>, <1,3,2> } ";
    for (const Refusal& r : {Refusal{"normal_vectors { 1, z } FACES normal_indices { 3, 0, 0, 0 } }", "there are 3 normal_indices for 2 triangles"}, {"uv_vectors { 1, <1,0> } FACES uv_indices { 1, 0 } }", "there are 1 uv_indices for 2 triangles"},
                             {"uv_vectors { 1, <1,0> } FACES }", "there are 1 uv_vectors for 4 vertices: uv_indices are missing"}}) {
        std::string text = mesh + r.scene;
        text.replace(text.find("FACES"), 5, faces);
        EXPECT_THAT(said(text), HasSubstr(r.message)) << text;
    }
    EXPECT_EQ(said(mesh + "normal_vectors { 1, z } " + faces + "normal_indices { 1, 0 } }"), "");
}

/// What is not modelled is left out with all its values, and a warning.
TEST_F(PovBuilders, PatternsThatAreNotModelledAreNoErrors) {
    for (const char* text : {"#declare S = function { internal(63) } sphere { 0, 1 pigment { rgb 1 } normal { function { S(x, y, z) } .5 } }", "#declare S = function { pattern { object { sphere { 0, 1 } } } } sphere { 0, 1 normal { function { x*S(x, y, z) } } }", "sphere { 0, 1 normal { slope { y } .5 } }", "sphere { 0, 1 normal { object { sphere { 0, 1 } }, .5 } }",
                             "#declare S = function { internal(63) } sphere { 0, 1 normal { bumps normal_map { [0 function { S(x, y, z) } .3] [1 bumps] } } }", "#declare S = function { internal(63) } sphere { 0, 1 texture { function { S(x, y, z) } texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } } }",
                             "#declare S = function { internal(63) } #default { normal { function { S(x, y, z) } .4 } } sphere { 0, 1 }", "#declare S = function { internal(63) } #declare P = function { pigment { function { S(x, y, z) } } } sphere { 0, 1 pigment { function { P(x, y, z).red } } }"}) {
        EXPECT_THAT(said(text), HasSubstr("is not modelled yet")) << text;
        EXPECT_THAT(said(text), Not(HasSubstr("error"))) << text;
    }
}

/// Colours where old scenes have them: POV-Ray says that it ignores them.
TEST_F(PovBuilders, ColoursBesideObjectsAreIgnored) {
    const std::string declared = "#declare C = rgb x; #declare L = light_source { 5 rgb 1 } ";
    for (const char* text : {"sphere { 0, 1 color red 1 pigment { rgb 1 } }", "union { sphere { 0, 1 C } color C }", "light_source { L rgb .2 }", "light_source { L rgb .5 translate x rgb .2 }", "object { light_source { L rgb .5 } }"}) {
        EXPECT_THAT(said(declared + text), HasSubstr("is ignored, as in POV-Ray")) << text;
        EXPECT_THAT(said(declared + text), Not(HasSubstr("error"))) << text;
    }
    EXPECT_EQ(scene(declared + "light_source { L rgb .2 }").lights.at(0).intensity, Color(1));
}

TEST_F(PovBuilders, AnInsideNeedsAnOutside) {
    for (const char* text : {"sphere { 0, 1 interior_texture { pigment { rgb 1 } } }", "union { sphere { 0, 1 } box { 2, 3 } interior_texture { pigment { rgb 1 } } pigment { rgb 0 } } mesh { triangle { 0, x, y } interior_texture { } }"})
        EXPECT_THAT(said(text), HasSubstr("an interior_texture needs a texture beside it")) << text;
    const Scene s = scene("#declare S = sphere { 0, 1 pigment { rgb x } } union { object { S interior_texture { pigment { rgb y } } } box { 2, 3 } pigment { rgb z } interior_texture { pigment { rgb 1 } } }");
    EXPECT_EQ(std::count_if(s.nodes.begin(), s.nodes.end(), [](const Node& n) { return n.inside_material.has_value(); }), 2);
}

TEST_F(PovBuilders, WhatStandsInAnotherKindOfBlockIsAnError) {
    const std::string declared = "#declare T = texture { pigment { rgb x } } #declare P = pigment { rgb 1 } #declare M = material { texture { T } } #declare S = sphere { 0, 1 } #declare N = normal { bumps 1 } ";
    for (const Refusal& r : {Refusal{"sphere { 0, 1 pigment { T } }", "the identifier of a texture cannot stand in pigment"}, {"sphere { 0, 1 finish { P } }", "the identifier of a pigment cannot stand in finish"}, {"sphere { 0, 1 pigment { N } }", "the identifier of a normal cannot stand in pigment"},
                             {"sphere { 0, 1 normal { P } }", "the identifier of a pigment cannot stand in normal"}, {"sphere { 0, 1 texture { M } }", "the identifier of a material cannot stand in texture"}, {"sphere { 0, 1 texture { S } }", "the identifier of a sphere cannot stand in texture"},
                             {"sphere { 0, 1 material { P } }", "the identifier of a pigment cannot stand in material"}, {"sphere { 0, 1 interior { T } }", "the identifier of a texture cannot stand in interior"}, {"sphere { 0, 1 material { pigment { rgb 1 } } }", "a pigment cannot stand in material"},
                             {"mesh { triangle { 0, x, y pigment { rgb 1 } } }", "a pigment cannot stand in triangle"}})
        EXPECT_THAT(said(declared + r.scene), HasSubstr(r.message)) << r.scene;
    for (const char* fine : {"sphere { 0, 1 texture { P } }", "sphere { 0, 1 texture { N } }", "sphere { 0, 1 material { M } }", "mesh { triangle { 0, x, y texture { T } } }", "sphere { 0, 1 pigment { P } normal { N } }"}) EXPECT_EQ(said(declared + fine), "") << fine;
}

TEST_F(PovBuilders, VectorsAreNotLongerThanWhatIsAskedFor) {
    for (const Refusal& r : {Refusal{"sphere { <1,2,3,4>, 1 }", "1:10: error: a vector of 3 is expected as the centre of a sphere, not a vector of 4"}, {"#declare C = rgb 1; sphere { C, 1 }", "not a colour"}, {"sphere { 0, 1 translate <1,2,3,4> }", "a vector of 3 is expected behind translate"},
                             {"sphere { 0, 1 scale rgb 1 }", "not a colour"}, {"#declare L = vlength(<1,2,3,4>);", "a vector of 3 is expected, not a vector of 4"}, {"#declare C = rgb 1; #declare L = vnormalize(C);", "not a colour"},
                             {"mesh { triangle { 0, x, y uv_vectors <0,0,0>, <1,0>, <0,1> } }", "a vector of 2 is expected as texture coordinates, not a vector of 3"}, {"sphere { 0, 1 pigment { julia x, 5 } }", "a vector of 2 is expected"},
                             {"sphere { 0, 1 pigment { bozo turbulence <1,1,1,1> } }", "not a vector of 4"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
    for (const char* fine : {"sphere { <1,2>, 1 }", "sphere { 1, 1 translate <1,2> }", "mesh { triangle { 0, x, y uv_vectors 0, u, <0,1> } }", "#declare C = rgb 1; sphere { <C.x, C.y, C.z>, 1 }"}) EXPECT_EQ(said(fine), "") << fine;
}

/// POV-Ray says the same.
TEST_F(PovBuilders, WhatIsTooManyOrTooFewIsTold) {
    using namespace std::string_literals;
    for (const Refusal& r : {Refusal{"camera { location y look_at 0 }\ncamera { location x look_at 0 }", "2:1: warning: the scene has more than one camera: the last one is used"}, {"union { sphere { 0, 1 } }", "1:1: warning: union has fewer than two parts"},
                             {"difference { sphere { 0, 1 } pigment { rgb 1 } }", "1:1: warning: difference has fewer than two parts"}, {"merge { }", "merge has fewer than two parts"}, {"light { 0, 1 }", "did you mean light_source?"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
    EXPECT_THAT(said("union { julia_fractal { 0 } sphere { 1, 1 } }"), Not(HasSubstr("fewer")));
    EXPECT_EQ(said("union { sphere { 0, 1 } sphere { 1, 1 } } #declare S = sphere { 0, 1 } union { S }"), "");
    EXPECT_THAT(said("sphere { 0,\0 1 }"s), HasSubstr("1:12: warning: a byte 0 is taken as a blank"));
}

/// POV-Ray says the first two with their lines, and of the others the line of the word that is named here.
TEST_F(PovBuilders, WhatIsNotClosedIsToldWithWhereItShows) {
    for (const Refusal& r : {Refusal{"plane { y, 0 pigment { gradient x color_map { [0 rgb 1\n[1 rgb 0] } } }", "2:1: error: ] is expected, not ["}, {"plane { y, 0 pigment { gradient x color_map { [0 rgb 1]\n[1 rgb 0 } } }\nsphere { 0, 1 }", "2:10: error: ] is expected, not }"},
                             {"plane { y, 0 pigment { gradient x color_map { [0 rgb 1] [1 rgb 0 } } }", "hint: its [ is at "}, {"sphere { 0, 1 pigment { rgb 1 }\n camera { location -3*z }", "hint: } is missing, perhaps before camera at "},
                             {"sphere { 0, 1 pigment { rgb 1 }\n camera { location -3*z }", ":2:2\n"}, {"sphere { 0, 1 pigment { rgb 1\n finish { ambient 1 } }\ncamera { location z }", "perhaps before finish at "},
                             {"union {\n sphere { 0, 1 pigment { rgb 1 }\n}\nlight_source { 0, 1 }\nbox { 0, 1 }\nbackground { rgb 1 }", "perhaps before background at "},
                             {"sphere { 0, 1\nbox { 0, 1 }", "perhaps before box at "}, {"union { sphere { 0, 1 }", "hint: } is missing\n"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
}

/// Each was put to POV-Ray, which may leave commas out, and takes them between values alone.
TEST_F(PovBuilders, CommasStandBetweenValues) {
    for (const char* refused : {"sphere { 0,, 1 }", "sphere { 0, 1, pigment { rgb 1 } }", "sphere { 0, 1, }", "sphere { 0, 1 scale 2, }", "sphere { 0, 1 translate x, rotate y }", "disc { 0, z, 1, .2, pigment { rgb 1 } }", "triangle { -x, x, y, pigment { rgb 1 } }",
                                "mesh { triangle { -x, x, y }, triangle { -x, x, -y } }", "mesh { triangle { -x, x, y, } }", "union { sphere { 0, 1 }, sphere { 1, 1 } }", "sphere { 0, 1 pigment { rgb 1, } }", "sphere { 0, 1 pigment { gradient x, color_map { [0 rgb 1] [1 rgb 0] } } }",
                                "sphere { 0, 1 pigment { gradient x color_map { [0 rgb 1], [1 rgb 0] } } }", "sphere { 0, 1 pigment { gradient x color_map { [0 rgb 1,] [1 rgb 0] } } }", "sphere { 0, 1 finish { ambient 1, diffuse 0 } }", "sphere { 0, 1 finish { ambient 1, } }",
                                "light_source { 0, 1, shadowless }", "light_source { 0, 1 area_light x, y, 2, 2, adaptive 1 }", "camera { location -5*z, look_at 0 }", "background { rgb 1, }", "global_settings { max_trace_level 5, }",
                                "sphere { 0, 1 normal { bumps .5, scale .1 } }", "sphere { 0, 1 pigment { brick rgb 1, rgb 0, brick_size 2, mortar .1 } }", "mesh2 { vertex_vectors { 3,, -x, x, y } face_indices { 1, <0,1,2> } }",
                                "sphere { 0, 1 interior { ior 1.5, caustics 1 } }", "rainbow { angle 42, width 5 distance 10 direction z }", "sphere { 0, 1 transform { translate x, scale 2 } }"})
        EXPECT_THAT(said(refused), HasSubstr("a value is expected be")) << refused;
    for (const char* fine : {"mesh2 { vertex_vectors { 3, -x, x, y, } face_indices { 1, <0,1,2>, } pigment { rgb 1 } }", "disc { 0, z, 1, pigment { rgb 1 } }", "disc { 0, z, 1, }", "sphere { 0, 1 pigment { checker rgb 1, rgb 0, } }", "sphere { 0, 1 pigment { hexagon rgb 1, rgb 0, rgb 1, scale 2 } }",
                             "sphere { 0, 1 pigment { checker pigment { rgb 1 }, pigment { rgb 0 }, } }", "sphere { 0, 1 pigment { object { sphere { 0, 1 } pigment { rgb 1 }, pigment { rgb 0 } } } }", "sphere { 0, 1 pigment { object { box { -1, 1 } rgb 1, rgb 0, } } }", "sphere { 0, 1 finish { diffuse .5, phong 1 } }", "sphere { 0, 1 finish { diffuse .5, } }", "sphere { 0, 1 finish { reflection { .5, falloff 1 } } }", "sphere { 0, 1 normal { bumps, scale 2 } }", "sphere { 0, 1 normal { gradient x, scale 2 } }", "sphere { 0, 1 normal { spiral1 3, scale 2 } }", "sphere { 0, 1 normal { magnet 1 mandel 20, scale 2 } }", "sphere { 0, 1 normal { julia <.1, .2>, 20, scale 2 } }",
                             "sphere { 0, 1 normal { function { x }, scale .3 } }", "sphere { 0, 1 normal { pigment_pattern { bozo }, scale 2 } }", "sphere { 0, 1 normal { object { sphere { 0, 1 } }, scale 2 } }", "sphere { 0, 1 pigment { gradient x pigment_map { [0 checker rgb 1, rgb 0,] [1 rgb 0] } } }",
                             "camera { spherical location -5*z angle 40, look_at 0 }", "sphere { 0, 1 pigment { gradient x color_map { [0, rgb 1] [1, color rgb 0] } } }", "sphere { <0, 0, 0> 1 }", "light_source { 0, color rgb 1 }", "polynomial { 2, xyz(2,0,0):1, xyz(0,0,0):-1, }"})
        EXPECT_THAT(said(fine), Not(HasSubstr("error"))) << fine;
}

/// POV-Ray says the same of each.
TEST_F(PovBuilders, NamesStandWherePovRayTakesThem) {
    const std::string declared = "#declare S = sphere { 0, 1 } #declare B = box { -1, 1 } #declare T = texture { pigment { rgb 1 } } #declare Tr = transform { scale 2 } #declare C = camera { location -5*z look_at 0 } #declare P = pigment { rgb 1 } #declare A = array[2] { S, B } ";
    for (const Refusal& r : {Refusal{"union { S B }", "the name of an object that begins a union stands alone"}, {"union { S S pigment { rgb 1 } }", "hint: write object { NAME } for a part"}, {"union { B object { S } }", "begins a union"}, {"difference { S sphere { 1, 1 } }", "begins a difference"},
                             {"#macro U(a, b) union { a b } #end U(S, B)", "begins a union"}, {"union { A[0] A[1] }", "begins a union"}, {"camera { C angle 30 }", "nothing but transformations"}, {"camera { C location x }", "nothing but transformations"}, {"camera { C normal { bumps 1 } }", "nothing but transformations"},
                             {"camera { location x C }", "at the beginning of a camera alone"}, {"camera { C C }", "at the beginning of a camera alone"}, {"object { S Tr }", "transform is expected before the name"}, {"sphere { 0, 1 Tr }", "transform is expected before"}, {"object { S texture { T Tr } }", "transform is expected before"},
                             {"object { S pigment { checker Tr } }", "transform is expected before"}, {"camera { location x Tr }", "transform is expected before"}, {"mesh { triangle { -x, x, y texture { pigment { rgb 1 } } } }", "the texture of a triangle is texture { NAME }"},
                             {"mesh { triangle { -x, x, y texture { T scale 2 } } }", "without a word more"}, {"mesh { triangle { -x, x, y texture { T T } } }", "without a word more"}, {"mesh { triangle { -x, x, y T } }", "the texture of a triangle"}, {"mesh { triangle { -x, x, y texture { P } } }", "the texture of a triangle"},
                             {"mesh { triangle { -x, x, y texture { } } }", "the texture of a triangle"}})
        EXPECT_THAT(said(declared + r.scene), HasSubstr(r.message)) << r.scene;
    for (const char* fine : {"union { S }", "union { S scale 2 pigment { rgb 1 } }", "union { object { S } B }", "difference { object { S } B }", "merge { sphere { 0, 1 } S box { -1, 1 } }", "#macro M() S #end union { object { B } M() }", "light_group { S B light_source { 0, 1 } }", "union { object { S } A[1] }",
                             "camera { C translate x transform Tr transform { Tr scale 2 } }", "#version 3.1; camera { C angle 30 }", "object { S transform Tr }", "object { S transform { Tr translate y Tr } }", "object { S transform { translate y transform Tr inverse } }", "mesh { triangle { -x, x, y texture { T } texture { T } } }",
                             "mesh2 { vertex_vectors { 3, -x, x, y } texture_list { 1, texture { T scale 2 } } face_indices { 1, <0,1,2>, 0 } }", "triangle { -x, x, y texture { pigment { rgb 1 } } }"})
        EXPECT_THAT(said(declared + fine), Not(HasSubstr("error"))) << fine;
}

TEST_F(PovBuilders, ElementsOfAnArrayAreOfOneKind) {
    const std::string declared = "#declare S = sphere { 0, 1 } #declare T = texture { pigment { rgb 1 } } ";
    for (const Refusal& r : {Refusal{"#declare A = array[2] { x, rgb 1 }", "this is a colour, and the first one was a vector of 3"}, {"#declare A = array[2] { 1, x }", "this is a vector of 3, and the first one was a float"}, {"#declare A = array[2]; #declare A[0] = \"a\"; #declare A[1] = 1;", "this is a float, and the first one was a string"},
                             {"#declare A = array[2]; #declare A[0] = <1,1>; #declare A[1] = x;", "the first one was a vector of 2"}, {"#declare A = array[2] { 1, 2 } #declare A[0] = x;", "of one kind"}, {"#declare A = array[2]; #declare A[0] = 1; #undef A[0] #declare A[1] = x;", "of one kind"},
                             {"#declare A = array[2][2] { { 1, 2 }, { x, y } }", "of one kind"}, {"#declare A = array[2] { array[1] { 1 }, 1 }", "the first one was an array"}, {"#declare A = array[2] { S, T }", "this is a texture, and the first one was an object"}, {"#declare A = array[2] { 1, function { y } }", "of one kind"},
                             {"#declare A = array[1] { 1 } #declare B = A; #declare B[0] = x;", "of one kind"}, {"#declare A = array[2] { camera { location x }, S }", "this is an object, and the first one was a camera"}})
        EXPECT_THAT(said(declared + r.scene), HasSubstr(r.message)) << r.scene;
    for (const char* fine : {"#declare A = array[2] { 1, 2 } #declare A = x;", "#declare A = array[2] { array[1] { 1 }, array[1] { x } }", "#declare A = array[2] { S, light_source { 0, 1 } }", "#declare A = array[2] { <1,1,1,1,1>, rgb 1 }", "#declare A = array[2] { function { x }, function { y } }", "#declare A = array[2] { 1, x.y }",
                             "#declare A = array[2] { rgb 1, rgbt 1 }", "#declare A = array[2]; #declare A[0] = color_map { [0 rgb 1] }; #declare A[1] = colour_map { [0 rgb 1] };"})
        EXPECT_THAT(said(declared + fine), Not(HasSubstr("error"))) << fine;
}

TEST_F(PovBuilders, ShapesThatAreNotFiniteAreNamedByTheirKind) {
    for (const Refusal& r : {Refusal{"\nsphere { 0, 1e999 }", "2:1: warning: sphere has a number that is not finite: it is left out"}, {"box { 0, 1e999 }", "1:1: warning: box has a number"}, {"torus { 1, 1e999 }", "torus has a number"},
                             {"sphere { 0, 0 }", "1:1: warning: a sphere of radius 0: it cannot be seen"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
}

TEST_F(PovBuilders, SurroundingsThatAreNotFiniteHaveTheirPlace) {
    for (const Refusal& r : {Refusal{"\nglobal_settings { adc_bailout 1e999 }", "2:1: error: global_settings has a number that is not finite"}, {"background { rgb 1e999 }", "1:1: error: background has a number that is not finite"},
                             {"fog { distance 1 } fog { distance 1e999 }", "1:20: error: fog has a number that is not finite"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
}

/// POV-Ray looks into what clips and bounds, but not into light groups.
TEST_F(PovBuilders, WhatClipsOrBoundsHasNoTextureAndNoPatches) {
    const std::string declared = "#declare T = sphere { 0, 1 pigment { rgb 1 } } #declare M = mesh { triangle { 0, x, y } triangle { 0, x, z } inside_vector y } #declare S = sphere { 0, 1 }\n";
    for (const std::string word : {"clipped_by", "bounded_by"}) {
        const auto limited = [&](const std::string& by) { return said(declared + "sphere { 0, 1 " + word + " { " + by + " } }"); };
        for (const char* by : {"sphere { 0, 1 pigment { rgb 1 } }", "sphere { 0, 1 finish { phong 1 } }", "sphere { 0, 1 material { texture { } } }", "object { T scale 2 }", "object { S texture { } }", "union { object { T } sphere { 0, 2 } }",
                               "intersection { sphere { 0, 1 } box { 0, 1 texture { } translate x } }", "triangle { 0, x, y }", "mesh { triangle { 0, x, y } }", "union { sphere { 0, 1 } triangle { 0, x, y } }", "light_source { 0, 1 }"})
            EXPECT_THAT(limited(by), HasSubstr("2:28: error: what clips or bounds an object has no texture")) << word << ' ' << by;
        for (const char* by : {"S", "object { S interior { ior 2 } no_shadow }", "disc { 0, y, 1 }", "polygon { 4, 0, x, y, 0 }", "M", "light_group { light_source { 0, 1 } object { T } }", "sphere { 0, 1 } box { -1, 1 } scale 2"}) EXPECT_EQ(limited(by), "") << word << ' ' << by;
        EXPECT_THAT(limited("S no_shadow"), HasSubstr("2:30: error: no_shadow cannot stand in " + word));
        EXPECT_THAT(limited("S inverse"), HasSubstr("inverse cannot stand in " + word));
        EXPECT_THAT(limited(""), HasSubstr("2:15: error: an object is expected in " + word));
        EXPECT_THAT(limited("scale 2"), HasSubstr("2:15: error: an object is expected in " + word));
        EXPECT_THAT(limited(word), HasSubstr("2:28: error: " + word + " cannot stand in " + word));
        EXPECT_THAT(limited("S scale 2 object { S }"), HasSubstr("object cannot stand behind what moves the objects in " + word));
        const std::string other = word == "clipped_by" ? "bounded_by" : "clipped_by";
        EXPECT_EQ(limited(other), "");
        EXPECT_THAT(limited(other + " scale 2"), HasSubstr("2:39: error: what " + word + " names stands alone in it"));
        EXPECT_THAT(limited("S " + other), HasSubstr("2:30: error: " + other + " cannot stand in " + word));
    }
}

TEST_F(PovBuilders, ListsOfTexturesAreOfBlocksInAMesh2AndOfNamesInATriangle) {
    const std::string declared = "#declare A = texture { } #declare B = texture { pigment { rgb 1 } }\n";
    EXPECT_THAT(said(declared + "mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 2, A, B } face_indices { 1, <0,1,2>, 0, 1, 1 } }"), HasSubstr("2:57: error: a mesh2's texture_list holds textures"));
    EXPECT_THAT(said(declared + "mesh { triangle { 0, x, y texture_list { A texture { B } A } } }"), HasSubstr("2:44: error: a triangle's texture_list holds names of textures"));
    EXPECT_EQ(said(declared + "mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 2, texture { A }, texture { B } } face_indices { 1, <0,1,2>, 0, 1, 1 } } mesh { triangle { 0, x, y texture_list { A B A } } }"), "");
}

/// POV-Ray takes it where a second colour may stand.
TEST_F(PovBuilders, AColorBeforeAColorIsTold) { EXPECT_THAT(said("fog { distance 3 color color rgb z }"), HasSubstr("1:24: warning: color stands twice: behind the first there is no colour, which is black")); }

/// A file that was cut off is no smaller mesh.
TEST_F(PovBuilders, ListsOfMeshesHaveWhatTheySay) {
    for (const Refusal& r : {Refusal{"mesh2 { vertex_vectors { 4, 0, x, y } face_indices { 1, <0,1,2> } }", "1:26: error: vertex_vectors says that it has 4, and has 3"}, {"mesh2 { vertex_vectors { 3, 0, x, y, z } face_indices { 1, <0,1,2> } }", "vertex_vectors says that it has 3, and has 4"},
                             {"mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 2, <0,1,2> } }", "face_indices says that it has 2, and has 1"}, {"mesh2 { vertex_vectors { 3, 0, x, y } uv_vectors { 2, 0, 1, u } face_indices { 1, <0,1,2> } }", "uv_vectors says that it has 2, and has 3"},
                             {"mesh2 { vertex_vectors { 3, 0, x, y } normal_vectors { 3, x, y, z } face_indices { 1, <0,1,2> } normal_indices { 2, <0,1,2> } }", "normal_indices says that it has 2, and has 1"}, {"mesh2 { vertex_vectors { x, y, z } face_indices { 1, <0,1,2> } }", "a number is expected as how many there are"},
                             {"mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 2, texture { pigment { rgb 1 } } } face_indices { 1, <0,1,2>, 0 } }", "texture_list says that it has 2, and has 1"}, {"mesh { triangle { 0, x, y texture_list { 3, texture { pigment { rgb 1 } } } } }", "a value means nothing here in texture_list"}})
        EXPECT_THAT(said(r.scene), HasSubstr(r.message)) << r.scene;
    EXPECT_EQ(said("mesh2 { vertex_vectors { 3.7, 0, x, y, } face_indices { 1 <0,1,2> } }"), "");
}

}  // namespace
}  // namespace alidade
