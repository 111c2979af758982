// SPDX-License-Identifier: Apache-2.0
/// What whoever reads a scene may set: where files are, the clock, limits, where text goes.
#pragma once

#include "importers/pov/limits.h"

#include <cstdlib>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace alidade::pov {

/// The streams of #debug, #warning, #error, #render and #statistics.
enum class TextStream { debug, warning, error, render, statistics };
using PrintText = std::function<void(TextStream, const std::string&)>;

/// As POV-Ray hands numbers of its command line to a scene (by experiment).
inline double six_digits(double x) { return std::strtod(fmt::format("{:.6g}", x).c_str(), nullptr); }

/// Of an animation's frame; as POV-Ray has them without one.
struct FrameSettings {
    double clock = 0, clock_delta = 0, initial_clock = 0, final_clock = 0;
    int frame_number = 0, initial_frame = 0, final_frame = 0;
    bool clock_on = false;
    int image_width = 160, image_height = 120;
};

/// POV-Ray's `+Q`: from 9 on nothing is left out.
inline constexpr int kFullQuality = 9;

struct ReadOptions {
    std::vector<std::string> include_paths;
    bool scene_folder_last = false;                      ///< files are looked for in the scene's folder behind all others, not before them
    std::string header;                                  ///< included before the scene (POV-Ray's Include_Header=); empty: none
    std::vector<std::string> declarations;               ///< NAME=VALUE, a float each (POV-Ray's Declare=)
    std::optional<std::string> write_folder;             ///< #fopen ... write works below it, and nowhere else
    FrameSettings frame;
    std::optional<double> version;                       ///< as if #version gave it before all; absent: none is given
    int quality = kFullQuality;                          ///< 0 to 9: less than full, and the scene is read without what takes time (quality.h)
    bool strict = false;                                 ///< names of files are not found in another case
    Limits limits;
    PrintText print;                                     ///< absent: notes; #warning becomes a warning in any case
};

}  // namespace alidade::pov
