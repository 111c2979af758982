// SPDX-License-Identifier: Apache-2.0
/// Objects that are bounded too tightly.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

/// POV-Ray asks parts of unions that threw the last shadow without their bounds: lights without shadows.
std::string bounded(const std::string& objects, const std::string& lights = "shadowless") {
    return "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.3,.5,.7> } camera { location <.6,2.2,-7> look_at <0,.4,0> angle 50 } light_source { <4,8,-6> rgb 1 " + lights +
           " } plane { y, -1.2 pigment { checker rgb .9 rgb .5 } finish { reflection .3 } }\n#declare B = sphere { <.2,.2,-.1>, .6 } #macro At(X,Y) pigment { rgb <.6+X*.2,.7,.6-Y*.2> } translate <X,Y,0> #end\n" + objects;
}

const std::string kAlone = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb .4 } camera { location <-.6,-1.5,-3> look_at 0 angle 50 } light_source { <4,8,-6> rgb 1 shadowless } light_source { <-3,-9,9> rgb 1 shadowless } ";

}  // namespace

std::vector<PovPicture> bound_pictures() {
    const std::string two = "union { sphere { 0, .8 } box { 0, 1 } ";
    return {
        {"BoundedSets", bounded(two + "bounded_by { B } At(-2,1.2) } merge { sphere { 0, .8 } box { 0, 1 } bounded_by { B } At(0,1.2) } intersection { sphere { 0, .9 } box { -.7, .7 } bounded_by { B } At(2,1.2) } difference { sphere { 0, .9 } box { 0, 2 translate -.5*z } bounded_by { B } "
         "At(-2,-.5) } text { ttf \"cyrvetic.ttf\" \"AB\" .5, 0 translate <-.6,-.3,0> bounded_by { B } At(0,-.5) } poly { 2, <1,0,0,0,1,0,0,1,0,-.7> bounded_by { B } At(2,-.5) }")},
        {"ShadowsOfWhatIsBounded", bounded("merge { sphere { 0, .8 } box { 0, 1 } bounded_by { B } At(0,1.2) } difference { sphere { 0, .9 } box { 0, 2 translate -.5*z } bounded_by { B } At(-2,-.2) } cylinder { -x, x, .7 bounded_by { B } At(2,-.2) } "
         "poly { 2, <1,0,0,0,1,0,0,1,0,-.7> bounded_by { B } At(-2,1.6) } torus { .7, .25 bounded_by { B } At(2,1.7) }", "")},
        {"BoundedShapes", bounded("cylinder { -x, x, .7 bounded_by { B } At(-2,1.2) } cone { -x, .8, x, .4 bounded_by { B } At(0,1.2) } torus { .7, .25 bounded_by { B } At(2,1.2) } quadric { <1,1,1>, 0, 0, -.6 bounded_by { B } At(-2,-.5) } sphere { 0, .8 bounded_by { B } At(0,-.5) } "
         "box { -.7, .7 bounded_by { B } At(2,-.5) }")},
        {"BoundedSheets", bounded("disc { 0, <1,1,-2>, .9 bounded_by { B } At(-2,1.2) } triangle { <-1,-1,0>, <1,-1,0>, y bounded_by { B } At(0,1.2) } polygon { 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> bounded_by { B } At(2,1.2) } "
         "mesh { triangle { <-1,-1,0>, <1,-1,0>, y } triangle { <-1,-1,0>, y, <-1,0,1> } bounded_by { B } At(-2,-.5) } plane { y, .1 bounded_by { B } At(0,-.5) } quadric { <1,-1,1>, 0, 0, -.2 bounded_by { B } At(2,-.5) }")},
        {"BoundedQuadrics", bounded("quadric { <1,-1,1>, 0, 0, .1 bounded_by { B } At(-2,1.2) } quadric { <1,0,1>, 0, 0, -.2 bounded_by { B } rotate 30*z At(0,1.2) } quadric { <1,1,1>, <.8,0,0>, 0, -.6 bounded_by { B } At(2,1.2) } quadric { <-1,1,-1>, 0, 0, 0 bounded_by { B } At(-2,-.5) } "
         "quadric { <1,-1,0>, 0, z, 0 bounded_by { B } At(0,-.5) } quadric { <1,1,-1>, 0, 0, -.2 bounded_by { B } rotate <20,30,40> At(2,-.5) }")},
        {"BoundedParts", bounded("union { cylinder { -x, x, .5 bounded_by { B } } box { -.3, <-.2,1,.3> } split_union off At(-2,1.2) } merge { box { -.7, .4 } sphere { <0,0,-.4>, .8 bounded_by { B } } At(0,1.2) } difference { box { <-1,-.8,-.3>, <1,.8,.5> } sphere { 0, .7 bounded_by { B } } "
         "At(2,1.2) } union { cylinder { -x, x, .5 bounded_by { B } At(-2,-.5) } sphere { <-2.6,.1,0>, .3 } pigment { rgb <1,1,.3> } } union { sphere { 0, .8 bounded_by { B } } box { -.3, <-.2,1,.3> } split_union off rotate 30*z At(0,-.5) } "
         "union { triangle { <-1,-1,0>, <1,-1,0>, y bounded_by { B } } sphere { <-.6,.6,0>, .3 } split_union off At(2,-.5) }")},
        {"BoundedBeforeUnionsMove", bounded("union { sphere { 0, .7 bounded_by { B } } torus { .8, .2 bounded_by { B } } rotate 20*z At(-2,1) } union { quadric { <1,-1,1>, 0, 0, -.2 bounded_by { B } } poly { 2, <1,0,0,0,1,0,0,1,0,-.7> bounded_by { B } translate 2*x } quadric { <1,1,1>, 0, 0, -.7 "
         "bounded_by { B } translate -2*x } rotate 20*z At(.5,-.3) } #declare C = cylinder { -x, x, .5 pigment { rgb <.5,1,.7> } bounded_by { B } } object { C rotate 20*z translate <0,1.7,0> } union { object { C translate <2,1.7,0> } sphere { <1.2,2,0>, .3 } }")},
        {"BoundsThatMove", bounded(two + "rotate 40*z bounded_by { B } scale <1,.7,1> rotate 30*y At(-2,1.2) } " + two + "bounded_by { B sphere { <-.3,0,0>, .6 } rotate 20*z } At(0,1.2) } cylinder { -x, x, .7 bounded_by { B } rotate 30*z scale <.7,1,1> At(2,1.2) } "
         "torus { .7, .25 bounded_by { B } rotate <40,30,20> At(-2,-.5) } " + two + "bounded_by { B } bounded_by { box { -.4, .5 } } At(0,-.5) } object { " + two + "bounded_by { B } } bounded_by { sphere { <-.2,-.2,0>, .8 } } rotate 20*z At(2,-.5) }")},
        {"BoundedGlass", bounded(two + "interior { ior 1.3 } bounded_by { B } At(-2,1.2) pigment { rgbf <1,.9,.8,.8> } } merge { sphere { 0, .8 } cylinder { 0, x, .4 } interior { ior 1.2 } bounded_by { B } At(0,1.2) pigment { rgbf .8 } } "
         "cylinder { -x, x, .7 bounded_by { B } At(-2,-.5) pigment { rgbt <1,.5,.3,.5> } } difference { sphere { 0, .8 } sphere { x, .6 bounded_by { sphere { x, .4 } } } At(0,-.5) finish { reflection .6 } }")},
        {"BoundsAwayFromThem", bounded(two + "bounded_by { sphere { <2,0,8>, 3 } } At(-2,1.2) } " + two + "bounded_by { sphere { <.6,2.2,-7>, 3 } } At(0,1.2) } " + two + "bounded_by { plane { z, -6.9 inverse } } At(2,1.2) } " + two + "bounded_by { plane { z, -20 } } At(2,-.5) } " + two +
         "bounded_by { sphere { 0, .3 inverse } } At(0,-.5) }")},
        {"AFewBoundedShapes", "#version 3.7; global_settings { assumed_gamma 1 } camera { location <.6,2.2,-7> look_at <0,.4,0> angle 50 } light_source { <4,8,-6> rgb 1 } sphere { 0, 1 pigment { rgb 1 } bounded_by { sphere { <.2,.2,-.1>, .6 } } }"},
        {"BoundsWithDiscs", bounded("#declare T = merge { sphere { 0, .8 } box { 0, 1 } } #declare D = disc { 0, z, .5 } object { T bounded_by { D } At(-2,1.2) } object { T bounded_by { disc { 0, -z, .5 } } At(0,1.2) } object { T bounded_by { union { object { D } sphere { .5, .3 } } } At(2,1.2) } "
         "poly { 2, <1,0,0,0,1,0,0,1,0,-.7> bounded_by { D } At(-2,-.5) } quadric { <1,-1,1>, 0, 0, -.2 bounded_by { D } At(0,-.5) } " + two + "bounded_by { D } At(2,-.5) }")},
        {"CamerasInBodiesWithoutTheirBounds", bounded("#macro In() pigment { rgbf <.7,1,.7,.8> } interior { ior 1.1 } #end #declare Far = sphere { <.6,2.2,-4.5>, .6 } sphere { <.6,2.2,-6>, 2 bounded_by { Far } In() } cylinder { <.6,2.2,-9>, <.6,2.2,-4>, 2.2 bounded_by { Far } In() } "
         "merge { sphere { <.6,2.2,-6>, 2.4 } box { 0, 1 } bounded_by { Far } In() }")},
        {"CamerasInBodiesWithTheBoxesOfTheirBounds", bounded("#macro In() pigment { rgbf <.7,1,.7,.8> } interior { ior 1.1 } #end #declare Near = sphere { <-1.6,0,-4.8>, 3 } sphere { <.6,2.2,-6>, 2 bounded_by { Near } In() } "
         "union { union { sphere { <.6,2.2,-6>, 2.4 } box { 0, 1 } bounded_by { sphere { <.6,2.2,-4.5>, .6 } } In() } sphere { -3*y, .1 } translate .001*x }")},
        {"CamerasInUnionsThatAreWhole", bounded("union { sphere { <.6,2.2,-6>, 2 pigment { rgbf <.7,1,.7,.8> } interior { ior 1.1 } } box { 0, 1 pigment { rgb 1 } } bounded_by { sphere { <.6,2.2,-7>, 30 } } }")},
        {"BoundsOfBounds", bounded("#declare BB = sphere { 0, .9 bounded_by { sphere { <.2,.2,-.1>, .4 } } } #declare BM = merge { box { -.65, .65 } sphere { 0, .1 } bounded_by { sphere { <.2,.2,-.1>, .4 } } } cylinder { <-3,1,0>, <-1,1,0>, .7 pigment { rgb 1 } bounded_by { object { BB translate <-2,1,0> } } } "
         "cylinder { -x, x, .7 bounded_by { BB } At(0,1.2) } cylinder { -x, x, .7 bounded_by { BM } rotate 30*z At(2,1.2) } " + two + "bounded_by { BB } At(-2,-.5) } cylinder { -x, x, .7 bounded_by { union { object { BM } sphere { <.5,.5,0>, .2 } } } At(0,-.5) } cylinder { <1,-.5,0>, <3,-.5,0>, .6 pigment { rgb x } "
         "bounded_by { union { sphere { <2,-.5,0>, .9 bounded_by { sphere { <2.2,-.3,-.1>, .4 } } } sphere { <2.5,0,0>, .2 } } } }")},
        {"ClippedByDiscs", bounded("#declare D = disc { 0, <1,1,-2>, .7 } sphere { 0, .8 clipped_by { D } At(-2,1.2) } cylinder { -x, x, .7 clipped_by { D } At(0,1.2) } merge { sphere { 0, .8 } box { -.1, .8 } clipped_by { disc { 0, <-1,.3,2>, .6 rotate 20*z } } At(2,1.2) } union { sphere { 0, .8 } box { -.1, .8 } "
         "clipped_by { D } At(-2,-.5) } union { plane { y, 0 clipped_by { D } } sphere { <-.6,.6,0>, .2 } rotate 20*z At(0,-.5) } box { -.7, .7 clipped_by { intersection { object { D } sphere { 0, .7 } } } At(2,-.5) }")},
        {"SetsWithDiscsAndBounds", bounded("intersection { sphere { 0, .8 } disc { 0, <-1,.3,2>, .6 } At(-2,1.2) } intersection { sphere { 0, .8 bounded_by { B } } box { -.7, .7 } At(0,1.2) } difference { sphere { 0, .8 bounded_by { B } } box { 0, 1 } At(2,1.2) } merge { intersection { sphere { 0, .8 } disc { 0, <-1,.3,2>, .6 } } "
         "sphere { <.8,.2,0>, .3 } At(-2,-.5) } cylinder { -.6*y, .6*y, .6 bounded_by { B } At(0,-.5) } cylinder { -x, x, .7 bounded_by { cone { <-.3,-.2,0>, .4, <.6,.6,-.3>, .2 } } At(2,-.5) }")},
        {"BoundsThatUnionsMove", bounded("union { quadric { <1,1,1>, 0, 0, -.7 bounded_by { B } } sphere { <-1.2,1,0>, .2 } rotate 20*z At(-1.8,1) } union { mesh { triangle { <-1,-1,0>, <1,-1,0>, y } triangle { <-1,-1,0>, y, <-1,0,1> } bounded_by { B } } sphere { <-1.2,1,0>, .2 } rotate 20*z At(.5,1) } "
         "union { union { sphere { 0, .8 bounded_by { B } } } sphere { <-1.2,1,0>, .2 } At(1.5,-.5) } cylinder { -x, x, .7 bounded_by { B } scale <1,.6,1> rotate <20,30,40> At(-2,-.5) }")},
        {"CamerasInBoundedParts", bounded("#macro In() pigment { rgbf <.7,1,.7,.8> } interior { ior 1.1 } #end #declare Far = sphere { <.6,2.2,-4.5>, .6 } merge { sphere { <.6,2.2,-6>, 2 bounded_by { Far } } box { 0, 1 } In() } merge { sphere { <.6,2.2,-6>, 1.8 } box { 0, 1 } clipped_by { disc { <.6,2.2,-5.5>, -z, 2 } } In() }")},
        {"CamerasInBoundsOfBounds", bounded("#macro In() pigment { rgbf <.7,1,.7,.8> } interior { ior 1.1 } #end #declare Far = sphere { <.6,2.2,-4.5>, .6 } merge { sphere { <.6,2.2,-6>, 1.5 } box { 0, 1 } bounded_by { sphere { <.6,2.2,-6>, 3 bounded_by { Far } } } In() }")},
        {"BoundsThatAreApart", bounded("#macro Two(T) bounded_by { sphere { -x, .5 } sphere { x, .5 } } At(T,1.2) #end cylinder { -x, x, .7 Two(-2) } sphere { 0, .9 Two(0) } merge { sphere { 0, .8 } box { 0, 1 } Two(2) } torus { .8, .3 bounded_by { box { <-1,-1,-1>, <-.5,.5,-.2> } box { <.3,.7,.2>, 1 } } "
         "At(-2,-.5) } cone { -y, .8, y, .3 bounded_by { sphere { -x, .5 } sphere { x, .5 } } rotate 30*z At(0,-.5) } sphere { 0, .9 clipped_by { box { -1, <-.1,1,1> } box { <.1,-1,-1>, 1 } } At(2,-.5) }")},
        {"ClippedQuadricsInTheBoxesOfTheirBounds", bounded("#declare H = quadric { <1,-1,1>, 0, 0, -.2 } quadric { H clipped_by { sphere { 0, 1 } } bounded_by { B } At(-2,1.2) } quadric { H clipped_by { plane { y, .3 } } bounded_by { B } rotate 30*z At(0,1.2) } quadric { H rotate 30*z clipped_by { plane { y, .3 } } bounded_by { B } At(2,1.2) } "
         "quadric { <1,-1,1>, 0, 0, 0 clipped_by { union { plane { x, .2 } plane { y, .3 } } } bounded_by { B } At(-2,-.5) } object { quadric { H pigment { rgb <.6,.7,.9> } bounded_by { B } } clipped_by { sphere { 0, 1 } } translate -.5*y } union { quadric { H clipped_by { sphere { 0, 1 inverse } sphere { 0, 1.2 } } bounded_by { sphere { 0, .9 } } } sphere { y, .2 } At(2,-.5) }")},
        {"QuadricsWhoseBoxesLosePartsOfThem", bounded("intersection { quadric { <1,0,1>, 0, -y, -.3 } box { -.8, .8 } At(-2,1.2) } quadric { <1,-1,1>, 0, 0, -2 clipped_by { plane { y, .5 } plane { -y, .5 } } scale .7 At(0,1.2) } intersection { quadric { <1,0,1>, 0, <.4,-1,0>, 0 } box { <-1,-.5,-1>, 1 } At(2,1.2) } "
         "intersection { quadric { <1,0,1>, 0, -y, -.3 translate <.1,0,.1> } box { -.8, .8 } At(-2,-.3) } difference { quadric { <1,0,1>, 0, 0, -.3 } plane { -y, -.5 } plane { y, -.5 } quadric { <1,0,1>, 0, -y, -.1 } At(0,-.5) } intersection { quadric { <1,.5,-1>, 0, z, -1.6 } box { -.9, .9 } rotate 20*y At(2,-.3) }")},
        {"CamerasInClippedAwayParts", bounded("#macro In() pigment { rgbf <.7,1,.7,.8> } interior { ior 1.1 } #end intersection { sphere { <.6,2.2,-7>, 2 } box { <-1,.7,-8.5>, <2.1,3.7,-5.5> } clipped_by { plane { -z, 6.5 } } In() }")},
        {"CamerasInClippedAwayPartsOfShapes", bounded("#macro In() pigment { rgbf <.7,1,.7,.8> } interior { ior 1.1 } #end cylinder { <-1.4,2.2,-7>, <2.6,2.2,-7>, 2 clipped_by { box { <-4,-2,-6.5>, <4.6,6.2,-3> } } In() } object { merge { sphere { <.6,2.2,-7>, 2 } sphere { <.6,2.2,-6>, 2 } clipped_by { sphere { <.6,2.2,-7>, .5 inverse } } } In() "
         "clipped_by { plane { -z, 6.8 } } }")},
        {"FacesInOnePlaneOfTurnedSets", kAlone + "intersection { plane { <1,1,0>, .5 } plane { <-1,1,0>, .5 } plane { -y, .5 } plane { z, .5 } plane { -z, .5 } rotate 30*y pigment { rgb x } } intersection { plane { -z, .5 } rotate 30*y pigment { rgb y } }"},
        {"FacesInOnePlaneOfTurnedQuadrics", kAlone + "intersection { quadric { <1,-.3,1>, 0, 0, -.1 } plane { y, .5 } plane { -y, .5 } pigment { rgb x } rotate <221.4,49.9,313> } box { <-.6,-.6,-.6>, <.6,.5,.6> pigment { rgb y } rotate <221.4,49.9,313> }"},
        {"BoundsThatHoldAll", bounded(two + "bounded_by { box { -.8, 1 } } At(-2,1.2) } difference { sphere { 0, .9 } box { 0, 2 translate -.5*z } bounded_by { sphere { 0, .9 } } At(0,1.2) } torus { .6, .2 bounded_by { cylinder { -.2*y, .2*y, .8 } } At(2,1.2) } "
         "intersection { plane { y, .5 } plane { -y, .5 } quadric { <1,0,1>, 0, 0, -.4 } bounded_by { sphere { 0, 1 } } At(-2,-.5) } " + two + "bounded_by { intersection { box { -1, 1 } plane { y, 2 } } } rotate 30 At(0,-.5) } "
         "quartic { <1,0,0,0,2,0,0,2,0,-1,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,-1,0,0,0,0,1,0,-1,0,0.1> bounded_by { sphere { 0, 1.2 } } At(2,-.5) }", "")},
    };
}

}  // namespace alidade::test
