// SPDX-License-Identifier: Apache-2.0
/// Parts of something: their no_image, no_shadow and no_reflection, which of them is seen where they coincide, and those without an end.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

const std::string kTriangle = "triangle { <-2,0,-1>, <0,0,2>, <2,0,-1> pigment { rgb x } } ", kPlane = "plane { y, 0 pigment { checker rgb z rgb <.4,.6,1> } } ";

std::string in_one_plane(const std::string& objects) {
    return "#version 3.7; global_settings { assumed_gamma 1 } camera { location <4.5,2.5,-3> look_at 0 angle 50 } #default { finish { ambient 1 diffuse 0 } } " + objects;
}

}  // namespace

std::vector<PovPicture> flag_pictures() {
    const std::string usual = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.1,.2,.3> } camera { location <0,2,-6> look_at <0,.5,0> angle 50 } light_source { <10,20,-15> rgb <1,.9,.8> } "
                              "plane { y, -1 pigment { rgb .6 } finish { reflection .4 } } ";
    return {
        {"FlagsOfParts", usual + "merge { sphere { 0, .8 no_image } box { <0,-.5,-.5>, "
         "<1.4,.5,.5> pigment { rgb <1,0,0> } } pigment { rgb 1 } translate <-1,.5,0> } difference { box { -.6, .6 no_image "
         "no_shadow } sphere { <0,.3,-.6>, .5 no_image } pigment { rgb <0,1,1> } translate <1.5,.5,-1> no_reflection }"},
        {"FlagsBehindGlass", "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 12 } background { rgb <.2,.4,.6> } camera { location <0,0,-6> look_at 0 angle 60 } light_source { <-3,5,-8> 1 } #macro Glass(i) pigment { rgbt <1,.6,.6,.6> } interior { ior i } #end\n"
         "#macro Pair(X,Y) sphere { <X-.35,Y,0>, .3 pigment { rgb y } no_image } sphere { <X+.35,Y,0>, .3 pigment { rgb x } no_reflection } #end Pair(-2,1.2) Pair(0,1.2) Pair(2,1.2) Pair(0,-1) box { <-2.8,.8,-1.5>, <-1.2,1.6,-1.4> Glass(1) } box { <-.8,.8,-1.5>, <.8,1.6,-1.4> Glass(1.3) }\n"
         "box { <-1,-1.4,-1.3>, <1,-.6,-1.2> Glass(1.2) } plane { z, 2 pigment { rgb .2 } finish { reflection .7 } } disc { <0,-1,1>, z, .8 Glass(1) } disc { <2,1.2,1>, z, .8 Glass(1.2) } sphere { <-2,-1,-.5>, .7 Glass(1.4) } sphere { <-2,-1,1>, .5 pigment { rgb z } no_image }"},
        {"FlagsOfClippedObjects", usual + "#declare Ball = sphere { 0, .7 no_shadow } #declare Cut = difference { box { -.5, .5 } sphere { <0,.3,-.6>, .5 } no_image } "
         "object { sphere { 0, .7 no_reflection } clipped_by { plane { y, .3 } } pigment { rgb <1,0,0> } translate <-2,0,0> } object { object { Ball } clipped_by { plane { y, .3 } } pigment { rgb <0,1,0> } } object { Cut clipped_by { "
         "plane { x, .2 } } pigment { rgb <0,0,1> } translate <1.5,.5,-1> } merge { object { sphere { 0, .6 no_image } clipped_by { plane { y, .2 } } } box { <0,-.3,-.3>, <1,.3,.3> } pigment { rgb <1,1,0> } translate <1.5,-.3,.5> }"},
        {"FlagsOfWholeUnions", usual + "#declare Ball = sphere { 0, .7 no_shadow } #declare Parts = union { object { Ball scale .5 } sphere { x*.7, .3 no_reflection } box { -.2, .2 translate "
         ".4*x clipped_by { plane { x, .6 } } no_image } } #declare Dark = union { object { Ball scale .5 } sphere { x*.7, .3 no_shadow } } union { Parts clipped_by { plane { y, .2 } } pigment { rgb <1,0,1> } translate <-1,0,-2> } object { Parts "
         "bounded_by { box { -2, 2 } } pigment { rgb <1,0,0> } translate <-2,0,0> } object { Parts pigment { rgb <0,1,0> } } union { object { Dark } object { Ball scale .3 translate -y } split_union off pigment { rgb <0,0,1> } translate <1.5,0,-1> } "
         "union { Dark clipped_by { plane { y, .1 } } pigment { rgb <1,1,0> } translate <1.5,1,0> } union { object { Ball scale .4 } sphere { x*.4, .3 no_shadow } bounded_by { box { -3, 3 } } translate <0,0,-2> }"},
        {"FlagsOfBoundsAndDeclarations", usual + "#declare B = sphere { 0, .5 no_image no_reflection } #declare P = union { sphere { 0, .5 no_image no_shadow } sphere { x*.5, .3 no_shadow } } object { B no_image off translate <-2,0,0> } "
         "union { sphere { 0, .5 no_image no_shadow } sphere { x*.4, .4 } bounded_by { box { -3, 3 } } split_union on pigment { rgb y } translate <-.7,0,0> } union { P pigment { rgb <0,1,1> } translate <.7,0,0> } merge { P bounded_by { box { -3, 3 } } "
         "pigment { rgb <1,1,0> } translate <2,0,-1> } union { object { P } sphere { y*.5, .2 no_shadow } clipped_by { plane { y, .6 } } pigment { rgb 1 } translate <0,0,-2> } "
         "union { sphere { 0, .3 pigment { rgb z } } bounded_by { box { -1, 1 } } translate 2*y } union { union { sphere { 0, .2 pigment { rgb x } } } split_union off translate <1,2,0> }"},
        {"GlassOnFloors", "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,4,-7> look_at <0,.2,0> angle 45 } light_source { <3,8,-3> 1 } background { rgb <.3,.4,.6> } #default { pigment { rgbf <1,.5,.5,.8> } }\n"
                          "box { <-2.4,0,-1>, <-1.2,.5,1> } box { <-1,0,-1>, <-.2,.5,1> interior { ior 1.3 } } union { box { <.1,0,-1>, <.6,.3,0> } box { <.2,0,.2>, <.8,.6,1> } bounded_by { box { -1, 1 } } } difference { box { <1,0,-1>, <1.8,.4,0> } box { <1.2,-1,-.8>, <1.6,.2,-.2> } }\n"
                          "intersection { plane { y, .4 } plane { -y, 0 } plane { x, 1.8 } plane { -x, -1 } plane { z, 1 } plane { -z, -.2 } } plane { y, 0 pigment { checker rgb 1 rgb .6 scale .3 } } sphere { <2.3,.3,.3>, .3 pigment { rgb y } }"},
        {"WholesWithPartsInOnePlace", "#version 3.7; global_settings { assumed_gamma 1 } camera { location <.3,.2,-9> look_at 0 angle 50 } #default { finish { ambient 1 diffuse 0 } }\n"
                          "#macro Near(X,Y) mesh { triangle { <X,Y,0>, <X+2,Y,0>, <X+2,Y+2,0> } triangle { <X,Y,0>, <X+2,Y+2,0>, <X,Y+2,0> } triangle { <X+2.2,Y+2.2,-2>, <X+2.6,Y+2.2,-2>, <X+2.2,Y+2.6,-2> } pigment { rgb x } } #end\n"
                          "#macro Far(X,Y) box { <X,Y,0>, <X+2,Y+2,1> pigment { rgb y } } #end union { Near(-3.4,.2) Far(-3.4,.2) bounded_by { box { -6, 6 } } } union { Far(.6,.2) Near(.6,.2) bounded_by { box { -6, 6 } } } union { Near(-3.4,-2.6) Far(-3.4,-2.6) }\n"
                          "union { Near(.6,-2.6) Far(.6,-2.6) split_union off }"},
        {"GlassOnTables", "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,4,-7> look_at <0,.2,0> angle 45 } light_source { <3,8,-3> 1 } background { rgb <.3,.4,.6> } #default { pigment { rgbf <1,.5,.5,.8> } }\n"
                          "box { <-3,-.2,-2>, <0,0,2> pigment { checker rgb 1 rgb .6 scale .3 } } box { <-2.4,0,-1>, <-1.2,.5,1> } box { <-1,0,-1>, <-.2,.5,1> interior { ior 1.3 } } box { <.3,0,-1>, <1.2,.3,1> } box { <.1,-.2,-2>, <2,0,2> pigment { checker rgb 1 rgb .6 scale .3 } }\n"
                          "box { <-3.2,-.3,-2.2>, <2.2,-.2,2.2> pigment { rgb y } }"},
        {"TwoInOnePlaneAndNothingElse", in_one_plane(kTriangle + kPlane)}, {"TheSecondOfTwoInOnePlane", in_one_plane(kPlane + kTriangle)}, {"TwoInOnePlaneAndALight", in_one_plane(kTriangle + kPlane + "light_source { 9*y rgb 1 }")},
        {"CylindersThatTouch", "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 20 } background { rgb <.2,.3,.5> } camera { location <1.3,4.1,-9> look_at <0,1,0> angle 50 } light_source { <5,9,-8> 1 } "
         "plane { y, -.5 pigment { checker rgb 1 rgb .3 } } #declare C = cylinder { 0, y, .7 } #declare D = cylinder { y, 2*y, .7 } #macro G(X) pigment { rgbt <.9,1,.9,.8> } finish { ambient .1 diffuse .4 } translate X #end "
         "merge { object { C } cone { y, .9, 2*y, .3 } interior { ior 1.3 } G(-3*x) } intersection { cylinder { 0, 2*y, .7 } object { D } G(-x) } difference { cylinder { 0, 2*y, .7 } cylinder { 0, 2*y, .4 } G(x) } "
         "difference { box { <-.7,0,-.7>, <.7,2,.7> } cylinder { 0, 2*y, .4 } G(3*x) } object { cylinder { 0, 2*y, .7 } clipped_by { object { C } } G(<-2,0,2>) } merge { object { C } object { D inverse } G(<2,0,3>) }"},
        {"CoincidentParts", "#version 3.7; global_settings { assumed_gamma 1 } camera { orthographic location -9*z look_at 0 right 8*x up 6*y } #default { finish { ambient 1 diffuse 0 } } #macro P(X,Y) translate <X*1.3-2.6,Y*1.3-1.3,0> #end "
         "#macro R() box { -.5, .5 pigment { rgb x } } #end #macro G() box { -.5, .5 pigment { rgb y } } #end #macro B() box { -.5, .5 pigment { rgb z } } #end #macro W() box { -3, 3 } #end #declare C = union { R() G() B() clipped_by { W() } } "
         "union { R() G() B() bounded_by { W() } P(0,0) } union { R() union { G() B() } split_union off P(1,0) } union { R() union { B() G() bounded_by { W() } } bounded_by { W() } P(2,0) } intersection { R() G() B() P(3,0) } intersection { union { R() G() B() } W() P(4,0) } "
         "intersection { intersection { R() G() B() } W() P(0,1) } object { C P(1,1) } union { union { R() G() } B() clipped_by { W() } P(2,1) } object { union { R() G() B() } clipped_by { W() } P(3,1) } difference { R() box { -.5, <.2,.3,-.5> translate -1e-9*z pigment { rgb y } } P(4,1) } "
         "intersection { intersection { union { R() G() B() } W() } W() P(0,2) } union { intersection { R() G() } intersection { B() W() } bounded_by { W() } P(1,2) } union { union { R() G() B() } clipped_by { W() } P(2,2) } union { union { R() G() clipped_by { W() } } sphere { 9, 1 } bounded_by { W() } P(3,2) } "
         "union { B() intersection { R() G() } split_union off P(4,2) }"},
        {"OpenParts", usual + "#macro Pipe() cylinder { 0, 1.2*x, .3 open } #end #macro Horn() cone { 0, .5, y, .1 open } #end merge { Pipe() sphere { 0, .5 } pigment { rgb x } translate -2*x } merge { union { Pipe() Horn() } sphere { 0, .4 } pigment { rgb y } } "
         "difference { Horn() sphere { <0,.5,-.3>, .3 } pigment { rgb z } translate 2*x } union { disc { 0, y, 1 } Pipe() clipped_by { plane { x, .3 } } pigment { rgb <1,1,0> } translate <-2,1.5,0> } object { Pipe() clipped_by { plane { y, .1 } } "
         "pigment { rgb <1,0,1> } translate 1.5*y } intersection { disc { 0, y+z, 3 } box { -.5, <2,.5,.5> } pigment { rgb <0,1,1> } translate <2,1.5,0> } merge { disc { 0, <0,1,-1>, .7 pigment { rgb 1 } } sphere { 0, .5 pigment { rgb .5 } } "
         "translate <-.7,-.5,-2> } difference { box { -.4, .4 } disc { 0, <1,0,-1>, .5 } pigment { rgb <1,.5,0> } translate <1,-.5,-2> }"},
        {"MeshesWithAnInside", usual + "#declare D = mesh2 { vertex_vectors { 6, x, -x, y, -y, z, -z } face_indices { 8, <0,2,4>, <0,2,5>, <0,3,4>, <0,3,5>, <1,2,4>, <1,2,5>, <1,3,4>, <1,3,5> } inside_vector <.1,1,.2> } #declare M = object { D rotate 45*y scale .9 "
         "} intersection { object { M } sphere { <.2,.3,0>, .65 } pigment { rgb x } translate -2.2*x } difference { object { D scale .8 } sphere { <0,.3,-.6>, .5 pigment { rgb 1 } } pigment { rgb y } } difference { box { -.6, .6 } object { D scale .7 rotate y*20 "
         "translate <0,.3,-.5> pigment { rgb <1,1,0> } } pigment { rgb z } translate <1.6,.5,-.5> rotate y*10 } merge { object { D scale .6 } object { M scale .7 translate x*.5 } pigment { rgb <1,1,.6> } translate <-1,1.8,0> } object { M clipped_by { sphere { "
         ".3, .7 } } pigment { rgb <0,1,1> } translate <1,1.5,0> } sphere { 0, .5 clipped_by { object { D scale .6 inverse } } pigment { rgb <1,0,1> } translate <-.7,-.4,-2> } intersection { object { M scale .5 inverse } sphere { 0, .45 } pigment { rgb <1,.5,0> } "
         "translate <.9,-.4,-2> }"},
        {"LightsOfSetsInLightGroups", usual + "#declare B = sphere { 0, .6 pigment { rgb 1 } } #declare R = light_source { <9,5,-5> rgb <.8,.1,0> } #declare G = light_source { <0,9,-5> rgb <0,.5,.1> } "
         "light_group { light_source { G } union { light_source { R } object { B } } object { B translate 1.3*x } } object { B translate -1.3*x } light_group { light_source { G translate x } object { union { light_source { R } "
         "object { B } } } global_lights on translate 1.3*y } light_group { light_source { G } light_group { object { B } union { object { B translate 1.3*x } } } translate <-1,1.3,-2> } light_group { object { R } union { object { R } object { B scale .5 translate <1.3,-.6,-2> } } }"},
        {"LightGroupsByNameInLightGroups", usual + "#declare B = sphere { 0, .6 pigment { rgb 1 } } #declare R = light_source { <9,5,-5> rgb <.8,.1,0> } #declare G = light_source { <0,9,-5> rgb <0,.5,.1> } #declare L = light_source { -9*z rgb <0,.1,.6> } "
         "#declare Q = light_group { light_source { G } object { B } difference { object { B translate 1.3*x } sphere { <1.3,0,-.6>, .4 } } } light_group { light_source { L } object { Q } object { B translate -1.3*x } } "
         "#declare V = light_group { light_source { R } light_group { Q } object { B translate 2.6*x } } light_group { light_source { L } union { object { V translate -1.3*y } } object { B translate <-1.3,-1.3,0> } } "
         "light_group { light_source { L } light_group { light_source { R } object { B } } object { B translate 1.3*x } translate <0,1.3,0> } light_group { light_source { R } light_group { object { Q } } translate <0,2.6,0> }"},
        {"MeshesThatAreSmoothAtFirst", usual + "#macro M(Some) mesh2 { vertex_vectors { 5, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0>, <0,0,-.4> } normal_vectors { 5, <-1,-1,-1>, <1,-1,-1>, <1,1,-1>, <-1,1,-1>, -z } "
         "face_indices { 4, <0,1,4>, <1,2,4>, <2,3,4>, <3,0,4> } #if (Some) normal_indices { 2, <0,1,4>, <1,2,4> } #else normal_indices { 0, } #end pigment { rgb <1,.7,.4> } finish { phong .6 } } #end "
         "object { M(yes) translate -1.1*x } object { M(no) translate 1.1*x }"},
        {"ShadowsOfFadingBodies", usual + "#declare I = interior { fade_distance .5 fade_power 1 fade_color <0,.5,1> } #declare T = texture { pigment { rgbt 1 } } #macro F(h) triangle { <-.5,h,-.5>, <.5,h,-.5>, <.5,h,.5> } triangle { <-.5,h,-.5>, <.5,h,.5>, <-.5,h,.5> } #end "
         "union { box { <-.5,-.5,-.5>, <.5,.3,.5> } box { <-.4,0,-.4>, <.4,.8,.4> } texture { T } interior { I } translate -1.4*x } mesh { F(-.5) F(0) F(.6) texture { T } interior { I } } mesh { F(-.5) F(.7) texture { T } interior { I } translate 1.4*x } "
         "union { disc { 0, y, .5 } disc { y, y, .5 } texture { T } interior { I } translate <2.8,-.5,0> } mesh { F(0) F(.4) texture { T } interior { I } translate <1.4,-.7,-1.3> } light_source { 30*y 1 }"},
        {"LightGroupsByName", usual + "#declare G = light_group { light_source { <-5,5,-5> rgb <.2,.4,1> } sphere { 0, .7 pigment { rgb 1 } } global_lights on } light_group { G translate x } object { G translate -x }"},
        {"DeclaredLightGroups", usual + "#declare G = light_group { light_source { <-5,5,-5> rgb <.5,0,0> } sphere { 0, .7 pigment { rgb 1 } } } light_group { G global_lights on translate <-1.5,0,0> } light_group { G } light_group { light_group { light_source { <5,5,-5> "
         "rgb <0,.5,0> } sphere { 0, .5 pigment { rgb 1 } } global_lights off } sphere { x, .4 pigment { rgb y } } global_lights on translate <1.5,0,0> } "
         "light_group { object { G scale .5 } sphere { y, .3 pigment { rgb 1 } } global_lights on translate <.5,0,-2> } light_group { light_group { light_source { <5,5,-5> rgb x } sphere { 0, .3 pigment { rgb 1 } } global_lights on } box { 0, .3 } translate <-1,0,-3> }"},
    };
}

}  // namespace alidade::test
