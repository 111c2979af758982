// SPDX-License-Identifier: Apache-2.0
/// Blocks of the scene language -> the scene graph. (Whether they look as in POV-Ray is asked by tests/scenes/pov_pictures_test.cpp.)
#include "scene/queries.h"
#include "tests/importers/pov_builders.h"
#include "tests/povray/povray.h"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>

namespace alidade {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(PovBuilders, ACameraIsPovRaysOwnWithoutAnyWord) {
    const Camera c = scene("sphere { 0, 1 }").cameras.at(0);
    expect_near(c.location, Vec3(0));
    expect_near(c.direction, {0, 0, 1});
    expect_near(c.right, {1.33, 0, 0});
    expect_near(c.up, {0, 1, 0});
    EXPECT_EQ(c.fit, Fit::stretch);
}

TEST_F(PovBuilders, AnglesFillTheWindowAndLookAtKeepsItsHandedness) {
    const Camera c = scene("camera { look_at <0,0,5> angle 90 right -2*x location <0,0,1> }").cameras.at(0);
    expect_near(c.direction, {0, 0, 1});          // |right| / (2 tan 45)
    expect_near(c.right, {-2, 0, 0});
    const Camera turned = scene("camera { location <1,2,3> look_at <4,2,3> }").cameras.at(0);
    expect_near(turned.direction, {1, 0, 0});
    expect_near(turned.right, {0, 0, -1.33});
    expect_near(turned.up, {0, 1, 0});
    const Camera flat = scene("camera { orthographic location -4*z look_at z }").cameras.at(0);
    expect_near(flat.right, {1.33 * 5, 0, 0});    // without right and up the window has the distance of what is looked at
}

/// Below 3.5 what stands behind a word does not change what it has done.
TEST_F(PovBuilders, WordsOfOldCamerasActWhereTheyStand) {
    const Camera early = scene("#version 3.1; camera { look_at <5,0,0> location <0,0,-5> }").cameras.at(0);
    expect_near(early.direction, {1, 0, 0});
    const Camera angle = scene("#version 3.1; camera { right 2*x angle 90 right 4*x translate y look_at <0,1,5> }").cameras.at(0);
    expect_near(angle.direction, {0, 0, 1});          // the angle took 2*x
    expect_near(angle.location, {0, 1, 0});           // and look_at where the camera had been moved to
    expect_near(scene("#version 3.1; camera { location -4*z look_at z orthographic }").cameras.at(0).right, {1.33 * 5, 0, 0});
    expect_near(scene("#version 3.1; camera { orthographic location -4*z look_at z }").cameras.at(0).right, {1.33, 0, 0});
    const std::string nested = "#version 3.5; #declare C = camera { look_at <5,0,0> location <5,0,-5> } #version 3.1; ";
    expect_near(scene(nested + "camera { C location 0 }").cameras.at(0).direction, {0, 0, 1});   // C was finished by the rules of its own version
    EXPECT_THAT(said("#version 3.1; camera { angle 200 fisheye }"), HasSubstr("less than 180 degrees"));
    EXPECT_EQ(scene("#version 3.1; camera { angle 100 fisheye }").cameras.at(0).angle, 100);
}

/// Nearer than 1e-5 (probed), though the direction has a length.
TEST_F(PovBuilders, ACameraCannotLookAtItsOwnPlace) {
    for (const char* version : {"", "#version 3.1; "})
        for (const auto& [at, refused] : {std::pair("<0,0,5e-6>", true), {"<5e-6,5e-6,5e-6>", true}, {"<8e-6,8e-6,0>", false}, {"<1.1e-5,0,0>", false}})
            EXPECT_EQ(said(fmt::format("{}sphere {{ 9, 1 }} camera {{ location 0 look_at {} }}", version, at)).find("look_at is the camera's location") != std::string::npos, refused) << at;
}

TEST_F(PovBuilders, PolynomialsHaveAllTheirCoefficients) {
    const Scene s = scene("quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 } poly { 2, <1,2,3,4,5,6,7,8,9,10> sturm } cubic { <1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20> }");
    const Quadric& q = std::get<Quadric>(s.shapes.at(0).geometry);
    EXPECT_EQ(q.products, Vec3(4, 5, 6));
    EXPECT_EQ(q.constant, 10);
    EXPECT_EQ(std::get<Polynomial>(s.shapes.at(1).geometry).coefficients.back(), 10);
    EXPECT_EQ(std::get<Polynomial>(s.shapes.at(2).geometry).order, 3);
    EXPECT_THAT(said("quartic { <1,2,3,4,5,6> }"), HasSubstr("s.pov:1:11: error: a polynomial of order 4 has 35 coefficients, and here are 6"));
    for (const char* term : {"xyz(3,0,0): 1", "xyz(1,1,1): 1", "xyz(-1,0,0): 1", "xyz(1/0.3e-300,0,0): 1"})
        EXPECT_THAT(said(fmt::format("polynomial {{ 2, {} }}", term).c_str()), HasSubstr("xyz(x, y, z) of a polynomial of order 2 has powers from 0 that add up to 2 at most")) << term;
    EXPECT_THAT(said("polynomial { 2, xyz(2,0,0) 1 }"), HasSubstr("expected"));
    EXPECT_THAT(said("poly { 36, <1,2,3,4,5,6> }"), HasSubstr("the order of a polynomial is 2 to 35, and here it is 36"));
    EXPECT_THAT(said("cubic { 1 }"), HasSubstr("the 20 coefficients of a polynomial are expected"));
}

TEST_F(PovBuilders, PolygonsAreLoopsThatEndWhereTheyBegan) {
    const Scene s = scene("polygon { 9, <0,0>, <3,0>, <0,3>, <0,0>, <.5,.5>, <1,.5>, <.5,1>, <.5,.5>, <0,0> }");
    const Polygon& p = std::get<Polygon>(s.shapes.at(0).geometry);
    ASSERT_EQ(p.loops.size(), 3u);
    EXPECT_EQ(p.loops[0].size(), 3u);
    EXPECT_EQ(p.loops[1].front(), Vec3(.5, .5, 0));
    EXPECT_THAT(said("polygon { 3, <0,0>, <3,0>, <0,3> }"), HasSubstr("is not closed"));
    EXPECT_THAT(said("polygon { 5, <0,0>, <1,0>, <1,1,1e-8>, <0,1>, <0,0> }"), HasSubstr("not in one plane"));
    EXPECT_THAT(said("polygon { 2, <0,0>, <1,0> }"), HasSubstr("at least three points"));
}

/// POV-Ray draws neither of those with a normal along the plane, of length 0 or on the other side, unless they are in a mesh.
TEST_F(PovBuilders, ASmoothTriangleAloneHasItsNormalsOnOneSide) {
    const auto triangles = [&](const std::string& text) { return std::get<Mesh>(scene(text).shapes.at(0).geometry).triangles.size(); };
    const auto triangle = [](const std::string& third) { return "smooth_triangle { <-1,-1,0>, -z, <1,-1,0>, <0,1,-.1>, <0,1,0>, " + third + " }"; };
    EXPECT_EQ(triangles(triangle("<0,1,-1e-9>")), 1u);
    for (const char* aside : {"z", "y", "0", "<0,1,1e-9>"}) {
        EXPECT_EQ(triangles(triangle(aside)), 0u) << aside;
        EXPECT_THAT(said(triangle(aside)), HasSubstr("not all on one side")) << aside;
    }
    EXPECT_EQ(triangles("mesh { " + triangle("z") + " }"), 1u);
}

TEST_F(PovBuilders, ANormalWithoutLengthInAMeshIsX) {
    const Scene s = scene("mesh { smooth_triangle { <-1,-1,0>, 0, <1,-1,0>, -z, <0,1,0>, -z } } mesh2 { vertex_vectors { 3, 0, x, y } normal_vectors { 3, -z, 0, -z } face_indices { 1, <0,1,2> } }");
    EXPECT_EQ(std::get<Mesh>(s.shapes.at(0).geometry).normals.values.at(0), Vec3f(1, 0, 0));
    EXPECT_EQ(std::get<Mesh>(s.shapes.at(1).geometry).normals.values.at(1), Vec3f(1, 0, 0));
}

/// Widths of timrom.ttf, whose em is 1000: A is 750 wide, of which 6 before its ink, a pair A V is 187 nearer.
TEST_F(PovBuilders, LettersOfATextStandByWidthsAndKerning) {
    const Scene s = scene("text { ttf \"timrom.ttf\" \"AVA\" .5, <.1,.2,.3> }");
    ASSERT_EQ(s.shapes.size(), 2u) << "the two A are one";
    const Extrusion& e = std::get<Extrusion>(s.shapes[0].geometry);
    EXPECT_EQ(e.top, 0.5);
    EXPECT_EQ(e.outlines.size(), 2u);
    std::vector<Vec3> places;
    const double a = 0.001 * kPi / 180;   // all letters are turned by it about each axis
    for (const Node& node : s.nodes) {
        if (!std::holds_alternative<ShapeId>(node.what)) continue;
        const Transform upright = inverse(node.to_parent).value();
        places.push_back(-upright.point(Vec3(0)));
        expect_near(upright.vector({0, 0, -1}), {a, -a, -1}, 4e-10);
    }
    ASSERT_EQ(places.size(), 3u);
    expect_near(places[0], {-0.006, 0, 0});
    expect_near(places[1], {-0.006 + 0.75 - 0.187 + 0.1, 0.2, 0});
    expect_near(places[2], {-0.006 + 0.75 - 0.187 + 0.724 - 0.15 + 0.2, 0.4, 0});
    EXPECT_EQ(scene("text { internal 2 \"xx\" 1, 0 } text { ttf \"cyrvetic\" \" \" 1, 0 }").shapes.size(), 1u);
}

/// POV-Ray draws them, with a warning or without.
TEST_F(PovBuilders, NumbersThatMakeNoSenseAreToldAndDrawn) {
    const auto finish = [](const Scene& s) { return std::get<PovFinish>(s.materials.back().layers[0]); };
    const std::string ball = "sphere { 0, 1 pigment { rgb 1 } ";
    EXPECT_THAT(said(ball + "finish { specular 1 roughness 0 } }"), HasSubstr("1:33: warning: a roughness of 0"));
    EXPECT_GT(finish(scene(ball + "finish { specular 1 roughness 0 } }")).roughness, 1e6) << "a highlight that goes all around";
    EXPECT_THAT(said(ball + "interior { ior 0 } }"), HasSubstr("warning: an index of refraction of 0 counts as 1"));
    EXPECT_EQ(scene(ball + "interior { ior 0 } }").interiors.back().ior, 1);
    EXPECT_EQ(finish(scene("#version 3.0; " + ball + "finish { ior 0 } }")).ior, 1);
    EXPECT_THAT(said(ball + "interior { ior -1 } }"), HasSubstr("error: the index of refraction must be greater than 0"));
    EXPECT_THAT(said("disc { 0, 0, 1 }"), HasSubstr("warning: a disc whose normal has no length"));
    EXPECT_EQ(std::get<Disc>(scene("disc { 0, 0, 1 }").shapes[0].geometry).radius, 0);
    EXPECT_EQ(scene("background { rgb 1 } background { }").atmosphere.background, Color(0)) << "of the first one nothing is left";
}

TEST_F(PovBuilders, AMissingFontIsAnErrorWithItsPlace) {
    EXPECT_THAT(said("text { ttf \"no such font.ttf\" \"A\" 1, 0 }"), HasSubstr("s.pov:1:12: error: the font \"no such font.ttf\" is not found"));
    write("broken.ttf", "this is no font");
    EXPECT_THAT(said("text { ttf \"broken.ttf\" \"A\" 1, 0 }"), HasSubstr("broken.ttf is not a TrueType font"));
    EXPECT_THAT(said("text { ttf \"timrom.ttf\" 7 }"), HasSubstr("a string is expected as the letters of a text"));
}

TEST_F(PovBuilders, DeclaredObjectsAreStoredOnce) {
    const Scene s = scene("#declare S = sphere { 0, 1 }\n#declare U = union { object { S translate x } object { S scale 2 } }\n#for(I, 1, 50) object { U translate I*y } #end");
    EXPECT_EQ(s.shapes.size(), 1u);
    EXPECT_EQ(s.nodes.size(), 1u + 2 + 1 + 50 + 1);   // S, its two references, U, its references, the camera
    EXPECT_EQ(s.roots.size(), 51u);
}

/// POV-Ray's own includes count on it: `quadric { Ellipsoid }`, which is a sphere.
TEST_F(PovBuilders, NamesStandForObjectsOfAnyKind) {
    const Scene s = scene("#declare S = sphere { 0, 3 } #declare A = array[2]; #declare A[1] = box { 0, 1 } #declare L = light_source { y, 1 }\nquadric { S scale 2 } cubic { A[1] } S A[1] #L camera { location y look_at 0 }");
    ASSERT_EQ(s.shapes.size(), 2u) << "each once";
    EXPECT_TRUE(std::holds_alternative<Sphere>(s.shapes[0].geometry) && std::holds_alternative<Box>(s.shapes[1].geometry));
    EXPECT_EQ(s.lights.size(), 1u);
    EXPECT_EQ(s.roots.size(), 6u) << "and a camera";
    EXPECT_THAT(said("#declare F = 2; F"), HasSubstr("s.pov:1:17: error: an object or a directive is expected, not F"));
    EXPECT_EQ(said("light_group { light_group { sphere { 0, 1 } light_source { y, 1 } } sphere { x, 1 } global_lights on }"), "");
}

TEST_F(PovBuilders, ASceneMayPrintAsItGoes) {
    const char* text = "#debug \"a\" #render \"b\\n\" #warning \"c\" #statistics \"d\" sphere { 0, 1 }";
    std::string printed;
    ImportOptions options;
    options.print = [&](pov::TextStream where, const std::string& what) { printed += std::to_string(int(where)) + what; };
    const auto result = import(text, options);
    ASSERT_TRUE(result);
    EXPECT_EQ(printed, "0a3b\n1c4d");
    EXPECT_THAT(result->diagnostics.text(), HasSubstr("s.pov:1:26: warning: c"));
    EXPECT_EQ(result->diagnostics.list().size(), 1u);
    EXPECT_THAT(said(text), HasSubstr("note: a"));
    EXPECT_THAT(said("#for (I, 1, 150) #debug str(I, 0, 0) #end sphere { 0, 1 }"), HasSubstr("... and 50 more notes")) << "none is lost without a word";
}

/// An interior goes on with what is there, a name in it or in a material begins anew: as 36 scenes of two spheres told of POV-Ray.
TEST_F(PovBuilders, ASecondInteriorGoesOnWithTheFirst) {
    const std::string names = "#declare I = interior { ior 1.33 fade_distance 2 } #declare M = material { texture { pigment { rgb 1 } } interior { I } }"
                              "#declare T = material { texture { pigment { rgb 1 } } } #declare S = sphere { 0, 1 material { M } }\n";
    const std::pair<const char*, Vec2> cases[] = {
        {"sphere { 0, 1 interior { I } interior { ior 1.6 } }", {1.6, 2}},
        {"sphere { 0, 1 material { M } interior { ior 1.6 } }", {1.6, 2}},
        {"sphere { 0, 1 material { M interior { ior 1.6 } } }", {1.6, 2}},
        {"object { S interior { ior 1.6 } }", {1.6, 2}},
        {"object { S material { interior { ior 1.6 } } }", {1.6, 2}},
        {"union { sphere { 0, 1 } sphere { x, 1 } interior { I } interior { ior 1.6 } }", {1.6, 2}},
        {"sphere { 0, 1 interior { ior 1.6 fade_distance 3 } interior { I } }", {1.33, 2}},
        {"sphere { 0, 1 interior { ior 1.6 fade_distance 3 } material { M } }", {1.33, 2}},
        {"sphere { 0, 1 material { M } material { T } }", {0, 0}},   // none
        {"object { S interior { ior 1.6 } } object { S }", {1.33, 2}},   // S is as it was
    };
    for (const auto& [text, want] : cases) {
        const Scene read = scene(names + text);
        Vec2 got(0);
        for (const Node& node : read.nodes)
            if (node.interior) got = {read.interiors.at(node.interior->index).ior, read.interiors.at(node.interior->index).fade_distance};
        EXPECT_EQ(got, want) << text;
    }
}

/// POV-Ray says "Use union instead of composite", whatever the version, and draws a union.
TEST_F(PovBuilders, ACompositeIsAUnion) {
    const auto nodes = [&](const std::string& word) {
        Scene read = scene(fmt::format("{0} {{ sphere {{ 0, 1 }} {0} {{ box {{ 0, 1 }} sphere {{ x, 1 }} }} rotate z*30 }} #declare A = {0} {{ sphere {{ 0, 2 }} }} object {{ A }}", word));
        for (Node& each : read.nodes) each.from = {};
        for (ShapeEntry& each : read.shapes) each.from = {};
        read.files.clear();
        return dump(read);
    };
    EXPECT_EQ(nodes("composite"), nodes("union"));
    EXPECT_THAT(said("composite { sphere { 0, 1 } }"), HasSubstr(":1:1: warning: composite is read as union"));
}

/// Each used to be read inside of the one before it.
TEST_F(PovBuilders, ThousandsOfDeclarationsFollowOneAnother) {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += fmt::format("#declare P{} = pigment {{ rgb {} }}\n", i, i);
    const Scene s = scene(text + "sphere { 0, 1 pigment { P2999 } }");
    ASSERT_FALSE(s.signals.empty());
    EXPECT_EQ(std::get<ConstantSignal>(s.signals.back().what).value.x, 2999);
}

TEST_F(PovBuilders, AnInteriorReadsRefractionAndRefractsAllTheSame) {
    const std::string text = "sphere { 0, 1 interior { refraction .5 ior 1.5 } }";
    EXPECT_EQ(said(text), "");
    EXPECT_EQ(scene(text).interiors.at(0).ior, 1.5);
}

TEST_F(PovBuilders, WhatIsNotModelledIsSaidOnceWithItsCount) {
    const std::string text = "#version 3.7;\n#for(I, 1, 3) isosurface { function { x } } #end\nmedia { emission 3 }\nsphere { 0, 1 photons { target } pigment { aoi } }";
    const std::string messages = said(text);
    EXPECT_THAT(messages, HasSubstr("s.pov:2:15: warning: isosurface is not modelled yet: it is left out (3 times)"));
    EXPECT_THAT(messages, HasSubstr("media is not modelled yet"));
    EXPECT_THAT(messages, HasSubstr("aoi as the pattern of a pigment is not modelled yet: middle grey stands for it"));
    EXPECT_EQ(scene(text).shapes.size(), 1u) << "the rest is there";
}

TEST_F(PovBuilders, WhatCutsShowsWhatItLaysOpen) {
    const Scene s = scene("#declare D = difference { sphere { 0, 2 pigment { rgb x } } plane { z, 0 } }\nobject { D cutaway_textures }\nobject { D }\nbox { 0, 1 pigment { rgb x } }");
    std::vector<bool> cut, usual;
    for (const NodeId root : s.roots) cut.push_back(s.nodes[root.index].cutaway_textures), usual.push_back(s.nodes[root.index].usual_material);
    EXPECT_EQ(cut, (std::vector<bool>{true, false, false, false})) << "the declared solid stays as it is";
    EXPECT_EQ(usual, (std::vector<bool>{true, true, false, false})) << "the last is the camera";
    const Scene moved = scene("#declare D = difference { sphere { 0, 2 pigment { rgb x } } plane { z, 0 } }\n#declare E = object { D rotate y*90 }\nobject { E cutaway_textures }");
    EXPECT_TRUE(std::any_of(moved.nodes.begin(), moved.nodes.end(), [](const Node& n) { return n.cutaway_textures && n.csg == CsgKind::difference; }));
    for (const char* other : {"sphere { 0, 1 ", "union { sphere { 0, 1 } ", "merge { sphere { 0, 1 } ", "object { union { sphere { 0, 1 } } "})
        EXPECT_THAT(said(std::string(other) + "cutaway_textures }"), HasSubstr("error: cutaway_textures stands in an intersection or a difference alone")) << other;
}

TEST_F(PovBuilders, WhatIsWrongWithARainbowOrAProjectorIsSaid) {
    EXPECT_THAT(said("rainbow { angle 3 width 2 }"), HasSubstr("s.pov:1:1: error: a rainbow needs the direction of the sun's light"));
    EXPECT_THAT(said("rainbow { direction y up 2*y width 2 }"), HasSubstr("error: the rainbow's up is the direction of its light"));
    EXPECT_THAT(said("rainbow { direction z falloff_angle 50 arc_angle 40 }"), HasSubstr("error: the falloff_angle of a rainbow is larger than its arc_angle"));
    const std::string through = "projected_through { sphere { 0, 1 } } ";
    EXPECT_THAT(said("light_source { y*9, rgb 1 " + through + through + "}"), HasSubstr("error: a light has one projected_through alone"));
    const Scene none = scene("rainbow { direction z angle 40 distance 3 } camera { normal { bump_size 2 } }");
    EXPECT_TRUE(none.atmosphere.rainbows.empty()) << "it has no width";
    EXPECT_FALSE(none.cameras[0].normal);
}

TEST_F(PovBuilders, WhatIsWrongWithAPictureIsAnErrorAtItsPlace) {
    write("a.png", "");
    const std::pair<const char*, const char*> cases[] = {
        {"pigment { image_map { png \"b.png\" } }", "s.pov:1:41: error: the picture \"b.png\" is not found"},
        {"pigment { image_map { png \"../a.png\" } }", "1:41: error: the picture \"../a.png\" is not found"},
        {"pigment { image_map { png } }", "error: the name of a file is expected in image_map"},
        {"pigment { image_map { png function 8, 8 { x } } }", "error: the name of a file is expected in image_map"},
        {"pigment { image_map { function { x } } }", "1:37: error: the function of a picture stands there itself, with its size"},
        {"pigment { image_map { function 8, .4 { x } } }", "1:37: error: the picture of a function has 8 x 0 pixels"},
        {"pigment { image_map { function 100000, 100000 { x } } }", "1:37: error: the picture of a function has more than"},
        {"pigment { image_map { function 8, 8 { x } gamma 2 } }", "1:57: error: gamma cannot stand behind a function"},
        {"pigment { image_map { function 8, 8 { sin(x, y) } } }", "1:53: error: sin does not take 2 arguments"},
        {"normal { bump_map { function 8, 8 { transform { scale 2 } } } }", "1:35: error: the function of a picture gives a number or a colour"},
        {"pigment { image_map { function 8, 8 { pattern { object { sphere { 0, 1 } } } } } }", "warning: object in the pattern of a function is not modelled yet: middle grey stands for the picture of a function"},
        {"pigment { image_map { png \"a.png\" map_type 3 } }", "1:58: error: there is no map_type 3"},
        {"pigment { image_map { png \"a.png\" gamma 0 } }", "1:55: error: the gamma of a picture must be greater than 0"},
        {"normal { bump_map { png \"a.png\" bump_size x } }", "error: a number is expected as the depth of a normal"},
        {"texture { material_map { png \"a.png\" } }", "1:25: error: a material_map needs textures"},
        {"pigment { rgb 1 } uv_mapping", "1:33: error: uv_mapping must stand before the texture"},
    };
    for (const auto& [words, error] : cases) EXPECT_THAT(said(fmt::format("sphere {{ 0, 1 {} }}", words)), HasSubstr(error)) << words;
    EXPECT_EQ(said("sphere { 0, 1 pigment { image_map { png \"a.png\" } } normal { bump_map { png \"a\" } } }"), "") << "a file is read when it is needed";
}

TEST_F(PovBuilders, ErrorsHaveTheirPlaceAndMoreThanOneIsTold) {
    const std::string messages = said("sphere { 0 }\nplane { y, 0 }\ncylinder { x, x, 1 }\nmesh2 { vertex_vectors { 1, 0 } face_indices { 1, <0,0,1> } }\ncamera { look_at 0 }\nsphere { <1,2> \"a\" }\nplane { 0, 1 }");
    EXPECT_THAT(messages, HasSubstr("s.pov:1:1: error: a number is expected as the radius of a sphere"));
    EXPECT_THAT(messages, HasSubstr("s.pov:3:12: error: the cylinder has no length"));
    EXPECT_THAT(messages, HasSubstr("s.pov:4:51: error: there is no vector 1: the mesh has 1"));
    EXPECT_THAT(messages, HasSubstr("s.pov:5:1: error: look_at is the camera's location"));
    EXPECT_THAT(messages, HasSubstr("s.pov:6:16: error: a number is expected"));
    EXPECT_THAT(messages, HasSubstr("s.pov:7:9: error: the normal of a plane has no length"));
    EXPECT_THAT(messages, Not(HasSubstr("s.pov:2")));
}

/// What POV-Ray refuses is no word that is left out. The places were asked of POV-Ray.
TEST_F(PovBuilders, AWordOfAnotherBlockIsAnError) {
    EXPECT_THAT(said("#version 3.7;\nsphere { 0, 1 pigment { rgb 1 phong 1 } }"), HasSubstr("s.pov:2:31: error: phong cannot stand in pigment"));
    const std::pair<const char*, const char*> cases[] = {{"sphere { 0, 1 phong 1 }", "phong cannot stand in sphere"}, {"sphere { 0, 1 location 0 }", "location cannot stand in sphere"},
        {"camera { phong 1 }", "phong cannot stand in camera"}, {"light_source { 0 rgb 1 ambient 1 }", "ambient cannot stand in light_source"}, {"fog { distance 1 look_at 0 }", "look_at cannot stand in fog"},
        {"sphere { 0, 1 texture { pigment { rgb 1 } diffuse 1 } }", "diffuse cannot stand in texture"}, {"sphere { 0, 1 finish { fog_alt 1 } }", "fog_alt cannot stand in finish"},
        {"global_settings { brilliance 1 }", "brilliance cannot stand in global_settings"}, {"sphere { 0, 1 interior { spotlight } }", "spotlight cannot stand in interior"},
        {"sky_sphere { pigment { rgb 1 } fade_power 1 }", "fade_power cannot stand in sky_sphere"}, {"sphere { 0, 1 normal { bumps max_trace_level 3 } }", "max_trace_level cannot stand in normal"}, {"#declare T = texture { pigment { rgb 1 } } sphere { 0, 1 texture T }", "{ is expected behind texture"},
        {"pigment { rgb 1 }", "an object or a directive is expected, not pigment"}, {"#declare P = pigment { rgb 1 } P", "an object is expected in object"}, {"#declare C = camera { } C", "an object is expected in object"},
        {"sphere { 0, 1 texture { gradient y color_map { [0 rgb x] [1 rgb y] } } }", "color_map cannot stand in this texture"}};
    for (const auto& [text, message] : cases) {
        EXPECT_THAT(said(text), HasSubstr(std::string("error: ") + message));
        if (!povray_is_installed()) continue;
        const std::string run = fmt::format("cd '{}' && povray +I{} -F -D +W1 +H1 > out.txt 2>&1", folder_.string(), write("misplaced.pov", text));
        EXPECT_NE(std::system(run.c_str()), -1);
        std::ostringstream words;
        words << std::ifstream(folder_ / "out.txt").rdbuf();
        EXPECT_THAT(words.str(), HasSubstr("Parse Error")) << text << " is refused by POV-Ray";
    }
    EXPECT_THAT(said("sphere { 0, 1 interior { media { } } photons { target } }"), Not(HasSubstr("error")));
}

TEST_F(PovBuilders, AnErrorInALoopIsSaidOnce) {
    const std::string messages = said("#for (I, 1, 9) sphere { 0, 1 finish { roughness 0 } } #end");
    EXPECT_EQ(messages.find("a roughness of 0"), messages.rfind("a roughness of 0")) << messages;
}

TEST_F(PovBuilders, IncludesAndDeclarationsComeFromTheOptions) {
    std::filesystem::create_directories(folder_ / "more");
    write("more/part.inc", "sphere { 0, R }");
    ImportOptions options;
    EXPECT_FALSE(import("#include \"part.inc\"", options));
    options.include_paths = {(folder_ / "more").string()};
    options.declarations = {"R=2.5"};
    const auto result = import("#include \"part.inc\"", options);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(std::get<Sphere>(result->scene.shapes.at(0).geometry).radius, 2.5);
}

/// Copies of copies, layers of layers, defaults over defaults: each doubles what is before it.
TEST_F(PovBuilders, WhatDoublesEndsInTime) {
    std::string layers = "#declare T0 = texture { pigment { rgb 1 } }\n", objects = "#declare O0 = sphere { 0, 1 }\n", defaults;
    for (int i = 1; i < 60; ++i) {
        layers += fmt::format("#declare T{0} = texture {{ T{1} }} texture {{ T{1} }}\n", i, i - 1);
        objects += fmt::format("#declare O{0} = union {{ object {{ O{1} pigment {{ rgb 1 }} }} object {{ O{1} pigment {{ rgb 0 }} }} }}\n", i, i - 1);
        defaults += "#default { texture { pigment { rgb 1 } } }\n";
    }
    EXPECT_THAT(said(layers + "sphere { 0, 1 texture { T59 } }"), HasSubstr("more than 1000 layers"));
    EXPECT_THAT(said(objects + "object { O59 }"), HasSubstr("more than 50000 objects are copied in copies"));
    EXPECT_EQ(scene(defaults + "sphere { 0, 1 }").shapes.size(), 1u);
}

TEST_F(PovBuilders, HostileBlocksEndInMessages) {
    for (const char* text : {"sphere { }", "camera { angle }", "light_source { }", "mesh { }", "mesh2 { }", "union { }", "object { }", "texture { }", "finish { }", "global_settings { assumed_gamma }", "global_settings { assumed_gamma 0 }",
                             "sphere { 0, 1 finish { reflection { } roughness 0 } }", "box { \"a\", 2 }", "sphere { 0, 1e400 }", "camera { right 0 }", "mesh2 { vertex_vectors { 9, 0 } face_indices { 1, <0,-1,1e30> } }",
                             "sphere { 0, 1 matrix <1,2,3> }", "light_source { 0 looks_like { } }", "sphere { 0, 1 interior { ior 0 } }", "#default { } sphere { 0, 1 }", "sphere { 0, 1 clipped_by { } }", "disc { 0, 0, 1 }", "quadric { 1 }", "poly { 1e9, <1,2,3,4,5,6> }", "poly { -3 }", "polygon { 1e300, 0 }", "polygon { 3, 0, 0, 0 }", "text { }",
                             "text { ttf \"../../../etc/passwd\" \"x\" 1, 0 }", "text { ttf \"\" \"x\" 1, 0 }", "text { internal 1e9 \"\\0x\" -1, 0 }"})
        EXPECT_NO_THROW(said(text)) << text;
}

}  // namespace
}  // namespace alidade
