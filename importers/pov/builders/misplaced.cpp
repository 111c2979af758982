// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/misplaced.h"

#include <algorithm>

namespace alidade::pov {

namespace {

/// Kinds of blocks that were asked. What is none of them (media, photons, maps ...) refuses nothing here.
constexpr WordId kBlocks[] = {
    "finish"_w, "pigment"_w, "normal"_w, "texture"_w, "interior"_w, "material"_w, "camera"_w, "light_source"_w, "fog"_w, "sky_sphere"_w, "background"_w, "global_settings"_w,
    "sphere"_w, "box"_w, "plane"_w, "torus"_w, "cylinder"_w, "cone"_w, "disc"_w, "union"_w, "merge"_w, "intersection"_w, "difference"_w, "object"_w};

struct Home {
    WordId word, blocks[2];       ///< where alone it is taken
};
constexpr Home kHomes[] = {
    {"ambient"_w, {"finish"_w}}, {"diffuse"_w, {"finish"_w}}, {"brilliance"_w, {"finish"_w}}, {"phong"_w, {"finish"_w}}, {"phong_size"_w, {"finish"_w}}, {"specular"_w, {"finish"_w}},
    {"roughness"_w, {"finish"_w}}, {"crand"_w, {"finish"_w}}, {"conserve_energy"_w, {"finish"_w}}, {"irid"_w, {"finish"_w}}, {"reflection_exponent"_w, {"finish"_w}},
    {"metallic"_w, {"finish"_w}}, {"reflection"_w, {"finish"_w}}, {"emission"_w, {"finish"_w, "sky_sphere"_w}},
    {"location"_w, {"camera"_w}}, {"look_at"_w, {"camera"_w}}, {"direction"_w, {"camera"_w}}, {"right"_w, {"camera"_w}}, {"sky"_w, {"camera"_w}}, {"aperture"_w, {"camera"_w}},
    {"blur_samples"_w, {"camera"_w}}, {"focal_point"_w, {"camera"_w}}, {"confidence"_w, {"camera"_w}}, {"variance"_w, {"camera"_w}},
    {"ior"_w, {"interior"_w, "finish"_w}}, {"caustics"_w, {"interior"_w, "finish"_w}}, {"refraction"_w, {"interior"_w, "finish"_w}}, {"dispersion"_w, {"interior"_w}},
    {"fade_color"_w, {"interior"_w}}, {"fade_distance"_w, {"interior"_w, "light_source"_w}}, {"fade_power"_w, {"interior"_w, "light_source"_w}},
    {"fog_type"_w, {"fog"_w}}, {"fog_offset"_w, {"fog"_w}}, {"fog_alt"_w, {"fog"_w}}, {"turb_depth"_w, {"fog"_w}},
    {"max_trace_level"_w, {"global_settings"_w}}, {"assumed_gamma"_w, {"global_settings"_w}}, {"ambient_light"_w, {"global_settings"_w}},
    {"spotlight"_w, {"light_source"_w}}, {"shadowless"_w, {"light_source"_w}}, {"point_at"_w, {"light_source"_w}}, {"tightness"_w, {"light_source"_w}}, {"area_light"_w, {"light_source"_w}},
    {"adaptive"_w, {"light_source"_w}}, {"looks_like"_w, {"light_source"_w}},
};

template <size_t N> bool contains(const WordId (&list)[N], WordId word) { return std::find(std::begin(list), std::end(list), word) != std::end(list); }

}  // namespace

std::optional<std::string_view> belongs_elsewhere(WordId word, WordId block) {
    if (!contains(kBlocks, block)) return std::nullopt;
    for (const Home& home : kHomes)
        if (home.word == word && !contains(home.blocks, block)) return kWords[home.blocks[0]];
    return std::nullopt;
}

}  // namespace alidade::pov
