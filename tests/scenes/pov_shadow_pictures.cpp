// SPDX-License-Identifier: Apache-2.0
/// Surfaces that are nearer to each other than shadow rays tell apart.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

/// On a floor, the shadows of what stands above it and is not seen. A and B let light of other colours through, O none.
std::string shadows_of(const std::string& objects, const std::string& light = "") {
    return "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.3,.5,.7> } camera { location <0,7,-5> look_at 0 angle 50 } light_source { <1,12,2> rgb 1 " + light +
           " } plane { y, 0 pigment { rgb 1 } finish { ambient .1 diffuse .9 } }\n#macro T(C) pigment { color C } finish { ambient 0 diffuse 0 } no_image no_reflection #end #declare A = rgbf <.4,1,1,1>; #declare B = rgbf <1,.4,1,1>; "
           "#declare O = rgb 0; #macro At(X,Z) translate <X,1,Z> #end #macro Disc(Y,C,X,Z) disc { Y*y, y, .7 T(C) At(X,Z) } #end\n" + objects;
}

/// Pairs and threes; `light` is of any kind.
std::string near_each_other(const std::string& light) {
    return shadows_of("Disc(0,A,-2.2,1.5) Disc(5e-4,B,-2.2,1.5) Disc(0,A,-.6,1.5) Disc(2e-3,B,-.6,1.5) Disc(0,A,1,1.5) Disc(6e-4,A,1,1.5) Disc(1.3e-3,B,1,1.5) Disc(0,A,2.6,1.5) Disc(5e-4,O,2.6,1.5) "
                      "Disc(0,A,-2.2,-.2) Disc(2e-3,O,-2.2,-.2) Disc(-5e-4,O,-.6,-.2) Disc(0,A,-.6,-.2) Disc(0,rgbt 1,1,-.2) Disc(5e-4,B,1,-.2) Disc(0,A,2.6,-.2) Disc(5e-4,O,2.6,-.2) Disc(.5,O,2.8,-.2)", light);
}

}  // namespace

std::vector<PovPicture> shadow_pictures() {
    const std::string fading = "interior { ior 1 fade_distance .05 fade_power 1 } ";
    return {
        {"ShadowsOfFiltersNearEachOther", near_each_other("")},
        {"ParallelShadowsOfFiltersNearEachOther", near_each_other("parallel point_at <0,0,0>")},
        {"SoftShadowsOfFiltersNearEachOther", near_each_other("area_light .4*x, .4*z, 3, 3")},
        {"ShadowsOfFiltersInOnePlace", shadows_of("#declare C = cone { 0, .4, .8*y, .8 T(A) } object { C At(-2,1.2) } object { C At(-2,1.2) } object { C At(0,1.2) } object { C scale .9995 At(0,1.2) } union { Disc(0,A,2,1.2) Disc(0,A,2,1.2) } mesh { "
                                                  "triangle { -x, x, z } triangle { -x, z, x } T(A) At(-2,-.8) } box { <-.6,0,-.6>, <.6,.5,.6> T(A) At(0,-.8) } box { <-.6,.5,-.6>, <.6,1,.6> T(B) At(0,-.8) } merge { box { <-.6,0,-.6>, <.6,3e-4,.6> } "
                                                  "box { <-.6,6e-4,-.6>, <.6,.5,.6> } T(A) At(2,-.8) }")},
        {"ShadowsNearWhereTheyFall", shadows_of("disc { 5e-4*y, y, .7 T(O) translate <-2,0,1.2> } disc { 1.5e-3*y, y, .7 T(O) translate <0,0,1.2> } disc { 5e-4*y, y, .7 T(A) translate <2,0,1.2> } disc { 1.5e-3*y, y, .7 T(A) translate <-2,0,-.8> } "
                                                "box { <-.6,5e-4,-.6>, <.6,.3,.6> T(A) translate -.8*z } disc { 5e-4*y, y, .7 T(A) translate <2,0,-.8> } disc { 1.2e-3*y, y, .7 T(O) translate <2,0,-.8> }")},
        {"ShadowsOfOpaqueThingsNearWhereTheyFall", shadows_of("disc { 5e-4*y, y, .7 T(O) translate <-2,0,0> } disc { 1.5e-3*y, y, .7 T(O) translate <0,0,0> } box { <-.6,5e-4,-.6>, <.6,.3,.6> T(O) translate 2*x }")},
        {"ShadowsOfThinBodiesThatFade", shadows_of("#macro Pane(H,X,Z) box { <-.6,0,-.6>, <.6,H,.6> T(A) " + fading + "At(X,Z) } #end Pane(5e-4,-2,1.2) Pane(1.5e-3,0,1.2) Pane(.05,2,1.2) union { box { <-.6,0,-.6>, <.6,5e-4,.6> } disc { .1*y, y, .5 } " +
                                                   "T(A) " + fading + "At(-2,-.8) } box { <-.6,0,-.6>, <.6,.1,.6> T(A) " + fading + "At(0,-.8) } box { <-.6,.1005,-.6>, <.6,.2,.6> T(B) " + fading + "At(0,-.8) } box { <-.6,0,-.6>, <.6,.1,.6> T(A) " + fading +
                                                   "At(2,-.8) } box { <-.6,.0995,-.6>, <.6,.2,.6> T(B) " + fading + "At(2,-.8) }")},
        {"ShadowsOfATinyScene", "#version 3.7; global_settings { assumed_gamma 1 } camera { location <.6,2.2,-7>*.001 look_at <0,.4,0>*.001 angle 40 } light_source { <4,8,-6>*.001 rgb 1 } union { plane { y, -1 pigment { checker rgb 1 rgb .6 } } sphere { 0, 1 "
                                "pigment { rgb x } } torus { 1.5, .2 rotate 30*x pigment { rgbf <.4,1,.5,.8> } } scale .001 }"},
    };
}

}  // namespace alidade::test
