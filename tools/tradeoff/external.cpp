// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/external.h"

#include "core/image_colors.h"
#include "tools/compare/program.h"
#include "tools/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

namespace alidade::tradeoff {

namespace fs = std::filesystem;

namespace {

/// Blanks separate; quotes, single or double, keep them.
Value<Words> split_words(const std::string& text) {
    Words words;
    char quote = 0;
    bool inside = false;
    for (const char c : text) {
        if (quote ? c == quote : c == '\'' || c == '"') {
            quote = quote ? char(0) : c;
            if (!std::exchange(inside, true)) words.emplace_back();
        } else if (!quote && (c == ' ' || c == '\t' || c == '\n')) {
            inside = false;
        } else {
            if (!std::exchange(inside, true)) words.emplace_back();
            words.back() += c;
        }
    }
    if (quote) return tl::unexpected(fmt::format("--external: '{}' has a quote that does not end", text));
    if (words.empty()) return tl::unexpected(std::string("--external: there is no command"));
    return words;
}

/// `word` with `fill` in place of each {placeholder}; a brace that begins none stays.
std::string filled(const std::string& word, const std::function<std::string(const std::string&)>& fill) {
    std::string out;
    for (size_t at = 0; at < word.size(); ++at) {
        const size_t close = word[at] == '{' ? word.find('}', at) : word.npos;
        if (close == word.npos) {
            out += word[at];
            continue;
        }
        out += fill(word.substr(at + 1, close - at - 1));
        at = close;
    }
    return out;
}

bool is_output(const std::string& name) { return name == "out" || name.starts_with("out."); }
bool is_axis(const std::string& name) { return name != "scene" && name != "folder" && name != "width" && name != "height" && !is_output(name); }

Words words_of(const External& external, const Setting& setting, const ExternalJob& job, const std::string& out) {
    const fs::path scene = fs::absolute(job.scene);
    const auto fill = [&](const std::string& name) -> std::string {
        for (const Choice& choice : setting)
            if (choice.name == name) return choice.value;
        if (name == "scene") return scene.string();
        if (name == "folder") return scene.parent_path().string();
        if (name == "width" || name == "height") return std::to_string(name == "width" ? job.width : job.height);
        return out + (name == "out" ? ".png" : name.substr(3));
    };
    Words words;
    for (const std::string& word : external.words) words.push_back(filled(word, fill));
    return words;
}

/// The only picture in the folder: its name may have got the number of a frame.
std::string made_in(const std::string& folder) {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with("out")) found.push_back(entry.path().string());
    return found.size() == 1 ? found[0] : "";
}

}  // namespace

Value<External> parse_external(const std::string& text) {
    auto words = split_words(text);
    if (!words) return tl::unexpected(words.error());
    External out{text, std::move(*words), {}};
    bool writes = false;
    for (const std::string& word : out.words)
        filled(word, [&](const std::string& name) {
            writes = writes || is_output(name);
            if (is_axis(name) && std::find(out.axes.begin(), out.axes.end(), name) == out.axes.end()) out.axes.push_back(name);
            return std::string();
        });
    if (!writes) return tl::unexpected(fmt::format("--external: '{}' does not say where {{out}}, the picture, goes", text));
    return out;
}

std::string command_line(const External& external, const Setting& setting, const ExternalJob& job, const std::string& out) {
    return shell_line(words_of(external, setting, job, out));
}

Value<ExternalRun> run_external(const External& external, const Setting& setting, const ExternalJob& job) {
    const ScratchFolder scratch;
    const Words words = words_of(external, setting, job, scratch.path() + "/out");
    const auto run = run_program(words, scratch.path(), job.timeout);
    if (!run) return tl::unexpected(run.error());
    const std::string line = shell_line(words);
    if (run->timed_out) return tl::unexpected(fmt::format("{} did not end in {} s", line, job.timeout));
    const std::string picture = made_in(scratch.path());
    if (run->exit_code != 0 || picture.empty()) return tl::unexpected(fmt::format("{} made no picture (exit code {}): {}", line, run->exit_code, complaint(run->output)));
    auto file = read_linear(picture);
    if (!file) return tl::unexpected(fmt::format("{}: {}", line, file.error()));
    return ExternalRun{std::move(file->picture), file->levels > 0, run->cpu_seconds};
}

Value<LinearFile> read_linear(const std::string& path) {
    const auto stored = read_stored_picture(path);
    if (!stored) return tl::unexpected(stored.error());
    const Picture& from = stored->picture;
    const std::vector<int> channels = color_channels(from);
    if (channels.empty()) return tl::unexpected(fmt::format("{} has no channels R, G, B or Y", path));
    const auto is_alpha = [&](int channel) { return from.names[size_t(channel)] == "A"; };
    const int alpha = is_alpha(channels.back()) ? channels.back() : -1, colors = int(channels.size()) - (alpha >= 0);
    const double gamma = stored->gamma > 0 && std::abs(stored->gamma - 1 / 2.2) > 0.01 ? stored->gamma : 0;   // 1 / 2.2 is what files say that mean sRGB
    LinearFile out{Picture(from.width, from.height, {"R", "G", "B"}), stored->levels};
    for (int y = 0; y < from.height; ++y)
        for (int x = 0; x < from.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const float* pixel = from.at(x, y);
                const double value = double(pixel[channels[size_t(colors == 1 ? 0 : c)]]);
                if (out.levels == 0) out.picture.at(x, y)[c] = float(value);
                else out.picture.at(x, y)[c] = float((gamma > 0 ? std::pow(value, 1 / gamma) : srgb_to_linear(value)) * (alpha >= 0 ? double(pixel[alpha]) : 1.0));
            }
    return out;
}

}  // namespace alidade::tradeoff
