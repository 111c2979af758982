// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/povray_reference.h"

#include "core/fingerprint.h"
#include "core/image.h"
#include "tools/compare/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace alidade {

namespace fs = std::filesystem;

namespace {

constexpr uint64_t kMostBytes = uint64_t(1) << 30;   // a folder that is larger is not one of scenes

tl::unexpected<RenderFailure> failure(bool reference, std::string sentence) { return tl::unexpected(RenderFailure{false, reference, std::move(sentence)}); }

fs::path folder_of(const std::string& scene) {
    const fs::path folder = fs::path(scene).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

bool same_folder(const fs::path& a, const std::string& b) {
    std::error_code ignored;
    return !b.empty() && fs::equivalent(a, b, ignored);
}

/// The files of a job below `folder`, sorted.
std::vector<fs::path> files_below(const PovJob& job, const fs::path& folder, bool& too_large) {
    std::vector<fs::path> files;
    uint64_t bytes = 0;
    std::error_code ignored;
    for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, ignored), end; at != end && bytes <= kMostBytes; at.increment(ignored)) {
        if (at->is_directory(ignored) && (same_folder(at->path(), job.cache) || same_folder(at->path(), job.results))) at.disable_recursion_pending();
        if (at->is_regular_file(ignored)) files.push_back(at->path()), bytes += at->file_size(ignored);
    }
    too_large = bytes > kMostBytes;
    std::sort(files.begin(), files.end());
    return files;
}

tl::expected<std::string, std::string> copied_folder(const PovJob& job, const std::string& scratch) {
    bool too_large = false;
    const fs::path from = folder_of(job.scene), to = fs::path(scratch) / "scene";
    const std::vector<fs::path> files = files_below(job, from, too_large);
    if (too_large) return tl::unexpected(fmt::format("the folder {} holds more than 1 GiB: a scene is rendered in a copy of its folder, so give it one of its own", from.string()));
    std::error_code error;
    for (const fs::path& file : files) {
        const fs::path copy = to / file.lexically_relative(from);
        fs::create_directories(copy.parent_path(), error);
        if (!fs::copy_file(file, copy, fs::copy_options::overwrite_existing, error)) return tl::unexpected(fmt::format("cannot copy {}: {}", file.string(), error.message()));
    }
    return to.string();
}

/// The picture that a program was asked for: under its name, or under that with the number of its only frame.
std::string produced(const std::string& output) {
    if (fs::exists(output)) return output;
    std::vector<std::string> found;
    const std::string stem = fs::path(output).stem().string();
    for (const auto& entry : fs::directory_iterator(fs::path(output).parent_path())) {
        const std::string name = entry.path().stem().string();
        const bool numbered = name.size() > stem.size() && name.rfind(stem, 0) == 0 && std::all_of(name.begin() + long(stem.size()), name.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (numbered && entry.path().extension() == ".png") found.push_back(entry.path().string());
    }
    return found.size() == 1 ? found[0] : "";
}

/// The line of a program's output that says what went wrong, else its last.
std::string complaint(const std::string& output) {
    std::string last, found;
    for (size_t begin = 0; begin < output.size();) {
        const size_t end = std::min(output.find('\n', begin), output.size());
        std::string line = output.substr(begin, end - begin);
        begin = end + 1;
        line.erase(std::remove_if(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }), line.end());
        if (line.find_first_not_of(' ') == line.npos) continue;
        last = line;
        if (found.empty() && (line.find("rror:") != line.npos || line.find("rror ") != line.npos)) found = line;
    }
    return found.empty() ? last : found;
}

tl::expected<Rendered, RenderFailure> render(const PovJob& job, const std::string& scratch, Words program, bool reference) {
    const auto folder = copied_folder(job, scratch);
    if (!folder) return failure(reference, folder.error());
    const std::string output = scratch + "/picture.png";
    for (const std::string& word : povray_words(job, output)) program.push_back(word);
    const auto run = run_program(program, *folder, job.timeout);
    if (!run) return failure(reference, run.error());
    const char* name = reference ? "POV-Ray" : "alidade";
    if (run->timed_out) return failure(reference, fmt::format("{} made no picture in {} s", name, job.timeout));
    const std::string picture = produced(output);
    if (run->exit_code != 0 || picture.empty()) return failure(reference, fmt::format("{} made no picture (exit code {}): {}", name, run->exit_code, complaint(run->output)));
    return Rendered{picture, std::move(program), run->cpu_seconds, false};
}

