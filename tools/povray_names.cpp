// SPDX-License-Identifier: Apache-2.0
/// What frames and their files are called.
#include "tools/povray_words.h"

#include "tools/values.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace alidade {

double clock_steps(const PovrayRequest& r) { return double(r.final_frame) - r.initial_frame + (r.cyclic ? 1 : 0); }

double clock_of(const PovrayRequest& r, int frame) {
    if (!r.animated()) return double(float(r.clock));
    const float first = float(r.initial_clock), range = float(r.final_clock) - first;
    const double steps = clock_steps(r);
    return double(steps > 0 ? float(double(first) + double(range) * (double(frame) - r.initial_frame) / steps) : first);
}

std::pair<int, int> subset_of(const PovrayRequest& r) {
    const double frames = double(r.final_frame) - r.initial_frame + 1;
    const auto number = [&](double end) { return int(end < 1 ? frames * std::max(end, 0.0) : end); };
    const int first = r.subset_start > 0 ? std::max(number(r.subset_start), r.initial_frame) : r.initial_frame;
    return {first, r.subset_end < kInf ? std::max(number(r.subset_end), first) : std::max(r.final_frame, first)};
}

std::string output_name(const PovrayRequest& r, int frame) {
    namespace fs = std::filesystem;
    fs::path path = r.output.empty() ? fs::path(r.input).replace_extension() : fs::path(r.output);
    const char* ending = r.file_type == 'P' ? ".ppm" : r.file_type == 'E' ? ".exr" : r.file_type == 'T' ? ".tga" : r.file_type == 'J' ? ".jpg" : r.file_type == 'B' ? ".bmp" : r.file_type == 'H' ? ".hdr" : ".png";
    // Without a slash the name of a folder is a file's, as in POV-Ray; which would call the files of these two ".png" and "..png".
    if (!r.output.empty() && (path.filename().empty() || r.output == "." || r.output == "..") && fs::is_directory(path)) path /= fs::path(r.input).filename().replace_extension();
    if (lower(path.extension().string()) == ending) path.replace_extension();
    std::string name = path.string();
    if (r.animated()) name += fmt::format("{:0{}}", frame, std::to_string(r.final_frame).size());
    return name + ending;
}

std::string state_name(const std::string& output_name) { return std::filesystem::path(output_name).replace_extension(".pov-state").string(); }

}  // namespace alidade
