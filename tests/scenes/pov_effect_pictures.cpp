// SPDX-License-Identifier: Apache-2.0
/// Rainbows, a shifted sky, thin films, bent camera rays, powers of reflections, projected light, normals that face away.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

const std::string kEffectHead = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.3,.5,.7> }\n";
const std::string kSun = "light_source { <10,20,-15> rgb <1,.9,.8> }\n";
const std::string kView = "camera { location <0,2,-6> look_at <0,.5,0> angle 50 }\n";
const std::string kFaces = kEffectHead + "camera { location <0,1,-7> look_at <0,.4,0> angle 45 } sky_sphere { pigment { gradient y color_map { [0 rgb x] [1 rgb z] } scale 2 translate -1 } }\n";
const std::string kFloor = "plane { y, -1 pigment { checker rgb 1 rgb <1,0,0> } }\n";

/// Looks at the point opposite of the sun, above a floor with a ball that mirrors it.
std::string rainbow(const std::string& bows) {
    return kEffectHead + kSun + kFloor + "camera { location <0,2,-6> look_at <0,2,0> angle 95 } sphere { <1,.5,1>, 1 hollow pigment { rgb .2 } finish { reflection .8 } } sphere { <-2,0,-1>, 1 pigment { rgbt 1 } interior { ior 1.3 } }\n" + bows;
}

std::string bent(const std::string& camera) {
    return kEffectHead + kSun + kFloor + "camera { " + camera + " } sphere { <1,.5,1>, 1 pigment { rgb <.2,1,.3> } } box { <-2,-1,-1>, <-1,1,0> pigment { rgb <.2,.3,1> } }\n";
}

std::string projected(const std::string& light) {
    return kEffectHead + kFloor + "camera { location <0,4,-7> look_at 0 angle 50 } light_source { " + light + " } sphere { <.5,0,0>, .5 pigment { rgb <.2,1,.3> } finish { phong 1 } } sphere { <-.8,1,.3>, .3 pigment { rgbf <1,1,.2,.7> } } "
           "plane { -z, -4 pigment { rgb .8 } }\n";
}

}  // namespace

