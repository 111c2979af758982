// SPDX-License-Identifier: Apache-2.0
/// Functions of patterns and pigments, and POV-Ray's own, called while a scene is read: the same program in both.
#include "importers/pov/reader.h"

#include "core/diagnostics.h"
#include "core/image.h"
#include "tests/povray/povray.h"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <span>
#include <sstream>

using namespace alidade;
using namespace alidade::pov;
using testing::HasSubstr;

namespace {

constexpr size_t kPoints = 25;

const char* const kPatterns[] = {
    "bozo turbulence .3", "granite", "marble turbulence .4 frequency 2", "agate scale .5", "wrinkles noise_generator 1", "wood turbulence <.1,.2,.3> octaves 3 rotate 30*x", "crackle form <1,.5,0> metric 1",
    "gradient <1,2,3> sine_wave", "spiral1 4", "checker", "hexagon", "brick brick_size 1 mortar .1", "cells", "leopard", "onion phase .3", "mandel 20", "julia <.3,.5>, 15", "quilted control0 .2", "radial frequency 5",
    "spherical cubic_wave", "boxed", "dents", "spotted scale 2", "bumps warp { turbulence .5 } translate x", "cylindrical warp { repeat x }", "waves", "ripples", "magnet 1 mandel 10",
};

/// Greys of colours, which POV-Ray has in single precision.
const char* const kPigmentPatterns[] = {
    "pigment_pattern { agate color_map { [.4 rgb 0] [.6 rgb <1,.5,.2>] } scale .8 } frequency 2 translate y", "pigment_pattern { checker pigment { pigment_pattern { Declared } } pigment { rgb x } }",
};

const char* const kPigments[] = {
    "rgb <.1,.2,.3>", "rgbft <.1,.2,.3,.4,.5>", "bozo", "marble turbulence .5", "checker", "checker rgb x, rgbt <0,1,0,.5>", "brick", "hexagon rgb 1, rgb x, rgb y scale .3", "agate", "wood", "radial",
    "granite color_map { [0 rgb <1,.2,0>] [.4 rgbf <0,1,.5,.2>] [.4 rgbt <1,1,1,.3>] [.8 rgb z] } scale 2 turbulence .2",
    "gradient x pigment_map { [.2 rgb x] [.5 checker rgb y, rgb z scale .2] [.9 bozo turbulence 1] } rotate 20*y",
    "pigment_pattern { Declared scale 2 } color_map { [0 rgb x] [1 rgb <1.5,1,0>] } rotate 20", "average pigment_map { [1 granite] [2 rgb x] [.5 wood turbulence .1] }", "checker pigment { bozo }, pigment { rgb <.5,.2,.1> } scale .5", "Declared scale .4", "cubic",
};

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

std::string printed_by_us(const std::string& scene, Diagnostics& said) {
    std::string printed;
    ReadOptions options;
    options.print = [&](TextStream, const std::string& text) { printed += text; };
    read_program_text(testing::TempDir() + "scene.pov", scene, options, said);
    return printed;
}

/// Both print the same number of lines, which name what was asked, and numbers within `allowed` of each other.
void expect_same(const std::string& scene, double allowed, size_t least) {
    Diagnostics said;
    const std::vector<std::string> ours = lines_of(printed_by_us(scene, said)), theirs = lines_of(povray_debug(scene));
    ASSERT_FALSE(said.has_errors()) << said.text();
    ASSERT_EQ(ours.size(), theirs.size());
    ASSERT_GE(ours.size(), least);
    std::string about;
    for (size_t i = 0; i < ours.size(); ++i) {
        if (ours[i].find_first_not_of("-.0123456789") != std::string::npos && ours[i].find("nan") == std::string::npos) {
            about = ours[i];
            continue;
        }
        const double own = std::strtod(ours[i].c_str(), nullptr), wanted = std::strtod(theirs[i].c_str(), nullptr);
        EXPECT_TRUE(std::abs(own - wanted) <= allowed || (std::isnan(own) && std::isnan(wanted))) << about << ", line " << i << ": " << ours[i] << ", POV-Ray has " << theirs[i];
    }
}

const std::string kPrelude =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare Declared = pigment { granite color_map { [0 rgb y][1 rgb x] } }\n"
    "#macro Say(S) #debug concat(S, \"\\n\") #end\n#macro Put(V) #debug concat(str(V, 0, 17), \"\\n\") #end\n#declare R = seed(3);\n#macro Place() <rand(R), rand(R), rand(R)>*4 - 2 #end\n";

}  // namespace

