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
        {"#declare M = function { internal(12) } #declare K = M(1, 2, 3);", "4:14: error: internal(12) is not modelled yet"},
        {"#declare M = function { P(x, y, z) } #declare K = M(1, 2, 3);", "4:25: error: this function gives a colour, and a component of it is expected"},
        {"#declare M = function { P(x, y, z) + 1 } #declare K = M(1, 2, 3);", "4:25: error: this function gives a colour"},
        {"#declare M = function { P(x, y).red } #declare K = M(1, 2, 3);", "4:25: error: the function takes 3 arguments"},
        {"#declare M = function { pattern { slope y } } #declare K = M(1, 2, 3);", "4:35: error: slope in the pattern of a function is not modelled"},
        {"#declare M = function { pattern { bozo color_map { [0 rgb 1] } } } #declare K = M(1, 2, 3);", "4:40: error: color_map in the pattern of a function is not modelled"},
        {"#declare M = function { pattern { average } } #declare K = M(1, 2, 3);", "4:25: error: the pattern average has no number"},
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
