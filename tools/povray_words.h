// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's own words: +W320 -A Width=320 scene.ini[High] ...
#pragma once

#include "core/vec.h"
#include "importers/pov/limits.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace alidade {

/// What POV-Ray says goes by streams, each of which may have a file.
enum class MessageStream { all, debug, fatal, render, statistic, warning };
inline constexpr size_t kMessageStreams = 6;

/// What POV-Ray's words ask for. Source   POV-Ray 3.7 reference, 3.2 "Command-Line and INI-File Options".
struct PovrayRequest {
    std::string input, output;
    char file_type = 'N';
    int bits = 8;
    std::optional<double> file_gamma;     ///< of the picture's codes; none: sRGB's curve
    int width = 160, height = 120;
    bool to_file = true, antialias = false, verbose = false, alpha = false;
    bool continued = false;               ///< +C: what an earlier process has left is taken
    double antialias_threshold = 0.3, antialias_gamma = 2.5, jitter_amount = 1;
    int antialias_depth = 3, sampling_method = 1, quality = 9;
    bool jitter = true;
    int threads = 0;
    std::vector<std::string> library_paths, declarations;
    std::string header;                   ///< +HI: included before the scene
    double clock = 0, initial_clock = 0, final_clock = 1;
    bool clock_given = false;             ///< a still's clock is on, too
    bool cyclic = false;
    int frame_step = 1;
    int initial_frame = 1, final_frame = 1;
    double subset_start = 0, subset_end = kInf;   ///< frames, or shares of the animation below 1
    double start_column = 0, end_column = 0, start_row = 0, end_row = 0;   ///< pixels from 1, or shares of the picture up to 1; 0: all
    bool shows_scene_text = true;         ///< the console of the debug stream. Diagnostics always are shown
    std::array<std::string, kMessageStreams> message_files;   ///< by MessageStream; "": none
    std::optional<double> version;        ///< of the language, before the scene's first #version
    std::optional<std::string> write_folder;   ///< --allow-write=DIR, ours alone, too: where the scene may write
    pov::Limits limits;                   ///< --limit=NAME=N, ours alone, too
    uint64_t seed = 0;                    ///< --seed=N, a word that POV-Ray does not have: other random numbers
    std::vector<std::string> notes;       ///< words that are known and change nothing here, each once

    bool to_stdout() const { return to_file && output == "-"; }
    bool writes_file() const { return to_file && !to_stdout(); }
    bool animated() const { return final_frame > initial_frame || initial_frame != 1; }
};

/// Reads `words` in order; INI files where they stand, before all else POV-Ray's own povray.ini: the one that POVINI names, that of the working directory, the user's, or the system's, the first of
/// these that there is. An unknown word or value, or a file that cannot be read, is one sentence.
tl::expected<PovrayRequest, std::string> parse_povray_words(const std::vector<std::string>& words);

/// How often an animation's clock moves on; a cyclic one does not repeat its first frame.
double clock_steps(const PovrayRequest& request);
/// The clock of a frame, which goes evenly from the initial to the final one. In single precision, as POV-Ray's (by experiment).
double clock_of(const PovrayRequest& request, int frame);
/// The first and the last frame of the subset. Measured: a share is one of the number of frames, cut, whatever the first one's number is; nothing comes before the initial frame, but what the end says may lie
/// behind the final one; the first one is always rendered.
std::pair<int, int> subset_of(const PovrayRequest& request);
/// The output's name, beside the scene if none was given: for a frame of an animation with its number, as wide as that of the last one.
std::string output_name(const PovrayRequest& request, int frame);
/// The name of the file that keeps the tiles of a picture under way: as POV-Ray's.
std::string state_name(const std::string& output_name);

}  // namespace alidade