namespace {

std::string calls_of(std::span<const char* const> patterns) {
    std::string scene = kPrelude;
    size_t number = 0;
    for (const char* pattern : patterns)
        scene += fmt::format("Say(\"pattern {}\") #local F = function {{ pattern {{ {} }} }} #local G = function(a, b) {{ 2*F(b, a, b) + 1 }}\n#for (I, 1, {}) #local P = Place(); Put(F(P.x, P.y, P.z)) Put(G(P.x, P.y)) #end #undef F #undef G\n", number++, pattern, kPoints);
    return scene;
}

}  // namespace

TEST(PovSpaceFunctions, PatternsAreNumbersAsInPovRay) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    expect_same(calls_of(kPatterns), 1e-9, std::size(kPatterns) * (2 * kPoints + 1));
    expect_same(calls_of(kPigmentPatterns), 5e-7, std::size(kPigmentPatterns) * (2 * kPoints + 1));
}

TEST(PovSpaceFunctions, PigmentsAreColoursAsInPovRay) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    std::string scene = kPrelude + "#include \"functions.inc\"\n";
    size_t number = 0;
    for (const char* pigment : kPigments)
        scene += fmt::format("Say(\"pigment {}\") #local F = function {{ pigment {{ {} }} }} #local G = function {{ F(x, y, z).gray + F(y, x, z).transmit*2 + F(x, x, y).red }}\n"
                             "#for (I, 1, {}) #local P = Place(); #local C = F(P.x, P.y, P.z); Put(C.red) Put(C.green) Put(C.blue) Put(C.filter) Put(C.transmit) Put(F(P.x, P.y, P.z).gray) Put(G(P.x, P.y, P.z))\n"
                             "#local C = eval_pigment(pigment {{ {} }}, P); Put(C.green) #end #undef F #undef G\n", number++, pigment, kPoints, pigment);
    expect_same(scene, 2e-7, std::size(kPigments) * (8 * kPoints + 1));
}

/// Above 1 a function begins anew, below 0 it does by the pattern's period; then its wave. Calls, loops, components, comparisons and what is no number.
const char* const kFormulas[] = {
    "function { x }", "function { x } frequency 2 phase .3", "function { x*y } sine_wave frequency 3", "function { x - y } triangle_wave", "function { x } turbulence .7", "function { x } warp { repeat 1*x } scale 2 translate .1", "function { x } frequency 0",
    "function { Two(x, y) + Two(y, Two(z, x)) }", "function { ln(x) }", "function { sqrt(x) } cubic_wave", "function { acos(x/2) + asin(y/2) }", "function { div(x*9, y) + mod(x, y) + pow(abs(x), y) }", "function { atan2(x, y) + select(x, 1, 2, 3)/7 + select(y, .3, .1) }",
    "function { (x < 0)*.3 + (x >= .5)*.2 + (x = y)*.1 + (x != z)*.05 + (x & y)*.01 + (x | y)*.02 + (x > y)*.04 + (x <= z)*.08 }", "function { sum(i, 1, 4, i*x*prod(j, 1, i, y/j))/20 + min(x, y, z) + max(x, y, z) + sum(i, 3, 1, x) + prod(k, 2, 1, y) }",
    "function { sinh(x) + cosh(y) + tanh(z) + asinh(x) + log(abs(x) + 1) + int(x*3) + ceil(y) + floor(z) + degrees(x) + radians(y) + exp(x) + sin(x)*cos(y) + tan(z) + u + v - pi }", "function { f_ridged_mf(x, y, z, .5, 2, 4, 1, 2, 2) + f_noise3d(y, x, z) }",
    "function { Dots(x*2, y, z) + Hue(x, y, z).green*Hue(y, x, z).gray + Turned(x, y, z).y + Bend(x).z }", "pigment_pattern { function { x*y } color_map { [0 rgb 1] [1 rgb <.2,.3,.4>] } }", "function { -x/y } frequency -1.5 phase -2 poly_wave 1.5",
};

