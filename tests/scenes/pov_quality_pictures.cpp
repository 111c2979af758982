// SPDX-License-Identifier: Apache-2.0
/// What `+Q` leaves out.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

/// All that some quality leaves out: fog, a rainbow, mirrors, bumps, glass, quick colours, also inherited ones, an area light and one through an object, shadows, layers, finishes that glow or share their light.
constexpr const char* kScene = R"(#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 0.8 }
camera { location <0, 2, -8> look_at <0, 0.8, 0> angle 50 }
background { rgb <0.2, 0.3, 0.5> }
fog { distance 60 rgb <0.7, 0.6, 0.5> }
rainbow { direction <0.2, -0.1, 1> angle 12 width 8 distance 30 color_map { [0 rgbt <1, 0, 0, 0.5>] [1 rgbt <0, 0, 1, 0.5>] } }
light_source { <-6, 9, -7> rgb 0.9 area_light x*5, y*5, 3, 3 }
light_source { <0, 8, -3> rgb 0.4 projected_through { box { <-1, 5, -3>, <1, 5.1, -1> pigment { rgbt <1, 0.5, 0, 0.5> } } } }
light_source { <7, 5, -4> rgb <0.3, 0.3, 0.4> spotlight point_at 0 radius 20 falloff 30 }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.3, 0.4, 0.3> } finish { ambient 0.2 reflection 0.3 } }
sphere { <-2, 1, 0>, 1 pigment { rgb <0.8, 0.3, 0.2> } normal { bumps 0.8 scale 0.3 } finish { phong 0.7 ambient 0.1 } }
sphere { <0, 1, -1>, 0.9 pigment { rgbf <0.6, 0.9, 0.7, 0.6> } finish { specular 0.5 emission 0.05 } interior { ior 1.3 } }
sphere { <2, 1, 0>, 1 texture { pigment { rgb <0.1, 0.2, 0.9> } } texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgbt <1, 0.8, 0.2, 0.3>] } scale 0.4 } } }
box { <-0.6, 2.2, 1>, <0.6, 3.2, 2> pigment { wood color_map { [0 rgb <0.6, 0.4, 0.2>] [1 rgb <0.3, 0.2, 0.1>] } scale 0.2 quick_color rgb <0.2, 0.8, 0.3> } }
#declare Quick = pigment { rgb <0.9, 0.1, 0.1> quick_color rgb <0.1, 0.3, 0.9> };
sphere { <-2.6, 2.8, 1>, 0.6 pigment { Quick gradient y color_map { [0 rgb 0.2] [1 rgb 0.9] } translate y/3 } }
sphere { 0, 0.4 texture { pigment { gradient x quick_color rgb <0.1, 0.9, 0.9> } scale 0.3 } translate <-1.2, 2.6, 0> }
sphere { <-3.6, 1.2, 1>, 0.6 texture { pigment { Quick } } texture { pigment { rgb <0.6, 0.6, 0.1> } } }
#default { pigment { rgb 0.3 quick_color rgb <0.7, 0.7, 0.9> } }
sphere { <3.4, 2.8, 1>, 0.5 pigment { rgb <1, 0.6, 0.8> } }
sphere { <1.9, 2.9, 1>, 0.5 texture { pigment { rgb <0.2, 0.9, 0.4> } } texture { pigment { checker rgb <1, 0.3, 0.2> rgbt <0, 0, 0, 1> scale 0.3 } } }
sphere { <3.6, 1.4, -0.5>, 0.5 texture { pigment { rgbf <0.9, 0.4, 0.4, 0.9> } } texture { pigment { rgbt <0.1, 0.1, 0.3, 0.7> } finish { reflection 0.5 conserve_energy } } }
)";

/// Layers whose filters are numbers, but for the lowest: the last one is reached through each of them.
constexpr const char* kOldScene = R"(#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 }
light_source { <-6, 9, -7> rgb 1 }
sphere { 0, 1.5 texture { pigment { rgbf <1, 0.2, 0, 1> } } texture { pigment { rgbf <0, 0, 1, 1> } } texture { pigment { gradient y color_map { [0.5 rgbf <0, 1, 0, 0.6>] [0.5 rgb <1, 1, 0>] } } } }
)";

/// Pigments in pigments, in patterns of textures and of the sky.
constexpr const char* kInside = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 }
light_source { <-6, 9, -7> rgb 1 }
sky_sphere { pigment { gradient y quick_color rgb <0.3, 0.1, 0.5> } }
#declare Quick = pigment { bozo scale 0.1 quick_color rgb <0.9, 0.6, 0> }
sphere { <-2, 1, 0>, 0.9 pigment { checker pigment { rgb y quick_color rgb x } pigment { rgb z } scale 0.4 } }
sphere { <0, 1, 0>, 0.9 pigment { gradient x pigment_map { [0 rgb y quick_color rgb x] [1 Quick scale 3] } } }
sphere { <2, 1, 0>, 0.9 pigment { average pigment_map { [1 rgb y quick_color rgb x] [2 rgb z] } } }
sphere { <-2, -1, 0>, 0.9 pigment { checker pigment { Quick } pigment { rgb z } quick_color rgb <0.2, 0.5, 0.2> } }
sphere { <0, -1, 0>, 0.9 texture { pigment_pattern { checker pigment { rgb 0 } pigment { rgb 1 } quick_color rgb 0.2 } texture_map { [0 pigment { rgb x }] [1 pigment { rgb y }] } } }
sphere { <2, -1, 0>, 0.9 pigment { rgb 1 } normal { pigment_pattern { checker pigment { Quick } pigment { rgb 1 } scale 0.3 } 0.5 } }
)";

}  // namespace

std::vector<PovPicture> quality_pictures() {
    static constexpr const char* kNames[] = {"Q0", "Q1", "Q2", "Q3", "Q4", "Q5", "Q6", "Q7", "Q8"};
    std::vector<PovPicture> pictures;
    for (int quality = 0; quality < int(std::size(kNames)); ++quality) pictures.push_back({kNames[quality], kScene, "-A", {}, quality});
    pictures.push_back({"QuickInsideQ5", kInside, "-A", {}, 5});
    pictures.push_back({"OldFiltersQ1", kOldScene, "-A", {}, 1});
    return pictures;
}

}  // namespace alidade::test