std::vector<PovPicture> effect_pictures() {
    const std::string colours = "color_map { [0 rgbt <.6,0,1,.9>] [.3 rgbft <0,.4,1,.2,.4>] [.6 rgbt <1,1,0,.3>] [1 rgbf <1,0,0,.5>] } ";
    const std::string mirrors = kEffectHead + kSun + kFloor + "camera { location <0,2,-6> look_at <0,.5,0> angle 50 } ";
    return {
        {"ShiftedSky", kEffectHead + kView + kSun + "sky_sphere { pigment { wood scale .4 } pigment { gradient y color_map { [0 rgbt <1,0,0,.2>] [1 rgbt 1] } } scale 2 translate <.3,.5,0> rotate z*20 } sphere { 0, 1 pigment { rgb .5 } finish { reflection .5 } }"},
        {"IridOfAnotherNoise", kEffectHead + kView + kSun + "global_settings { noise_generator 3 } " + "sphere { <-1,1,0>, 1 pigment { rgb <.4,.6,.8> } finish { irid { .4 thickness .7 turbulence .5 } } } plane { y, -2 pigment { rgb 1 } finish { reflection .4 irid { .3 thickness .2 turbulence 1 } } }"},
        {"RainbowAboveMirrorsAndGlass", rainbow("rainbow { direction <.1,-.2,1> angle 40 width 12 distance 30 " + colours + "}")},
        {"RainbowsThatMeet", rainbow("rainbow { direction <.1,-.2,1> angle 35 width 12 distance 30 " + colours + "} rainbow { direction <.1,-.2,2> angle 42 width 9 distance 1e4 color_map { [0 rgb x] [1 rgbt y+.5] } }")},
        {"ArcOfARainbow", rainbow("rainbow { direction <.3,-.2,1> angle 35 width 15 distance 1e3 up <.3,1,.1> arc_angle 150 falloff_angle 70 " + colours + "}")},
        {"RainbowFaintFromItsMiddle", rainbow("rainbow { direction <.3,-.2,1> angle 35 width 20 distance 1e3 falloff_angle 20 " + colours + "} fog { distance 40 rgb <.8,.9,1> }")},
        {"RainbowOutsideOfClearSpheres", rainbow("sphere { <0,2,-6>, 3 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } } sphere { <0,3,0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } } rainbow { direction <.1,-.2,1> angle 40 width 12 distance 10 " + colours + "}")},
        {"PowersOfReflections", mirrors + "sphere { <-1.1,0,0>, 1 pigment { rgb 0 } finish { reflection { .8 exponent .5 } } } sphere { <1.1,0,0>, 1 pigment { rgb <.1,.1,0> } finish { reflection { <1,.5,.2>, 1 exponent 2 } } } "
                                             "box { <-1,-1,2>, <1,2,3> texture { pigment { rgb 0 } finish { reflection { .5 exponent 2 } } } texture { pigment { rgbt 1 } finish { reflection { .25 exponent .5 } } } rotate y*20 }"},
        {"BentRays", bent("location <0,2,-6> look_at <0,.5,0> angle 50 normal { bumps .2 scale .1 }")},
        {"BentRaysOfADeclaredNormal", "#declare N = normal { gradient x .1 sine_wave frequency 7 phase .2 }\n" + bent("location <0,2,-6> look_at <0,.5,0> right 2*x normal { N rotate z*30 }")},
        {"BentRaysOfAFisheye", bent("fisheye angle 150 location <0,2,-6> look_at <0,.5,0> normal { bumps .3 scale .2 }")},
        {"BentRaysOfAnOmnimax", bent("omnimax location <0,2,-6> look_at <0,.5,0> normal { bumps .3 scale .2 }")},
        {"BentRaysOfAnUltraWideAngle", bent("ultra_wide_angle angle 110 location <0,2,-6> look_at <0,.5,0> normal { bumps .3 scale .2 }")},
        {"BentRaysOfAPanorama", bent("panoramic location <0,2,-6> look_at <0,.5,0> normal { bumps .3 scale .2 }")},
        {"BentRaysOfALyingCylinder", bent("cylinder 2 angle 120 location <0,2,-6> look_at <0,.5,0> normal { bumps .3 scale .2 }")},
        {"BentRaysOfAStandingCylinder", bent("cylinder 3 angle 120 location <0,2,-6> look_at <0,.5,0> normal { bumps .3 scale .2 }")},
        {"BentRaysOfASphere", bent("spherical angle 180 100 location <0,2,-6> look_at <0,.5,0> normal { bumps .3 scale .2 }")},
        {"BentParallelRays", bent("orthographic location <0,2,-6> look_at <0,.5,0> right 6*x up 4.5*y normal { ripples .1 scale .2 }")},
        {"ProjectedLight", projected("<2,6,-3> rgb 1 projected_through { union { disc { <1,3,-1.5>, y, .8, .3 } box { <-.5,2.9,-1>, <.2,3,.5> } } }")},
        {"ProjectedLightMoves", projected("<0,6,0> rgb 1 projected_through { sphere { <0,3,0>, .7 } } spotlight point_at 0 radius 30 falloff 40 rotate z*15 translate x")},
        {"ProjectedLightMovedBefore", projected("<2,5,-3> rgb 1 translate z rotate y*10 projected_through { box { <.5,2.4,-1>, <1.5,2.6,0> rotate y*20 } rotate y*5 } rotate y*-10")},
        {"LooksOfALight", projected("<1,1,-1> rgb 1 rotate y*20 looks_like { sphere { 0, .5 scale <1,.4,.4> } pigment { gradient x color_map { [.5 rgb x] [.5 rgb z] } scale .2 } finish { ambient 1 } rotate z*20 translate y*.3 } rotate z*10")},
        {"LooksOfADeclaredLight", "#declare L = light_source { <1,.5,0> rgb .7 rotate y*40 looks_like { box { -.2, <.5,.2,.2> pigment { rgb y } } } }\n" + projected("L rotate z*20") + " light_source { L translate <-2,.5,-1> }"},
        {"ShadowlessBehindSpotlight", projected("<2,6,-3> rgb 1 spotlight radius 5 falloff 8 point_at 0 shadowless")},
        {"SpotlightBehindShadowless", projected("<2,6,-3> rgb 1 shadowless spotlight radius 5 falloff 8 point_at 0")},
        {"CylinderBehindShadowless", projected("<2,6,-3> rgb 1 shadowless cylinder radius .5 falloff 1 point_at 0")},
        {"ShadowlessBehindCylinder", projected("<2,6,-3> rgb 1 cylinder radius .5 falloff 1 point_at 0 shadowless")},
        {"PowerOfAFilm", mirrors + "sphere { <-1.1,0,0>, 1 pigment { rgb .1 } normal { bumps .3 scale .3 } finish { reflection { .8 exponent 1.6 } irid { .4 thickness .5 } } } sphere { <1.1,0,0>, 1 pigment { rgb .1 } normal { bumps .6 scale .2 } finish { reflection .8 irid { .4 thickness .5 } } }"},
        {"NegativeFinishes", mirrors + "sphere { <-1.3,0,0>, 1 pigment { rgb <1,.5,.3> } finish { phong -.5 phong_size 3 } } sphere { <1.3,0,0>, 1 pigment { rgb <1,.5,.3> } finish { specular -.5 roughness .3 } } sphere { <0,0,-1>, .6 pigment { rgb 1 } finish { diffuse -.5 ambient .3 } }"},
        {"MirrorsOfSmoothTriangles", kFaces + "smooth_triangle { <-2,-1,-1>, <0,1,.1>, <0,-1,-1>, <0,1,.1>, <-1,1,1>, <0,1,.1> pigment { rgb 0 } finish { reflection 1 ambient 0 } } mesh { smooth_triangle { <0,-1,-1>, <0,1,-.3>, <2,-1,-1>, <0,1,.2>, <1,1,1>, "
         "<.3,1,-1> } pigment { rgb 0 } normal { bumps .4 scale .2 } finish { reflection 1 ambient 0 } } mesh2 { vertex_vectors { 4, <-2,1,0>, <2,1,0>, <2,2,.5>, <-2,2,.5> } normal_vectors { 4, <-1,.5,-1>, <1,.5,-1>, <1,1,1>, <-1,1,.5> } face_indices { 2, "
         "<0,1,2>, <0,2,3> } pigment { rgbt 1 } finish { reflection .7 ambient 0 } interior { ior 1.4 } }"},
        {"WavesThatFaceAway", kFaces + "plane { y, -.5 hollow pigment { rgbt 1 } normal { waves .4 scale .6 } finish { ambient 0 diffuse 0 } interior { ior 1.33 } } sphere { <1,.5,0>, .6 pigment { rgbt 1 } normal { bumps 1.5 scale .2 } interior { ior 1.5 } }"},
        {"UvMappedIsMovedNoMore", kEffectHead + kView + kSun + "#declare G = texture { pigment { uv_mapping gradient x } } #declare PS = pigment { uv_mapping checker rgb 1 rgb x scale .2 } #declare UT = texture { uv_mapping pigment { checker rgb 1 rgb y } scale .1 } "
         "#declare N = normal { uv_mapping gradient x 1 scale .1 } sphere { -1.8*x, .8 texture { pigment { uv_mapping checker rgb 1 rgb x scale .3 } rotate z*45 scale .4 } } sphere { 0, .8 texture { G scale .3 } } sphere { 1.8*x, .8 pigment { PS rotate 20*z scale 2 } } "
         "sphere { <-2,1.6,0>, .7 texture { UT scale 3 } } sphere { <0,1.6,0>, .7 pigment { rgb 1 } normal { N scale 4 } } sphere { <2,1.6,0>, .7 material { texture { G scale .2 } } } sphere { <-1,.4,-2>, .3 pigment { PS turbulence .4 warp { repeat .3*x flip x } } normal { N .3 scale 2 bump_size 3 } } sphere { <1,.5,-2>, .4 texture { uv_mapping pigment { gradient y } scale .2 } rotate 30*x } "
         "box { <-1,.3,-2>, <-.5,.8,-1.5> texture { checker texture { G scale .3 } texture { UT scale 2 } scale .2 } }"},
        {"FogThatIsTurned", kEffectHead + kView + kSun + "fog { fog_type 2 distance 6 rgb 1 fog_offset .3 fog_alt .6 rotate z*10 scale <1,2,3> translate 4 } sphere { 0, 1 pigment { rgb y } }"},
        {"WarpsOfLongVectors", kEffectHead + kView + kSun + "sphere { -1.8*x, .8 pigment { checker rgb 1 rgb x scale .2 warp { cylindrical orientation 2.5*x } } } sphere { 0, .8 pigment { checker rgb 1 rgb y scale .2 warp { spherical orientation 3*y } } } "
         "sphere { 1.8*x, .8 pigment { checker rgb 1 rgb z scale .2 warp { planar 2*y, .3 } } } sphere { <0,1.6,0>, .8 pigment { checker rgb 1 rgb z scale .2 warp { toroidal orientation .5*z major_radius .5 } } }"},
        {"UvMappedBumpsTurnWithObjects", kEffectHead + kView + kSun + "#declare N = normal { gradient x 2 scale .1 } #declare T = texture { uv_mapping pigment { rgb <1,.8,.5> } normal { N } } #declare S = texture { pigment { rgb <.5,.9,1> } normal { uv_mapping gradient x 2 scale .1 } } "
         "#macro B() box { -.35, .35 #end B() texture { T } rotate 50*y translate <-1.5,.6,0> } B() texture { S } rotate 50*y translate <-.5,.6,0> } B() rotate 50*y texture { T } translate <.5,.6,0> } B() uv_mapping texture { T } scale <1,1,.3> rotate 20*x translate <1.5,.6,0> } "
         "B() texture { T rotate <40,20,30> scale <.7,1,.5> } rotate -40*y translate <-1.5,-.5,0> } union { B() rotate 30*y } B() translate x rotate 10*y } texture { T } rotate <20,10,0> translate <-.5,-.5,0> } B() uv_mapping texture { normal { N } pigment { rgb 1 } } rotate 50*y translate <1.5,-.5,0> }"},
        {"BumpsOfTexturesInMaps", kEffectHead + kView + kSun + "#declare A = texture { pigment { rgb 1 } normal { gradient x 3 translate .5*x } } #declare K = texture { pigment { rgb <.3,.1,.1> } } #declare S = texture { spherical texture_map { [0 K] } rotate 45*y } "
         "#declare R = texture { average texture_map { [1 K] } rotate 25*y } #macro B(X,Y) rotate <-20,30,0> translate <X,Y,0> } #if (X < 1) box { -.35, .35 #end #end box { -.35, .35 "
         "texture { gradient y texture_map { [0 A] [1 S] } } B(-1,.5) texture { average texture_map { [1 S] [0 average texture_map { [1 K] } rotate <0,-60,-25> scale <1.3,1,1>] [1 A] } } B(0,.5) "
         "texture { gradient y texture_map { [0 pigment { rgb 1 } normal { gradient x 3 no_bump_scale scale .5 } scale .3] [1 uv_mapping average texture_map { [1 R] } rotate 45*y] } scale <2,1,.5> } B(1,.5) "
         "box { -.35, .35 uv_mapping texture { checker texture { A } texture { A } scale .1 } B(-1,-.5) texture { average texture_map { [1 R] [1 pigment { rgb 1 } normal { uv_mapping gradient x 3 }] } rotate 20*x } B(0,-.5) "
         "texture { checker texture { A } texture { spherical texture_map { [0 A] } rotate <45,20,0> } scale .3 } B(1,-.5)"},
        {"UvMappedMapsTurnWithObjects", kEffectHead + kView + kSun + "#declare A = texture { pigment { rgb <1,.8,.5> } normal { gradient x 2 scale .2 } } #declare U = texture { uv_mapping checker texture { A } texture { pigment { rgb <.5,.8,1> } normal { gradient y 2 scale .3 } } scale .3 } #declare B = box { -.35, .35 } "
         "#macro To(X,Y) rotate <20,40,30> scale <1,1,.6> translate <X,Y,0> } #end object { B texture { U } To(-1.4,.8) object { B texture { U rotate 40*y } To(-.4,.8) object { B uv_mapping texture { U } To(.6,.8) object { B uv_mapping texture { U rotate 40*y } To(1.6,.8) "
         "union { object { B texture { U } rotate 25*z } sphere { y, .1 } To(-1.4,-.3) object { B texture { gradient y texture_map { [.3 U rotate <10,20,30>] [.7 A] } rotate 40*z } To(-.4,-.3) object { B uv_mapping pigment { rgb 1 } normal { gradient x 2 scale .2 rotate 40*y } To(.6,-.3) "
         "#declare S = texture { uv_mapping pigment { rgb <.6,1,.6> } normal { gradient x 2 scale .2 } } object { B uv_mapping texture { S rotate 40*y } To(1.6,-.3)"},
        {"UvMappedAroundMovedParts", kEffectHead + kView + kSun + "#declare P = texture { pigment { checker rgb 1 rgb <1,0,0> scale .2 } normal { gradient x 2 scale .3 } } #declare U = texture { uv_mapping pigment { checker rgb 1 rgb <0,.6,0> scale .2 } normal { gradient x 2 scale .3 } } #declare R = transform { rotate <20,40,30> } "
         "union { sphere { 0, .5 texture { P } transform { R } translate <-1.3,.8,0> } sphere { 0, .5 texture { P rotate 30*y } translate <0,.8,0> } box { -.4, .4 transform { R } texture { P } translate <1.3,.8,0> } uv_mapping rotate 10*x } "
         "union { union { sphere { 0, .5 texture { U } transform { R } translate <-1.3,0,0> } torus { .4, .15 texture { gradient y texture_map { [.4 P] [.6 U] } } transform { R } } } difference { box { -.4, .4 texture { P } } sphere { <.4,.4,-.4>, .4 texture { U } } transform { R } translate <1.3,0,0> } translate -.4*y uv_mapping } "
         "union { mesh { triangle { <-2,-1.5,0>, <2,-1.5,0>, <0,-1,0> uv_vectors <0,0>, <2,0>, <1,1> texture { P } } rotate 20*x } sphere { 9, 1 } uv_mapping }"},
        {"UvMappingIsOfSurfaces", kEffectHead + kView + kSun + "#default { pigment { checker rgb 1 rgb z scale .25 } } #declare P = texture { pigment { checker rgb 1 rgb x scale .25 } } #declare U = texture { uv_mapping pigment { checker rgb 1 rgb y scale .25 } } #declare S = sphere { 0, .5 } #declare C = plane { x, .1 rotate 40*y } "
         "#declare M = mesh { triangle { <-.5,-.5,0>, <.5,-.5,0>, <0,.5,0> uv_vectors <0,0>, <2,0>, <1,1> texture { P } } triangle { <-.5,-.5,0>, <0,.5,0>, <-.5,.5,.1> uv_vectors <0,0>, <1,1>, <0,2> texture { U } } } "
         "union { object { S uv_mapping translate <-1.5,1,0> } object { S translate <-.4,1,0> } texture { P } rotate 10*x } union { object { S translate <.7,1,0> } box { -.4, .4 rotate 30*y translate <1.7,1,0> } uv_mapping rotate 10*x } "
         "union { object { S texture { P } interior_texture { P } clipped_by { C } translate <-1.5,-.3,0> } object { S texture { P } clipped_by { C } translate <-.4,-.3,0> } uv_mapping rotate 10*x } "
         "object { M rotate 20*z uv_mapping translate <.7,-.3,0> } union { object { M rotate 20*z } uv_mapping translate <1.7,-.3,0> }"},
        {"BehindUvMappedNames", kEffectHead + kView + kSun + "#declare M = color_map { [0 rgb 1] [1 rgb x] } #declare P = pigment { uv_mapping gradient x color_map { M } scale .3 } #declare N = normal { uv_mapping gradient x 2 scale .2 } #declare T = texture { pigment { P } normal { N } rotate 30*z } #declare S = sphere { 0, .5 } "
         "#macro At(X,Y) translate <X,Y,0> } #end object { S pigment { P gradient y } At(-1.5,1) object { S pigment { P scale 2 } At(-.5,1) object { S pigment { P gradient y color_map { M } scale .5 } At(.5,1) object { S pigment { P frequency 3 color_map { [0 rgb y] [1 rgb z] } } At(1.5,1) "
         "object { S texture { T pigment { gradient y } normal { gradient y scale 2 } } At(-1.5,-.1) object { S texture { T pigment { uv_mapping gradient y } normal { uv_mapping gradient y } } At(-.5,-.1) object { S texture { T pigment { turbulence 1 } normal { bump_size .1 } } At(.5,-.1) "
         "object { S uv_mapping pigment { P } pigment { gradient y } At(1.5,-.1) #default { pigment { P } normal { N } } object { S pigment { gradient y color_map { M } } normal { ripples } scale .6 At(-1,-1) object { S pigment { scale .1 } scale .6 At(0,-1) object { S pigment { checker pigment { gradient y } pigment { rgb 1 } scale .3 } scale .6 At(1,-1)"},
        {"UvMappedBeforeNames", kEffectHead + kView + kSun + "#declare P = pigment { gradient x color_map { [0 rgb x] [.5 rgb y] [1 rgb z] } } #declare Q = pigment { uv_mapping P rotate 20*z } #declare N = normal { bumps 1 scale .2 } "
         "box { -.6, .6 pigment { uv_mapping P scale .5 } normal { uv_mapping N scale 2 } rotate 30*y } sphere { <-1.4,0,0>, .6 pigment { checker pigment { uv_mapping P } pigment { rgb 1 } scale .5 } } box { <1,-.5,-.5>, <2,.5,.5> texture { pigment { Q } normal { N } } rotate 10 }"},
        {"UvMappedAround", kEffectHead + kView + kSun + "#declare T = texture { pigment { checker rgb x rgb y scale .2 } finish { ambient .4 } } #declare B = sphere { 0, .7 texture { T } } union { object { B } sphere { x, .4 texture { T } } object { B scale .5 translate y texture { T } } sphere { -1.5*x, .7 pigment { gradient x } } "
         "uv_mapping } object { B translate 1.5*x } mesh2 { vertex_vectors { 4, <-1,1,0>, <1,1,0>, <1,2,0>, <-1,2,0> } uv_vectors { 4, <0,0>, <3,0>, <3,2>, <0,2> } texture_list { 2, texture { T } texture { pigment { gradient y } } } face_indices { 2, <0,1,2>, "
         "0, <0,2,3>, 1 } uv_mapping } difference { box { <-.5,-1,-1>, <.5,-.3,0> texture { T } } sphere { <0,-.3,-.7>, .4 texture { T } } uv_mapping }"},
        {"BackgroundOfAFloat", "#version 3.7; global_settings { assumed_gamma 1 } background { .5 } " + kView + kSun + "#declare C = rgb <.4,.2,.8>; sphere { 0, 1 pigment { rgb .5 } finish { reflection .5 } } sphere { <-1.5,1,0>, .6 pigment { C.red } } sphere { <1.5,1,0>, .6 pigment { color C.red } finish { ambient C.green } }"},
        {"ClearBackground", "#version 3.7; global_settings { assumed_gamma 1 } background { rgbft <.5,.3,.7,.3,.4> } sky_sphere { pigment { gradient y color_map { [.4 rgbt 1] [.6 rgbft <.2,.9,.4,.3,.5>] } } }\n" + kSun + kFloor + "camera { location <0,2,-6> look_at <0,2,0> angle 95 }"},
        {"ProjectedShadowlessLight", projected("<2,6,-3> rgb 1 shadowless projected_through { text { ttf \"cyrvetic.ttf\" \"Ab\" .2, 0 rotate x*90 scale 1.5 translate <0,3,-1.5> } }")},
        {"ProjectedParallelLight", projected("<1,6,0> rgb 1 parallel point_at 0 projected_through { torus { 1, .3 translate y*2.5 } }")},
        {"ProjectedAreaLight", projected("<1,6,0> rgb 1 area_light x, z, 3, 3 projected_through { cylinder { <.5,3,-.5>, <.5,3.1,-.5>, .9 } }")},
    };
}

}  // namespace alidade::test