/// At points, of what stands in `pattern { }` and in `pigment { }`.
TEST(PovSpaceFunctions, FunctionsAreThePatternsOfPovRay) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const std::string parts = "#include \"functions.inc\"\n#declare Two = function(a, b) { a*b - a } #declare Dots = function { pattern { function { Two(x, y) } scale .7 } } #declare Hue = function { pigment { function { x + y } color_map { [0 rgb <1,.2,0>] [1 rgb <0,.5,1>] } } }\n"
                              "#declare Turned = function { transform { rotate <10,20,30> scale 2 translate y } } #declare Bend = function { spline { natural_spline -2, <0,1,0> 0, <1,0,2> 1, <0,0,1> 2, <1,1,1> } }\n";
    const std::string calls = calls_of(kFormulas);
    expect_same(kPrelude + parts + calls.substr(kPrelude.size()), 3e-7, std::size(kFormulas) * (2 * kPoints + 1));
    std::string scene = kPrelude + parts;
    for (const char* formula : kFormulas)
        scene += fmt::format("#local F = function {{ pigment {{ {} color_map {{ [.1 rgb <1,0,0>] [.6 rgb <0,1,0>] [.9 rgb <.5,.2,.1>] }} }} }} #for (I, 1, {}) #local P = Place(); Put(F(P.x, P.y, P.z).red) Put(F(P.x, P.y, P.z).green) #end #undef F\n", formula, kPoints);
    expect_same(scene, 1e-5, std::size(kFormulas) * 2 * kPoints);
}

const char* const kPicturesOfFunctions[] = {
    "4,3 { x }", "4,3 { y }", "3,4 { z + .25 }", "4,3 { x*3 - .6 }", "5,2 { pattern { gradient x frequency 2 } }", "4,3 { pigment { gradient x color_map { [0 rgbft <.03,1.83,-.71,.3,.13>] [1 rgbft <.97,.53,.31,.1,.23>] } } }", "2.7,2.3 { x + .25 }", "1,2 { y + x + .25 }", "8,8 { f_noise3d(x*9, y*9, 0) } interpolate 2",
    "5,4 { x*y } map_type 1 once", "6,6 { pigment { granite scale .3 } } interpolate 3", "1,1 { .4 }",
};

TEST(PovSpaceFunctions, PicturesOfFunctionsArePovRays) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    std::string scene = kPrelude + "#include \"functions.inc\"\n";
    size_t number = 0;
    for (const char* picture : kPicturesOfFunctions)
        scene += fmt::format("#local F = function {{ pigment {{ image_map {{ function {0} }} }} }} #local G = function {{ pattern {{ image_pattern {{ function {0} }} }} }} #local A = function {{ pattern {{ image_pattern {{ function {0} use_alpha }} }} }}\nSay(\"picture {2}\")\n"
                             "#for (I, 1, {1}) #local P = Place(); #local C = F(P.x, P.y, P.z); Put(C.red) Put(C.green) Put(C.blue) Put(C.filter) Put(C.transmit) Put(G(P.x, P.y, P.z)) Put(A(P.x, P.y, P.z)) #end #undef F #undef G #undef A\n", picture, kPoints, number++);
    expect_same(scene, 2e-7, std::size(kPicturesOfFunctions) * (7 * kPoints + 1));
}

/// The first holds, wherever it stands.
TEST(PovSpaceFunctions, PicturesGoByTheFirstAssumedGamma) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const std::string file = testing::TempDir() + "function_picture.png";
    Picture picture(1, 1, {"R", "G", "B"});
    picture.values = {0.2f, 0.05f, 0.6f};
    ASSERT_TRUE(write_picture(file, picture));
    for (const char* settings : {"assumed_gamma 1", "assumed_gamma 2.2", "assumed_gamma 1 } global_settings { assumed_gamma 2.2", "assumed_gamma 2.2 } global_settings { assumed_gamma 1"})
        expect_same(fmt::format("#version 3.7; global_settings {{ {} }}\n#declare F = function {{ pigment {{ image_map {{ png \"{}\" }} }} }}\n"
                                "#debug concat(str(F(.5, .5, 0).red, 0, 9), \"\\n\", str(F(.5, .5, 0).green, 0, 9), \"\\n\")\n", settings, file), 1e-5, 2);
}

