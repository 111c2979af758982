// SPDX-License-Identifier: Apache-2.0
/// Pictures with alpha.
#include "tests/scenes/pov_pictures.h"

namespace alidade::test {

namespace {

/// What hides, filters, transmits, mirrors and fades, one before the other.
constexpr const char* kObjects = R"(
camera { location <0, 1, -8> look_at <0, 0.6, 0> angle 50 }
light_source { <-6, 9, -7> rgb 0.9 }
sphere { <-2, 1, 0>, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.7 reflection 0.4 } }
sphere { <0, 1, -1>, 0.9 pigment { rgbf <0.6, 0.9, 0.7, 0.8> } finish { specular 0.5 } interior { ior 1.2 fade_distance 2 fade_power 1 } }
box { <1, 0, -1>, <2, 1.5, 0> pigment { rgbt <0.2, 0.4, 0.9, 0.6> } finish { ambient 0.3 } }
sphere { <1.5, 1.6, 2>, 1 texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgbft <1, 0.8, 0.2, 0.3, 0.3>] } scale 0.4 } } finish { ambient 0.2 } }
disc { <0, -0.2, 1>, y, 3 pigment { checker rgb <0.8, 0.7, 0.6> rgbt <0.3, 0.4, 0.3, 0.5> } }
)";

std::string with(const char* more, const char* head = "#version 3.7; global_settings { assumed_gamma 1 }") { return std::string(head) + "\n" + more + kObjects; }

/// Highlights and a glow that are brighter than what is there of the glass, by one texture, layers and a map.
constexpr const char* kBright = R"(
sphere { <-1, 3.2, 1>, 0.9 pigment { rgbt 1 } finish { phong 3 phong_size 8 } }
sphere { <1, 3.4, 1>, 0.8 pigment { rgbt <1, 0.5, 0.2, 0.7> } finish { emission 1.9 specular 2 } }
box { <-4, 2.5, 0>, <-2.5, 4, 0.1> texture { pigment { rgbt 1 } finish { phong 1 } } texture { pigment { rgbf <0.9, 0.6, 0.4, 0.9> } finish { emission 1 } } }
box { <2.5, 2.5, 0>, <4, 4, 0.1> texture { gradient x texture_map { [0 pigment { rgbt 1 } finish { phong 2 }] [1 pigment { rgbf <0.9, 0.6, 0.4, 0.9> } finish { emission 1 }] } } }
)";

/// Of surfaces that let through more than all, and less than nothing.
constexpr const char* kBeyond = R"(
plane { z, 3 pigment { rgbt <0, 0, 0, 0.5> } finish { ambient 0 diffuse 0 } }
box { <-4, 2.4, 0>, <-2.5, 4, 0.1> pigment { rgbt <0, 0, 0, 1.5> } finish { ambient 0 diffuse 0 } }
box { <-2, 2.4, 0>, <-0.5, 4, 0.1> pigment { rgbf <2, 2, 2, 1> } finish { ambient 0 diffuse 0 } }
box { <0, 2.4, 0>, <1.5, 4, 0.1> pigment { rgbf <-1, -1, -1, 0.5> } finish { ambient 0 diffuse 0 } }
box { <2, 2.4, 0>, <4, 4, 0.1> pigment { average pigment_map { [1 rgbt <0, 0, 0, 1.5>] [1 rgbt <0, 0, 0, 0.2>] } } finish { ambient 0 diffuse 0 } }
)";

}  // namespace

std::vector<PovPicture> alpha_pictures() {
    const auto picture = [](const char* name, const char* more) { return PovPicture{name, with(more), "-A", {}, 9, true}; };
    const auto coded = [](const char* name, const char* more, const char* head) { return PovPicture{name, with(more, head), "-A", {}, 9, true}; };
    return {picture("Nothing", ""),
            picture("Background", "background { rgbt <0.2, 0.3, 0.5, 0.4> }"),
            picture("FilteringBackground", "background { rgbft <0.2, 0.3, 0.5, 0.3, 0.4> }"),
            picture("SkySphere", "sky_sphere { pigment { gradient y color_map { [0 rgbt <0.2, 0.3, 0.5, 1>] [1 rgbf <0.9, 0.8, 0.6, 0.5>] } } }"),
            picture("SkyOverBackground", "background { rgbt <0.6, 0.2, 0.1, 0.5> } sky_sphere { pigment { gradient y color_map { [0 rgbt <0.2, 0.3, 0.5, 0.8>] [1 rgb <0.9, 0.8, 0.6>] } } }"),
            picture("Fog", "fog { distance 9 rgbft <0.7, 0.6, 0.5, 0.2, 0.3> }"),
            picture("Bright", kBright),
            picture("Beyond", kBeyond),
            picture("BackgroundBeyond", "background { rgbt <0.2, 0.3, 0.5, -0.4> }"),
            picture("Rainbows", "rainbow { angle 30 width 40 distance 40 direction <0, -0.3, 1> color_map { [0 rgbt <1, 0.5, 0.2, 0.3>] [1 rgbft <0.2, 0.5, 1, 0.2, 0.8>] } } rainbow { angle 20 width 50 distance 9 direction <0.2, 0, 1> color_map { [0 rgbt <0, 0.5, 1, 0.9>] [1 rgbt 0.6] } }"),
            coded("Gamma", "global_settings { assumed_gamma 2.2 } background { rgbt <0.2, 0.3, 0.5, 0.4> }", "#version 3.7;"),
            coded("Srgb", "global_settings { assumed_gamma srgb } background { rgbt <0.2, 0.3, 0.5, 0.4> }", "#version 3.7;"),
            coded("Old", "background { rgbt <0.2, 0.3, 0.5, 0.4> } sky_sphere { pigment { gradient y color_map { [0 rgbt <0.2, 0.3, 0.5, 0.8>] [1 rgb <0.9, 0.8, 0.6>] } } }", ""),
            {"Fisheye", with("") + "camera { fisheye angle 150 location <0, 1, -5> look_at <0, 0.6, 0> }", "-A", {}, 9, true},
            {"Antialiased", with(""), "+A0.3 -J", Supersampling{}, 9, true},
            {"AntialiasedBright", with(kBright), "+A0.1 -J", Supersampling{.threshold = 0.1}, 9, true},
            {"AntialiasedCorners", with(""), "+A0.3 -J +AM2 +R2", Supersampling{2, 0.3, 2.5, 0, 2}, 9, true}};
}

}  // namespace alidade::test
