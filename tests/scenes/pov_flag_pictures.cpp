// SPDX-License-Identifier: Apache-2.0
/// no_image, no_shadow and no_reflection of what is a part of something.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

std::vector<PovPicture> flag_pictures() {
    const std::string usual = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.1,.2,.3> } camera { location <0,2,-6> look_at <0,.5,0> angle 50 } light_source { <10,20,-15> rgb <1,.9,.8> } "
                              "plane { y, -1 pigment { rgb .6 } finish { reflection .4 } } ";
    return {
        {"FlagsOfParts", usual + "merge { sphere { 0, .8 no_image } box { <0,-.5,-.5>, "
         "<1.4,.5,.5> pigment { rgb <1,0,0> } } pigment { rgb 1 } translate <-1,.5,0> } difference { box { -.6, .6 no_image "
         "no_shadow } sphere { <0,.3,-.6>, .5 no_image } pigment { rgb <0,1,1> } translate <1.5,.5,-1> no_reflection }"},
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
        {"LightGroupsByName", usual + "#declare G = light_group { light_source { <-5,5,-5> rgb <.2,.4,1> } sphere { 0, .7 pigment { rgb 1 } } global_lights on } light_group { G translate x } object { G translate -x }"},
        {"DeclaredLightGroups", usual + "#declare G = light_group { light_source { <-5,5,-5> rgb <.5,0,0> } sphere { 0, .7 pigment { rgb 1 } } } light_group { G global_lights on translate <-1.5,0,0> } light_group { G } light_group { light_group { light_source { <5,5,-5> "
         "rgb <0,.5,0> } sphere { 0, .5 pigment { rgb 1 } } global_lights off } sphere { x, .4 pigment { rgb y } } global_lights on translate <1.5,0,0> } "
         "light_group { object { G scale .5 } sphere { y, .3 pigment { rgb 1 } } global_lights on translate <.5,0,-2> } light_group { light_group { light_source { <5,5,-5> rgb x } sphere { 0, .3 pigment { rgb 1 } } global_lights on } box { 0, .3 } translate <-1,0,-3> }"},
    };
}

}  // namespace alidade::test