TEST(PovSpaceFunctions, ThoseOfTheIncludeFileAreKnown) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    std::string scene = kPrelude + "#include \"functions.inc\"\n";
    for (const char* call : {"f_noise3d(x, y, z)", "f_snoise3d(x, y, z)", "f_noise_generator(x, y, z, 3)", "f_r(x, y, z)", "f_th(x, y, z)", "f_ph(x, y, z)", "f_rounded_box(x, y, z, .1, 1, .8, 1.2)", "f_ridged_mf(x, y, z, .5, 2.1, 6, 1, 2, 2)",
                             "f_sphere(x, y, z, 1)", "f_torus(x, y, z, 1, .25)", "f_superellipsoid(x, y, z, .5, .3)"})
        scene += fmt::format("Say(\"{}\") #local F = function {{ {} }} #for (I, 1, {}) #local P = Place(); Put(F(P.x, P.y, P.z)) #end #undef F\n", call, call, kPoints);
    scene += "#declare F = function { pattern { bozo } } Put(F(.1, .2, .3)) global_settings { noise_generator 1 } Put(F(.1, .2, .3)) Put(f_noise3d(.1, .2, .3)) Put(f_noise_generator(.1, .2, .3, 2)) global_settings { noise_generator 3 } Put(f_noise3d(.1, .2, .3))\n";
    expect_same(scene, 1e-12, 11 * (kPoints + 1) + 5);
}

TEST(PovSpaceFunctions, WhatCannotBeCalledIsAnErrorWithItsPlace) {
    const std::string s = "#declare P = function { pigment { bozo } }\n#declare F = function { pattern { bozo } }\n#declare N = function { internal(76) }\n";
    const std::pair<const char*, const char*> cases[] = {
        {"#declare K = F(1, 2);", "scene.pov:4:14: error: the function takes 3 arguments, and 2 are given"},
        {"#declare K = P(1, 2);", "4:14: error: the function takes 3 arguments, and 2 are given"},
        {"#declare K = N(1, 2, 3, 4);", "4:14: error: the function takes 3 arguments, and 4 are given"},
        {"#declare M = function { internal(12) } #declare K = M(1, 2, 3);", "4:14: error: f_cubic_saddle, which is internal(12), is not modelled yet"},
        {"#declare M = function { internal(77) } #declare K = M(1, 2, 3);", "4:14: error: a function without a name, which is internal(77), is not modelled yet"},
        {"#declare M = function { P(x, y, z) } #declare K = M(1, 2, 3);", "4:25: error: this function gives a colour, and a component of it is expected"},
        {"#declare M = function { P(x, y, z) + 1 } #declare K = M(1, 2, 3);", "4:25: error: this function gives a colour"},
        {"#declare M = function { P(x, y).red } #declare K = M(1, 2, 3);", "4:25: error: the function takes 3 arguments"},
        {"#declare M = function { pattern { slope y } } #declare K = M(1, 2, 3);", "4:35: error: slope cannot stand in the pattern of a function"},
        {"#declare M = function { pattern { bozo color_map { [0 rgb 1] } } } #declare K = M(1, 2, 3);", "4:40: error: color_map cannot stand in the pattern of a function"},
        {"#declare M = function { pattern { average } } #declare K = M(1, 2, 3);", "4:25: error: the pattern average cannot stand in a function"},
        {"#declare M = function { pattern { } } #declare K = M(1, 2, 3);", "4:25: error: the name of a pattern is expected"},
        {"#declare M = function { pattern { bozo turbulence } } #declare K = M(1, 2, 3);", "error: a vector is expected as"},
        {"#declare M = function { pigment { wood scale <1,2,3> warp { repeat 0 } } } #declare K = M(1, 2, 3);", "error:"},
        {"#declare M = function { pigment { image_map { png \"a.png\" } } } #declare K = M(1, 2, 3);", "4:51: error: the picture \"a.png\" is not found"},
    };
    for (const auto& [text, words] : cases) {
        Diagnostics said;
        printed_by_us(s + text, said);
        EXPECT_THAT(said.text(), HasSubstr(words)) << text;
    }
}

TEST(PovSpaceFunctions, EndlessMapsAreAnError) {
    Diagnostics said;
    printed_by_us("#declare P = pigment { bozo } #for (I, 1, 60) #declare P = pigment { average pigment_map { [1 P] [1 P] } } #end #declare F = function { pigment { P } } #declare K = F(1, 2, 3).red;", said);
    EXPECT_THAT(said.text(), HasSubstr("error: the maps of this pigment lead to more than a million others"));
}

