// SPDX-License-Identifier: Apache-2.0
/// Small scenes in POV-Ray's language, of all parts that are modelled.
#pragma once

#include "core/diagnostics.h"
#include "tracer/render.h"

#include <string>
#include <vector>

namespace alidade::test {

struct PovPicture {
    const char* name;
    std::string scene;
    const char* words = "-A";                          ///< POV-Ray's antialiasing
    std::optional<Supersampling> supersampling = {};   ///< and ours
    int quality = 9;                                   ///< of both
    bool alpha = false;                                ///< pictures have it
};

std::vector<PovPicture> patterned_pictures();
std::vector<PovPicture> light_pictures();
std::vector<PovPicture> sampled_pictures();
std::vector<PovPicture> fog_pictures();
std::vector<PovPicture> old_cameras();
/// They show the files of write_sample_pictures().
std::vector<PovPicture> image_pictures();
std::vector<PovPicture> effect_pictures();
std::vector<PovPicture> cutaway_pictures();
/// One scene in all qualities below the best.
std::vector<PovPicture> quality_pictures();
/// With alpha.
std::vector<PovPicture> alpha_pictures();
/// Of what textures begin with.
std::vector<PovPicture> default_pictures();
/// Of what is bounded too tightly.
std::vector<PovPicture> bound_pictures();
/// Of what is inside of what.
std::vector<PovPicture> inside_pictures();
/// Of what is seen by which rays.
std::vector<PovPicture> flag_pictures();
/// Of functions as patterns.
std::vector<PovPicture> function_pictures();
/// Of shadows of what is near to each other.
std::vector<PovPicture> shadow_pictures();
std::vector<PovPicture> other_pictures();
/// All of them.
std::vector<PovPicture> pov_pictures();

/// What is said of such a scene but what POV-Ray says, too, and what scenes do on purpose.
std::string said_beyond_povray(const Diagnostics& said);

}  // namespace alidade::test