/// Kept beside the picture: the CPU seconds that it cost.
double kept_seconds(const std::string& path) {
    double seconds = 0;
    std::ifstream(path) >> seconds;
    return seconds;
}

void keep(const Rendered& rendered, const std::string& stem) {
    const std::string seconds = fmt::format("{}\n", rendered.cpu_seconds);
    const auto picture = read_file(rendered.picture);
    std::error_code ignored;
    fs::create_directories(fs::path(stem).parent_path(), ignored);
    // The picture last: what is there with its picture is whole. A cache that cannot be written costs time, nothing else.
    if (picture && write_file(stem + ".seconds", std::as_bytes(std::span(seconds)))) (void)write_file(stem + ".png", *picture).has_value();
}

}  // namespace

Words povray_words(const PovJob& job, const std::string& output) {
    Words words = job.words;
    for (const std::string& word : {"+I" + fs::path(job.scene).filename().string(), fmt::format("+W{}", job.width), fmt::format("+H{}", job.height)}) words.push_back(word);
    const bool antialiased = std::any_of(job.words.begin(), job.words.end(), [](const std::string& word) { return word.rfind("+A", 0) == 0 || word.rfind("+a", 0) == 0; });
    if (!antialiased) words.emplace_back("-A");
    for (const std::string& word : {std::string("+WT1"), std::string("-D"), std::string("-P"), std::string("+FN8"), "+O" + output}) words.push_back(word);
    return words;
}

tl::expected<std::string, std::string> reference_key(const PovJob& job) {
    uint64_t key = fingerprint(povray_version());
    for (const std::string& word : povray_words(job, "")) key = fingerprint(word + '\0', key);
    std::vector<fs::path> folders{folder_of(job.scene)};
    for (const std::string& word : job.words)
        if (word.size() > 2 && (word[0] == '+' || word[0] == '-') && (word[1] == 'L' || word[1] == 'l')) folders.push_back(folders[0] / word.substr(2));   // an absolute one stays as it is
    for (const fs::path& folder : folders) {
        bool too_large = false;
        for (const fs::path& file : files_below(job, folder, too_large)) {
            const auto bytes = read_file(file.string());
            if (!bytes) return tl::unexpected(bytes.error());
            key = fingerprint(std::span(*bytes), fingerprint(file.lexically_relative(folder).string() + '\0', key));
        }
        if (too_large) return tl::unexpected(fmt::format("the folder {} holds more than 1 GiB", folder.string()));
    }
    return fmt::format("{:016x}", key);
}

tl::expected<Rendered, RenderFailure> povray_reference(const PovJob& job, const std::string& scratch) {
    if (povray_version().empty()) return tl::unexpected(RenderFailure{true, true, "POV-Ray is not installed: its package is povray (and povray-includes)"});
    if (!fs::is_regular_file(job.scene)) return failure(true, fmt::format("there is no file {}", job.scene));
    const auto key = reference_key(job);
    if (!key) return failure(true, key.error());
    const std::string stem = fmt::format("{}/{}", job.cache, *key);
    if (fs::exists(stem + ".png")) {
        Words command{"povray"};
        for (const std::string& word : povray_words(job, "picture.png")) command.push_back(word);
        return Rendered{stem + ".png", std::move(command), kept_seconds(stem + ".seconds"), true};
    }
    auto rendered = render(job, scratch, {"povray"}, true);
    if (rendered) keep(*rendered, stem);
    return rendered;
}

tl::expected<Rendered, RenderFailure> povray_test(const PovJob& job, const std::string& scratch) { return render(job, scratch, {own_program(), "povray"}, false); }

const std::string& povray_version() {
    static const std::string version = [] {
        if (find_program("povray").empty()) return std::string();
        const auto run = run_program({"povray", "--version"}, ".", 20);
        constexpr std::string_view kName = "POV-Ray ";
        const size_t name = run ? run->output.find(kName) : std::string::npos;
        if (name == std::string::npos) return std::string("unknown");
        const size_t from = name + kName.size();
        return run->output.substr(from, run->output.find_first_of(" \n", from) - from);
    }();
    return version;
}

std::string default_cache() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    if (cache && *cache) return std::string(cache) + "/alidade/references";
    return home && *home ? std::string(home) + "/.cache/alidade/references" : (fs::temp_directory_path() / "alidade-references").string();
}

}  // namespace alidade