/// As for objects: what is asked once in a loop is not kept for ever.
TEST(PovSpaceFunctions, FunctionsThatAreGoneAreNotKept) {
    ReadOptions options;
    std::string printed;
    options.print = [&](TextStream, const std::string& text) { printed += text; };
    options.limits.items = 20'000;
    Diagnostics said;
    read_program_text("scene.pov", "#declare K = 0; #for (I, 1, 5000) #declare F = function { pigment { checker rgb 0, rgb I translate I*x } } #declare K = K + F(.5, .5, .5).red/I; #undef F #end #debug str(K, 0, 3)", options, said);
    EXPECT_EQ(said.text(), "");
    EXPECT_EQ(printed, "2500.000");
}

namespace {

/// Functions of x, y, z as formulas, with what they need: components, names, signs, and few arguments.
struct Formula {
    const char *declared, *text;
};
constexpr Formula kComponents[] = {
    {"spline { 0, <1,2,3> 1, <4,5,7> }", "G(x).x + 10*G(x).y + 100*G(x).z"}, {"spline { 0, <1,2,3> 1, <4,5,7> }", "G(y).t"}, {"spline { 0, <1,2,3> 1, <4,5,7> }", "z + G(2*x + y).t*G(x).filter"},
    {"spline { 0, <1,2> 1, <4,5> }", "G(x).z*10 + G(x).v"}, {"spline { 0, <1,2,3,4> 1, <4,5,6,7> }", "G(x).t + G(x).transmit*100"}, {"spline { 0, <1,2,3,4,5> 1, <4,5,6,7,8> }", "G(x).red*G(y).green*G(z).blue*G(x).filter*G(y).transmit"}, {"spline { 0, <1,2,3> 1, <4,5,7> }", "G(x).gray + G(y).grey*10"},
    {"spline { 0, <1,2,3> 1, <4,5,7> }", "G(x).hf + G(x).u"}, {"transform { rotate <10,20,30> translate y }", "G(x, y, z).hf"}, {"transform { rotate <10,20,30> translate y }", "G(x, y, z).t + 10*G(x, y, z).transmit"}, {"transform { rotate <10,20,30> translate y }", "G(x, y, z).grey + G(y, z, x).u*10 + G(x, y, z).v*100 + G(z, x, y).filter"},
    {"pigment { rgbft <.1,.2,.3,.4,.5> }", "G(x, y, z).x + 10*G(x, y, z).y + 100*G(x, y, z).z + 1000*G(x, y, z).t"}, {"pigment { rgbft <.1,.2,.3,.4,.5> }", "G(x, y, z).u + 10*G(x, y, z).v"}, {"pigment { rgbft <.1,.2,.3,.4,.5> }", "G(x, y, z).grey + 10*G(x, y, z).hf"}, {"pigment { gradient x }", "G(x, y, z).hf"},
    {"pattern { bozo no_bump_scale scale 2 }", "G(x, y, z)"}, {"pattern { cubic }", "G(x, y, z)"}, {"pattern { image_pattern { function 4,4 { x } use_alpha } }", "G(x, y, z)"},
    {"x", "+x"}, {"x", "x - -y"}, {"x", "x*-y*z"}, {"x", "2--x*3"}, {"x", "-(-x) + -sin(x)*-1"}, {"x", "x < -y"}, {"x", "-x = -y & +1"}, {"x", "pow(x)"}, {"x", "pow(pow(abs(x)), y)"}, {"x", "1/(x - x) > 2"},
    {"x", "sum(x, 1, 3, x) + x"}, {"x", "sum(u, 1, 3, x) + u"}, {"x", "sum(x, 1, 3, v)"}, {"x", "sum(i, 1, 3, i + sum(i, 1, 2, i) + i)"}, {"x", "Under(x) + Swapped(x, y) + Twice(x, y, z)"}, {"x", "Of_macro(x) + Of_loop[0](x) + Of_loop[2](x)"}, {"x", "Hidden(x, y)"}, {"x", "Height(x, y) + hf_"},
    {"x", "pi + clock + clock_delta + frame_number + (image_width > 0) + final_frame + initial_clock"}, {"x", "Row[1]*x + Row[Count - 3]"}, {"x", "#if (Count = 3) x #else y #end"}, {"x", "0 #for (I, 1, 3) + x*I #end"}, {"x", "Sum_of() + x"},
};

}  // namespace

