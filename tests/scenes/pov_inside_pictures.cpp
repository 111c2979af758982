// SPDX-License-Identifier: Apache-2.0
/// What counts as inside: of surfaces that enclose nothing, and where a camera stands.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

constexpr const char* kInsideHead = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.7,.8,1> } light_source { <-7,8,-6> 1 }\n";
constexpr const char* kFloor = "plane { y, -1.6 pigment { checker rgb 1 rgb <1,.2,.2> scale .5 } }\n";
constexpr const char* kGlass = " pigment { rgbt <.5,.9,.4,.95> } interior { ior 1.4 } ";

std::string seen(const std::string& objects, const char* camera = "camera { location <0,3,-4> look_at 0 }") { return std::string(kInsideHead) + camera + "\n" + kFloor + objects; }

/// From the origin to a wall, through `object` and fog.
std::string in_fog(const std::string& object) {
    return seen("fog { distance 6 rgb <.6,.6,.9> } box { <-50,-50,20>, <50,50,21> pigment { rgb .5 } }\n" + object, "camera { location 0 look_at z angle 60 }");
}

/// Every kind of thing with interior_texture: sides of sheets and triangles, what is taken away, inverse, clipped, moved behind a texture, shadows, materials, layers.
std::string two_sided() {
    return "#declare O = texture { pigment { rgb <1,.3,.2> } } #declare I = texture { pigment { gradient x color_map { [.5 rgb y] [.5 rgb <1,1,0>] } scale .3 } finish { specular .6 } }\n"
           "#declare Cup = difference { sphere { 0, .8 } plane { -y, -.2 } sphere { 0, .7 texture { O } interior_texture { pigment { rgb <0,1,1> } } } texture { O } interior_texture { I } }\n"
           "#declare Shell = sphere { 0, .6 clipped_by { plane { y, .1 } } texture { O } rotate 30*z interior_texture { I } translate .2*y }\n"
           "object { Cup translate <-2,0,0> } object { Shell rotate -40*x translate <-.6,0,0> } object { Shell interior_texture { pigment { checker rgbt 1 rgb z } scale .2 } rotate -40*x translate <.8,0,0> }\n"
           "cylinder { 0, 1.5*z, .5 open material { texture { pigment { rgbf <1,.2,.2,.8> } } interior_texture { pigment { rgbf <.2,1,.2,.8> } } interior { ior 1 } rotate 20*z } rotate 30*y translate <2,-.4,0> }\n"
           "mesh { triangle { <-1,0,0>, <1,0,0>, <0,1,0> } triangle { <-1,.2,-.5>, <0,1.2,-.5>, <1,.2,-.5> } texture { O } interior_texture { pigment { checker rgb 1 rgb 0 scale .1 } } scale .7 rotate 30*y translate <-1,1.6,0> }\n"
           "mesh { smooth_triangle { <-1,0,0>, z, <0,1,0>, z, <1,0,0>, z } texture { O } interior_texture { I } inverse translate <2,1.2,1> }\n"
           "plane { z, 4 texture { O } interior_texture { pigment { bozo color_map { [0 rgb .3] [1 rgb .8] } } normal { bumps .5 } } }\n"
           "union { sphere { 0, .4 pigment { rgbt <1,1,1,.7> } } disc { <.8,0,0>, <0,0,1>, .4 } texture { O } interior_texture { pigment { rgb <1,0,1> } } translate <1,1.8,0> }\n"
           "sphere { <-2.5,1.8,0>, .5 inverse hollow texture { pigment { rgbf 1 } } interior_texture { pigment { checker rgbf <1,.5,.5,1> rgb <.5,1,.5> scale .25 } } interior { ior 1.3 } }\n"
           "difference { box { -.4, .4 texture { O } interior_texture { I } } sphere { <0,.3,-.4>, .4 } cutaway_textures rotate 30*y translate <.4,-.5,-2> }\n"
           "union { object { Shell scale .4 } object { Shell scale .4 translate .6*x } texture { pigment { rgb z } } interior_texture { I } rotate -60*x translate <-1.6,-.5,-2> }\n"
           "sphere { 0, .5 clipped_by { plane { y, .1 } } material { texture { I } interior_texture { I } scale 2 } rotate -50*x translate <1.4,-.6,-1.6> }\n";
}