/// What stands behind a function's components are its arguments; coordinates are no counters; a body means what its names meant where it stood.
TEST(PovSpaceFunctions, ComponentsAndNamesMeanWhatTheyDoInPovRay) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    std::string scene = kPrelude + "#declare Count = 0; #declare Of_loop = array[3] #while (Count < 3) #declare Of_loop[Count] = function(a) { a*10 + Count } #declare Count = Count + 1; #end #declare Row = array[2] {4, 5} #declare hf_ = 2;\n"
                        "#declare Under = function(a) { sum(a, 1, 3, a) + sum(x, 1, 3, x) + a } #declare Swapped = function(y, x) { u + 10*v } #declare Twice = function(a, b, a) { a + 10*b } #declare Height = function(hf, a) { hf*a }\n"
                        "#macro Make(Factor) #local Inner = function(a) { a*Factor } function(b) { Inner(b) + Factor } #end #declare Of_macro = Make(3) #declare Hidden = function(u, x) { u + 100*x } #macro Sum_of() x + y #end\n";
    size_t number = 0;
    for (const Formula& f : kComponents)
        scene += fmt::format("Say(\"formula {}\") #local G = function {{ {} }} #local F = function {{ {} }} #for (I, 1, {}) #local P = Place(); Put(F(P.x, P.y, P.z)) #end #undef F #undef G\n", number++, f.declared, f.text, kPoints);
    expect_same(scene, 1e-6, std::size(kComponents) * (kPoints + 1));
}

/// All of them POV-Ray refuses (probed).
TEST(PovSpaceFunctions, WhatPovRayRefusesInFunctionsIsAnError) {
    const std::string s = "#declare V = <1,2,3>; #declare C = rgb 1; #declare S = spline { 0, x 1, y } #declare A = array[1] {<1,2>} #declare P = function { pigment { bozo } } #declare W = function { spline { S } } #declare K = 1;\n";
    for (const char* body : {"true", "yes", "on", "off", "now", "version", "clock_on", "t", "V.y", "C.green", "V", "S(x).x", "A[0].x", "x;", "+-+x", "--x", "-+x", "x - - -y", "!x", "min(x)", "max(x)", "min(x, y,)", "sin(x,)", "min()", "P(x, y, z,).red", "P(x, y, z)", "W(x)", "W(x, y).x", "pow(x, y, z)",
                             "sum(K, 1, 2, K)", "sum(clock, 1, 2, 1)", "sum(1, 1, 2, 1)", "sum(i, 1, 2)", "sum(i, 1, 2, i, 3)", "internal(76);", "internal(76) + 1", "internal(1000)", "internal(K)", "x.y", "atan2(x)", "select(x, y)", "vdot(x, y)", "bitwise_and(1, 1)", "x ? y : z", "x y", "(x)(y)",
                             "pattern { square }", "pattern { triangular }", "pattern { slope y }", "pattern { aoi }", "pattern { uv_mapping bozo }", "pattern { bozo uv_mapping }", "pattern { bozo bump_size 2 }", "pattern { bozo wood }", "pattern { checker rgb 1, rgb 0 }", "pattern { bozo 2 }", "pattern { scale 2 bozo }",
                             "pattern { bozo slope_map { [0 <0,1>] [1 <1,1>] } }", "pattern { image_pattern { function 4,4 { x } filter all .2 } }", "pattern { image_map { function 4,4 { x } } }", "pattern { bozo } + x", "x + pattern { bozo }"}) {
        Diagnostics said;
        printed_by_us(s + "#declare F = function { " + body + " }\n#declare Value = F(1, 2, 3);", said);
        EXPECT_THAT(said.text(), testing::ContainsRegex("scene.pov:[23]:[0-9]+: error")) << body << said.text();
        EXPECT_THAT(said.text(), testing::Not(HasSubstr("not modelled"))) << body;
    }
    for (const char* whole : {"function() { 1 }", "function(a,) { a }", "function(, a) { a }", "function(a,, b) { a }", "function(K) { K }", "function(S) { 1 }", "function(P) { 1 }", "function(pi) { 1 }", "function(red) { 1 }", "function(clock) { 1 }", "function(sphere) { 1 }", "function(image_width) { 1 }",
                              "function(a, b, c) { pattern { bozo } }", "function(a) { pigment { bozo } }", "function(a) { transform { scale 2 } }", "function(a) { spline { S } }"}) {
        Diagnostics said;
        printed_by_us(s + "#declare F = " + whole, said);
        EXPECT_THAT(said.text(), HasSubstr("scene.pov:2:")) << whole << said.text();
    }
}