std::string sheets() {
    const std::string triangle = "triangle { <-1,-.2,-1>, <1,.3,-.6>, <0,.5,.8> }", white = " pigment { rgb .9 } ";
    return "difference { sphere { 0, .9 } " + triangle + white + "translate -2*x }\n"
           "difference { sphere { 0, .9 } mesh { " + triangle + " triangle { -1, x, y } }" + white + "}\n"
           "difference { sphere { 0, .9 } polygon { 4 <-1,-1>, <1,-1>, <0,1>, <-1,-1> rotate x*70 }" + white + "translate 2*x }\n"
           "difference { sphere { 0, .9 } union { sphere { x*.5, .5 } " + triangle + " }" + white + "translate <-2,0,2> }\n"
           "intersection { sphere { 0, .9 } object { " + triangle + " inverse }" + white + "translate 2*z }\n"
           "merge { sphere { 0, .9 } " + triangle + white + "translate <2,0,2> }\n";
}

}  // namespace

std::vector<PovPicture> inside_pictures() {
    const std::string glass = kGlass, clear = "pigment { rgbf <.9,.8,.8,.7> } ";
    return {
        {"InteriorTextures", seen(two_sided(), "camera { location <0,2,-6> look_at <0,.5,0> angle 50 }")},
        {"FresnelGlassInAHalfSpace", seen("plane { z, 5 pigment { rgb <.8,.8,.7> } } sphere { -1.2*x, .9 pigment { rgbf <.98,1,.98,.9> } finish { reflection { 0, 1 fresnel } } interior { ior 1.5 } } "
                                     "sphere { x, .9 pigment { rgbf .9 } finish { reflection { .03, .5 fresnel } conserve_energy } interior { ior 1.5 } } sphere { <1.2,.3,0>, .5 pigment { rgbt .9 } finish { diffuse 0 reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.2 } }")},
        {"FresnelPanesFromBehind", seen("disc { 0, -y, 1.5 pigment { rgbft <.9,.95,1,.8,.1> } finish { ambient 0 diffuse .1 reflection { .05, 1 fresnel } conserve_energy } interior { ior 1.3 } rotate -5*x } "
                                     "sphere { <0,-.5,0>, .8 pigment { rgbt 1 } interior { ior 1.3 } } sphere { <0,-.5,0>, .4 pigment { rgbt .9 } finish { diffuse 0 reflection { 0, 1 fresnel } } interior { ior 1.6 } }")},
        {"FilmsThatMirrorTotally", seen("sphere { 0, 1 scale <.9,.8,.76> pigment { rgbft <.66,.6,.5,.24,.45> } finish { irid { .467 thickness .193 } } interior { ior 1.62 } } "
                                     "box { -.5, .5 rotate 30 translate 1.6*x pigment { rgbt <.9,.8,.8,.9> } finish { irid { .4 thickness .3 } reflection .1 } interior { ior 1.5 } }")},
        {"HollowBeforeALastPartOfItsOwn", in_fog("union { sphere { 0, 1 } sphere { .3*x, 1 interior { ior 1 } hollow } pigment { rgbt <.9,.8,.8,.9> } interior { ior 1 } split_union off }")},
        {"HollowByThePartWithoutAnInterior", in_fog("union { sphere { 0, 1 hollow } sphere { .3*x, 1 interior { ior 1 } } pigment { rgbt <.9,.8,.8,.9> } interior { ior 1 } split_union off }")},
        {"HollowByAPartOfAnIntersection", in_fog("intersection { sphere { 0, 1 hollow } sphere { .3*x, 1 interior { ior 1 } } pigment { rgbt <.9,.8,.8,.9> } interior { ior 1 } }")},
        {"CameraOnASurface", seen("plane { y, 0 pigment { rgb x } } sphere { 0, 2 pigment { rgb 1 } }", "camera { location <0,0,-6> look_at 0 }")},
        {"InteriorTexturesOfSmoothTriangles", seen("#declare Tx = texture{pigment{rgb y}} #declare Ix = texture{pigment{rgb <1,.5,0>}}\n"
                                     "#macro Ring(S) #local A=0; #while (A<12) #local B=0; #while (B<8) #macro P(a,b) <cos(a*pi/6)*(1+.4*cos(b*pi/4)), .4*sin(b*pi/4), sin(a*pi/6)*(1+.4*cos(b*pi/4))> #end #macro N(a,b) <cos(a*pi/6)*cos(b*pi/4), sin(b*pi/4), sin(a*pi/6)*cos(b*pi/4)> #end\n"
                                     "smooth_triangle { P(A,B), N(A,B), P(A+1,B), N(A+1,B), P(A+1,B+1), N(A+1,B+1) } #if (mod(A+B,2)) smooth_triangle { P(A,B), N(A,B), P(A+1,B+1), N(A+1,B+1), P(A,B+1), N(A,B+1) } #else smooth_triangle { P(A,B), N(A,B), P(A,B+1), N(A,B+1), P(A+1,B+1), N(A+1,B+1) } #end #local B=B+1; #end #local A=A+1; #end #end\n"
                                     "mesh { Ring(1) texture { Tx } interior_texture { Ix } rotate 40*x scale .6 translate <-1.3,.7,0> } mesh { Ring(1) texture { Tx } interior_texture { Ix } rotate 40*x scale <-.6,.6,.6> translate <.3,.7,0> } mesh { Ring(1) texture { Tx } interior_texture { Ix } inverse rotate 40*x scale .6 translate <1.8,.7,0> }\n"
                                     "difference { mesh { Ring(1) inside_vector y } box { <-2,-2,-2>, <0,2,2> } texture { Tx } interior_texture { Ix } rotate 40*x scale .6 translate <-1.3,-.9,0> }\n"
                                     "mesh { Ring(1) texture { Tx } interior_texture { Ix } rotate 40*x scale .6 clipped_by { plane { z, 0 } } translate <.3,-.9,0> }\n"
                                     "mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } normal_vectors { 3, <0.2,0,-1>, <0.3,0,1>, <0,.3,-1> } face_indices { 1, <0,1,2> } texture { Tx } interior_texture { Ix } translate <1.2,-1.3,0> }\n")},
        {"InteriorTexturesOfInverseSets", seen("#declare T = texture { pigment { rgb x } } #declare I = texture { pigment { rgb y } } intersection { sphere { 0, .7 } box { -2, 2 } inverse texture { T } interior_texture { I } translate -1.6*x } "
                                     "difference { box { -.5, .5 } sphere { <0,.5,-.5>, .4 } inverse texture { T } interior_texture { I } } merge { sphere { 0, .5 } box { <.2,.2,-.2>, .7 } inverse texture { T } interior_texture { I } translate 1.6*x } "
                                     "intersection { box { -.5, .5 } sphere { <0,.5,-.5>, .4 inverse } texture { T } interior_texture { I } translate <-.9,0,1.6> } merge { sphere { 0, .5 inverse } box { <.3,.3,-.3>, .7 } texture { T } interior_texture { I } translate <.9,0,1.6> }")},
        {"InteriorTextureOfOldGlass", "#version 3.0; global_settings { assumed_gamma 1 } background { rgb <.7,.8,1> } light_source { <-7,8,-6> 1 } camera { location <0,3,-4> look_at 0 } plane { y, -1.6 pigment { checker rgb 1 rgb <1,.2,.2> scale .5 } } "
                                     "sphere { 0, 1.2 texture { pigment { rgbt .9 } finish { refraction 1 ior 1.5 } } interior_texture { pigment { rgbt <.9,.2,.2,.9> } } }"},
        {"SheetsTakenAway", seen(sheets())},
        {"SpindleTori", seen("torus { .35, .8 pigment { rgbt <.9,.95,1,.8> } finish { phong .6 reflection .1 } translate -1.6*x } torus { .5, .8 rotate x*60 pigment { gradient y color_map { [.6 rgbt 1] [.6 rgb <1,.6,.1>] } scale .3 } } "
                             "difference { torus { .3, .7 } box { -1, <0,1,0> } pigment { rgb <.5,1,.6> } finish { phong 1 } translate <1.7,0,0> } intersection { torus { .2, .8 rotate z*90 } plane { z, 0 } pigment { checker rgb 1 rgb <.2,.3,1> scale .2 } translate <1.2,.4,2> } "
                             "difference { box { -.6, .6 } torus { .25, .5 translate -.5*z } pigment { rgb <1,1,.5> } translate <-1,0,2> } merge { torus { .3, .6 } sphere { .4*x, .5 } pigment { rgbt <1,.8,.8,.7> } translate <0,-.3,-2> }")},
        {"ClippedGlassFromBehind", seen("plane { -y, 0 clipped_by { sphere { 0, 1.2 } }" + glass + "translate -1.5*x } quadric { 1, 0, 0, -1 clipped_by { plane { y, 0 } }" + glass + "translate 1.5*x }")},
        {"FadingWithoutPower", seen("box { <-1,-1,-1>, <0,1,1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { fade_distance 1 } } sphere { <1,0,0>, .8 pigment { rgbt <1,1,1,.7> } interior { fade_distance 3 fade_color <1,.5,0> } } sphere { <0,3,-4>, 2 hollow pigment { rgbt 1 } interior { fade_distance 2 fade_color <1,1,.2> } }")},
        {"CameraInGlass", seen("sphere { <0,3,-4>, 2 pigment { rgbt <.8,.9,1,.9> } interior { ior 1.2 fade_distance 3 fade_power 1 } } box { <-1,-1,-1>, <1,0,1>" + glass + "rotate y*30 }")},
        {"CameraInGlassInWater", seen("sphere { <0,3,-4>, .5" + glass + "} box { <-5,-1.5,-6>, <5,4,-2> pigment { rgbt <.6,.8,1,.9> } interior { ior 1.33 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }")},
        {"OrthographicInGlass", seen("box { <-5,-1.5,-6>, <.2,4,-2> pigment { rgbt <.6,.8,1,.9> } interior { ior 1.33 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }", "camera { orthographic location <0,3,-4> look_at 0 }")},
        {"FresnelMirrorsInWater", seen("sphere { 0, 9 pigment { rgbt 1 } interior { ior 1.15 } } background { rgb <1,.8,.6> } box { -1, 1 pigment { rgb .2 } finish { reflection { 1 fresnel } } rotate y*20 } "
                                       "sphere { <1.8,.2,0>, .7 texture { pigment { rgb .2 } finish { reflection { 1 fresnel } } } texture { pigment { checker rgb x rgbt 1 scale .3 } } } plane { y, -1.5 pigment { rgb <.3,.4,.2> } finish { reflection { .2, .9 fresnel } } }")},
        {"CameraInAUnionOfGlass", seen("union { sphere { <0,3.1,-4.2>, 1 } box { <-1,2.2,-5>, <1,4,-3.3> } pigment { rgbt <.5,.9,.4,.95> } interior { ior 1.4 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }")},
        {"CameraInASolidOfGlasses", seen("intersection { sphere { <0,3,-4>, 2 pigment { rgbt .9 } interior { ior 1.2 } } box { <-1,2,-5>, <2,4,-3> pigment { rgbt .9 } interior { ior 1.6 } } } sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }")},
        {"CameraInSetsWhosePartsHaveInteriors", in_fog("merge { sphere { 0, 2 interior { ior 1 } } sphere { .5*x, 3.5 interior { ior 1 } } " + clear + "}")},
        {"CameraInADifferenceWhosePartsHaveInteriors", in_fog("difference { sphere { .5*x, 4 interior { ior 1 } } sphere { 0, 12 inverse interior { ior 1 } } " + clear + "interior { ior 1 } }")},
        {"CameraInTwoPartsOfABoundedUnion", in_fog("union { sphere { 0, 2 } sphere { .5*x, 3.5 } " + clear + "bounded_by { sphere { 0, 30 } } }")},
        {"CameraInABoundedUnionWhosePartsHaveInteriors", in_fog("union { sphere { 0, 2 interior { ior 1 } } sphere { .5*x, 3.5 interior { ior 1 } } " + clear + "bounded_by { sphere { 0, 30 } } }")},
        {"CameraInAHollowUnionOfBodies", in_fog("union { sphere { 0, 2 interior { ior 1 } } sphere { .5*x, 3.5 interior { ior 1 } } hollow " + clear + "bounded_by { sphere { 0, 30 } } }")},
        {"CameraInABoundedUnionOfACylinderATorusAndAnInverse", seen("fog { distance 6 rgb <.6,.6,.9> } union { cylinder { <1.24,-.52,-.52>, <-1.29,1.44,-.06>, 1.4 } torus { 1.96, .53 rotate <76.58,76.01,54.25> translate <-.73,.05,.15> } sphere { <.98,.57,.41>, 1.87 inverse } "
                                     "pigment { rgbf <.9,.8,.8,.7> } interior { ior 1.3 } bounded_by { box { -3.6, 2.6 } } }", "camera { location <-1.26,-.36,.91> look_at <-.45,-.4,.05> angle 80 }")},
        {"CameraInAMovedInverseOfAnInverse", seen("#declare X = cylinder { <-1,3,-4>, <1,4,-3>, .7" + glass + "} object { object { X inverse } inverse } object { mesh { triangle { <-3,0,-6>, <3,0,-6>, <0,6,-6> } triangle { <-3,0,-2>, <3,0,-2>, <0,6,-2> } } inverse" + glass + "}")},
        {"FogAroundClippedSheets", seen("fog { distance 6 rgb <.5,.4,.3> } disc { <1,0,1>, <.8,-.6,.8>, .9 pigment { rgb y } clipped_by { plane { y, 1 } } } merge { box { -.8, .6 inverse } sphere { x, .9 } pigment { rgb <.6,.6,1> } }")},
    };
}

}  // namespace alidade::test
